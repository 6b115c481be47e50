#pragma once
/// A contact law over a block of contacts: the loop that a plugin compiles with its law inside.

#include <cstdint>
#include <type_traits>
#include <vector>

#include <similitude/contact.h>
#include <similitude/plugin.h>

namespace similitude {

/// Does the law declare history at all?
template <class Law>
inline constexpr bool has_history = requires { Law::history; };

template <class Law>
constexpr std::uint32_t history_count() {
  if constexpr (has_history<Law>) {
    static_assert(std::size(Law::history) <= SIMILITUDE_MAX_HISTORY, "too many history values");
    return static_cast<std::uint32_t>(std::size(Law::history));
  } else {
    return 0;
  }
}

template <class Law>
constexpr bool has_couple() {
  if constexpr (requires { Law::couple; }) {
    return Law::couple;
  } else {
    return false;
  }
}

/// Does a contact of this parameter set remember anything? A law may say no, e.g. without friction.
template <class Law>
bool remembers(const Law& law) {
  if constexpr (requires { law.remembers(); }) {
    return law.remembers();
  } else {
    return has_history<Law>;
  }
}

/// Must the particles have angular velocity? By default if the law remembers (a tangential spring) or has a couple.
template <class Law>
bool rotates(const Law& law) {
  if constexpr (requires { law.rotates(); }) {
    return law.rotates();
  } else {
    return has_couple<Law>() || remembers(law);
  }
}

inline Contact<Pack> contact_at(const similitude_contact_block& block, std::size_t row) {
  Contact<Pack> c;
  c.dt = block.dt;
  c.normal = load(block.normal, row);
  c.overlap = load(block.overlap, row);
  const Vec3<Pack> velocity = load(block.velocity, row);
  c.normal_velocity = dot(velocity, c.normal);
  c.tangential_velocity = velocity - c.normal_velocity * c.normal;
  c.radius_i = load(block.radius_i, row);
  c.radius_j = load(block.radius_j, row);
  c.effective_mass = load(block.effective_mass, row);
  const Vec3<Pack> none = {Pack(0), Pack(0), Pack(0)};
  c.angular_velocity_i = block.angular_velocity_i[0] ? load(block.angular_velocity_i, row) : none;
  c.angular_velocity_j = block.angular_velocity_j[0] ? load(block.angular_velocity_j, row) : none;
  return c;
}

/// Rows of several material pairs may share a pack: the law is evaluated over the full width once per distinct pair and
/// each row takes its own. There is one call of the law in the source, so that a row's bits depend neither on its
/// neighbours nor on its place. Flattened: the law's own functions become part of the loop, or its packs would lie on the stack.
template <class Law, bool Remembering>
[[gnu::flatten]] void contact_forces(const std::vector<Law>& laws, const similitude_contact_block& block) {
  constexpr std::size_t values = Remembering ? history_count<Law>() : 0;
  constexpr std::size_t width = Pack::size();
  for (std::size_t row = 0; row < block.rows; row += width) {
    const Contact<Pack> c = contact_at(block, row);
    Pack before[values + 1], after[values + 1];   // one more, since a law may have none
    for (std::size_t k = 0; k < values; ++k) before[k] = after[k] = load(block.history[k], row);
    const std::uint32_t* pair = block.pair ? block.pair + row : nullptr;
    const Pack pairs([pair](auto lane) { return pair ? static_cast<double>(pair[lane]) : 0.0; });
    Force<Pack> total{{Pack(0), Pack(0), Pack(0)}};
    Mask open(true);   // rows without their force yet
    do {
      const std::uint32_t set = pair ? pair[find_first_set(open)] : 0;
      const Mask here = pairs == static_cast<double>(set);
      Force<Pack> one;
      if constexpr (Remembering) {
        History<Pack> memory;
        for (std::size_t k = 0; k < values; ++k) memory.value[k] = before[k];
        one = laws[set].force(c, memory);
        for (std::size_t k = 0; k < values; ++k) after[k] = select(here, memory.value[k], after[k]);
      } else {
        one = laws[set].force(c);
      }
      total.force = select(here, one.force, total.force);
      if constexpr (has_couple<Law>()) total.couple = select(here, one.couple, total.couple);
      open = open && !here;
    } while (any_of(open));
    store(total.force, block.force, row);
    if constexpr (has_couple<Law>()) {
      if (block.couple[0]) store(total.couple, block.couple, row);
    }
    for (std::size_t k = 0; k < values; ++k) store(after[k], block.history[k], row);
  }
}

}  // namespace similitude
