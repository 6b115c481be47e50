#pragma once
/// All that the author of a contact law includes. A law is a type with
///
///   template <class V> Force<V> force(const Contact<V>&) const;                normal forces, memoryless friction
///   template <class V> Force<V> force(const Contact<V>&, History<V>&) const;   with memory, e.g. a tangential spring
///
/// one of them, or both where the law can do without memory (see remembers). V is `double` or a Pack of contacts; use
/// select() instead of `if`. [worker]: the law must not change itself. What a law may add:
///
///   static void parameters(Parameters<Law>&);           its parameters
///   void prepare();  void prepare(const Bed&);          once the parameters are in
///   static constexpr HistoryValue history[] = {...};    what a contact remembers
///   bool remembers() const;                             false: these parameters need no memory; force(contact) is called
///   bool rotates() const;                               do tangential forces turn the particles? default: if it remembers
///   static constexpr bool couple = true;                the law fills Force::couple
///   double contact_time(double effective_mass, double effective_radius, double speed) const;          [s]
///   double largest_stable_step(double effective_mass, double effective_radius, double speed) const;   [s]
///   double reach(double diameter) const;                [m], contacts begin at this gap; default 0
///
/// Without contact_time and largest_stable_step a head-on impact is played through (impact.h). What any of these throws
/// ends the start of the run with its own words.

#include <algorithm>

#include <similitude/contact_block.h>
#include <similitude/impact.h>

namespace similitude {

/// The boundary's functions for one law type. All [setup] but `forces`.
template <class Law>
struct ContactTable {
  static_assert(
      requires(const Law& law, const Contact<Pack>& c) { law.force(c); } ||
          requires(const Law& law, const Contact<Pack>& c, History<Pack>& h) { law.force(c, h); },
      "a contact law has force(const Contact<V>&) or force(const Contact<V>&, History<V>&)");
  static constexpr bool without_memory = requires(const Law& law, const Contact<Pack>& c) { law.force(c); };
  static constexpr bool with_memory =
      requires(const Law& law, const Contact<Pack>& c, History<Pack>& h) { law.force(c, h); };
  static_assert(with_memory == has_history<Law>, "force(contact, history) and `history` belong together");

  static bool any_remembers(const void* model) {
    return !without_memory || std::ranges::any_of(sets_of<Law>(model), [](const Law& law) { return remembers(law); });
  }

  /// What `needs` asks the laws is asked once here, where a refusal still has words.
  static void* create(const similitude_host* host, const similitude_bed* bed, const similitude_value* values,
                      std::uint32_t sets, similitude_status* status) noexcept {
    return create_and_ask<Law>(host, bed, values, sets, status, [](const Law& law) {
      rotates(law);
      remembers(law);
    });
  }

  static void needs(const void* model, similitude_contact_needs* out) noexcept {
    similitude_contact_needs n{};
    n.struct_size = out->struct_size;
    n.rotation = std::ranges::any_of(sets_of<Law>(model), [](const Law& law) { return rotates(law); }) ? 1 : 0;
    n.couple = has_couple<Law>() ? 1 : 0;
    if constexpr (has_history<Law>) {
      if (any_remembers(model)) {
        for (const HistoryValue& value : Law::history) {
          n.history_parity[n.history_count] = static_cast<std::int32_t>(value.parity);
          n.history_name[n.history_count] = value.name;
          n.history_unit[n.history_count] = value.unit;
          ++n.history_count;
        }
      }
    }
    std::memcpy(static_cast<void*>(out), &n, std::min<std::size_t>(out->struct_size, sizeof n));
  }

  static void forces(const void* model, const similitude_contact_block* block, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      const std::vector<Law>& laws = sets_of<Law>(model);
      if constexpr (!with_memory) {
        contact_forces<Law, false>(laws, *block);
      } else if constexpr (!without_memory) {
        contact_forces<Law, true>(laws, *block);
      } else if (block->history[0]) {
        contact_forces<Law, true>(laws, *block);
      } else {
        contact_forces<Law, false>(laws, *block);
      }
    });
  }

  static double contact_time(const void* model, std::uint32_t pair, double mass, double radius, double speed) noexcept {
    return number_or_nan<Law>(model, "contact_time", [&]() -> double {
      const Law& law = sets_of<Law>(model)[pair];
      if constexpr (requires { law.contact_time(mass, radius, speed); }) {
        return law.contact_time(mass, radius, speed);
      } else {
        return head_on_impact(law, mass, radius, speed).duration;
      }
    });
  }

  static double largest_stable_step(const void* model, std::uint32_t pair, double mass, double radius,
                                    double speed) noexcept {
    return number_or_nan<Law>(model, "largest_stable_step", [&]() -> double {
      const Law& law = sets_of<Law>(model)[pair];
      if constexpr (requires { law.largest_stable_step(mass, radius, speed); }) {
        return law.largest_stable_step(mass, radius, speed);
      } else {
        return largest_stable_step_of(head_on_impact(law, mass, radius, speed));
      }
    });
  }

  static double reach(const void* model, double diameter) noexcept {
    return number_or_nan<Law>(model, "reach", [&]() -> double {
      double farthest = 0;
      if constexpr (requires(const Law& law) { law.reach(diameter); }) {
        for (const Law& law : sets_of<Law>(model)) farthest = std::max(farthest, law.reach(diameter));
      }
      return farthest;
    });
  }

  static constexpr similitude_contact_functions functions = {
      sizeof(similitude_contact_functions), 0, &needs, &forces, &contact_time, &largest_stable_step, &reach};
};

template <class Law>
similitude_descriptor contact_law(const About& about) {
  similitude_descriptor d = describe_model<Law>("contact", &ContactTable<Law>::functions, about);
  d.create = &ContactTable<Law>::create;
  return d;
}

}  // namespace similitude

/// SIMILITUDE_CONTACT_LAW(Law, id, version, title [, authors [, reference]])
#define SIMILITUDE_CONTACT_LAW(Law, ...) SIMILITUDE_PLUGIN(similitude::contact_law<Law>({__VA_ARGS__}))
