#include "doctor/contact_symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "doctor/at_once.h"
#include "doctor/contact_block.h"
#include "doctor/contact_impact.h"
#include "doctor/suites.h"
#include "doctor/trial_values.h"

namespace similitude::doctor {
namespace {

constexpr std::size_t k_contacts = 64;
constexpr int k_steps = 6;   // so that springs are loaded and contacts have turned

/// Contacts of all sorts that move on for some steps: sliding and sticking, approaching and parting, with walls and with
/// other sizes. The same every time.
struct Contacts {
  std::vector<ContactRow> rows;
  std::vector<Vector> axes;   // about which a contact's normal turns

  explicit Contacts(bool rotates) {
    std::mt19937 random(1);
    const auto any = [&] { return 2.0 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1; };
    const auto share = [&] { return static_cast<double>(random()) / static_cast<double>(std::mt19937::max()); };
    const double radius = trial_bed().particle_diameter / 2;
    for (std::size_t n = 0; n < k_contacts; ++n) {
      ContactRow c;
      const Vector direction{any(), any(), any()};
      c.normal = (1 / std::sqrt(dot(direction, direction))) * direction;
      c.overlap = 0.02 * radius * share();
      const double speed = 0.5 * std::pow(10, -3 * share());   // [m/s]
      c.velocity = speed * Vector{any(), any(), any()};
      if (rotates) {
        c.spin_i = 100 * Vector{any(), any(), any()};
        c.spin_j = 100 * Vector{any(), any(), any()};
      }
      c.radius_i = radius * (0.5 + share());
      c.radius_j = n % 7 == 0 ? std::numeric_limits<double>::infinity() : radius;
      c.effective_mass = 0.5 * sphere_mass() * (0.5 + share());
      rows.push_back(c);
      axes.push_back(0.01 * Vector{any(), any(), any()});
    }
  }

  void move_on() {
    for (std::size_t n = 0; n < rows.size(); ++n) {
      const Vector turned = rows[n].normal + cross(axes[n], rows[n].normal);
      rows[n].normal = (1 / std::sqrt(dot(turned, turned))) * turned;
      rows[n].overlap *= 1.02;
      rows[n].velocity = 0.97 * rows[n].velocity;
    }
  }
};

/// [s]: a step that moves a tangential spring, a fraction of a contact.
double step_of(const ContactModel& law) {
  const double time = told_contact_time(law, {});
  return std::isfinite(time) && time > 0 ? time / 50 : 1e-6;
}

void fill(ContactBlock& block, const std::vector<ContactRow>& rows) {
  for (std::size_t n = 0; n < rows.size(); ++n) block.set(n, rows[n]);
}

double size(const Vector& v) { return std::sqrt(dot(v, v)); }

/// The same contact as its other partner sees it.
ContactRow swapped(const ContactRow& c) {
  ContactRow s = c;
  s.normal = -c.normal;
  s.velocity = -c.velocity;
  std::swap(s.spin_i, s.spin_j);
  std::swap(s.radius_i, s.radius_j);
  return s;
}

std::string text(const Vector& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

/// A third of a turn about the diagonal after a turn about z by 0.7: no axis stays where it was.
Vector turned(const Vector& v) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Vector about_z{c * v.x - s * v.y, s * v.x + c * v.y, v.z};
  return {about_z.z, about_z.x, about_z.y};
}

ContactRow turned(const ContactRow& c) {
  ContactRow t = c;
  t.normal = turned(c.normal);
  t.velocity = turned(c.velocity);
  t.spin_i = turned(c.spin_i);
  t.spin_j = turned(c.spin_j);
  return t;
}

constexpr double k_rounding = 1e-9;   // of some hundred operations, where large terms nearly cancel

bool same(const Vector& a, const Vector& b, double scale) { return size(a - b) <= k_rounding * scale; }

double radius_of(const ContactRow& c) { return std::min(c.radius_i, c.radius_j); }

}  // namespace

Outcome check_third_law(const PluginEntry& plugin) {
  const ContactModel law = made_contact(plugin);
  Contacts contacts(needs_of(law).rotation != 0);
  ContactBlock there(law, k_contacts), back(law, k_contacts);
  const double dt = step_of(law);
  for (int step = 0; step < k_steps; ++step, contacts.move_on()) {
    fill(there, contacts.rows);
    for (std::size_t n = 0; n < k_contacts; ++n) back.set(n, swapped(contacts.rows[n]));
    there.advance(dt);
    back.advance(dt);
    for (std::size_t n = 0; n < k_contacts; ++n) {
      if (std::isinf(contacts.rows[n].radius_j)) continue;   // a wall is never the first partner
      const ContactAnswer a = there.answer(n), b = back.answer(n);
      const double scale = std::max(size(a.force), size(b.force));
      if (!same(a.force, -b.force, scale))
        return fail(fmt::format("the partners feel {} N and {} N, which do not cancel.", text(a.force), text(b.force)),
                    "Swap i and j: normal and velocity change sign, radii and spins change places, and the force must change sign.");
      if (!same(a.couple, -b.couple, std::max(size(a.couple), scale * radius_of(contacts.rows[n]))))
        return fail(fmt::format("the partners feel the couples {} N m and {} N m, which do not cancel.", text(a.couple), text(b.couple)),
                    "The couple on i must be opposite to that on j: build it from spin_i - spin_j.");
    }
  }
  return ok(fmt::format("{} contacts over {} steps: swapped partners feel the opposite", k_contacts, k_steps));
}

Outcome check_parity(const PluginEntry& plugin) {
  const ContactModel law = made_contact(plugin);
  const similitude_contact_needs needs = needs_of(law);
  if (needs.history_count == 0) return skipped("it remembers nothing");
  Contacts contacts(needs.rotation != 0);
  ContactBlock there(law, k_contacts), back(law, k_contacts);
  const double dt = step_of(law);
  std::vector<double> largest(needs.history_count, 0);
  for (int step = 0; step < k_steps; ++step, contacts.move_on()) {
    fill(there, contacts.rows);
    for (std::size_t n = 0; n < k_contacts; ++n) back.set(n, swapped(contacts.rows[n]));
    there.advance(dt);
    back.advance(dt);
    for (std::uint32_t h = 0; h < needs.history_count; ++h)
      for (std::size_t n = 0; n < k_contacts; ++n) largest[h] = std::max(largest[h], std::abs(there.memory(n)[h]));
    for (std::size_t n = 0; n < k_contacts; ++n) {
      if (std::isinf(contacts.rows[n].radius_j)) continue;   // a wall is never the first partner
      for (std::uint32_t h = 0; h < needs.history_count; ++h) {
        const bool odd = needs.history_parity[h] == SIMILITUDE_ODD;
        const double a = there.memory(n)[h], b = back.memory(n)[h];
        if (std::abs(a - (odd ? -b : b)) <= k_rounding * largest[h]) continue;
        return fail(fmt::format("{} is declared {}, and is {:.6g} where the swapped contact has {:.6g}.", needs.history_name[h],
                                odd ? "odd" : "even", a, b),
                    "Odd: vectors of i relative to j, which change sign when the partners swap. Even: everything else.");
      }
    }
  }
  std::string names;
  for (std::uint32_t h = 0; h < needs.history_count; ++h)
    names += fmt::format("{}{} {}", h == 0 ? "" : ", ", needs.history_name[h], needs.history_parity[h] == SIMILITUDE_ODD ? "odd" : "even");
  return ok(names);
}

Outcome check_turned_space(const PluginEntry& plugin) {
  const ContactModel law = made_contact(plugin);
  Contacts contacts(needs_of(law).rotation != 0);
  ContactBlock straight(law, k_contacts), other(law, k_contacts);
  const double dt = step_of(law);
  for (int step = 0; step < k_steps; ++step, contacts.move_on()) {
    fill(straight, contacts.rows);
    for (std::size_t n = 0; n < k_contacts; ++n) other.set(n, turned(contacts.rows[n]));
    straight.advance(dt);
    other.advance(dt);
    for (std::size_t n = 0; n < k_contacts; ++n) {
      const ContactAnswer a = straight.answer(n), b = other.answer(n);
      const bool same_force = same(turned(a.force), b.force, size(a.force));
      const bool same_couple = same(turned(a.couple), b.couple, std::max(size(a.couple), size(a.force) * radius_of(contacts.rows[n])));
      if (!same_force || !same_couple)
        return fail(fmt::format("in turned space the {} is {}, and must be {}.", same_force ? "couple" : "force",
                                text(same_force ? b.couple : b.force), text(turned(same_force ? a.couple : a.force))),
                    "Build force and memory from vectors as wholes: no axis of space is special to a contact.");
    }
  }
  return ok(fmt::format("{} contacts over {} steps: force and memory turn with space", k_contacts, k_steps));
}

Outcome check_contact_edges(const PluginEntry& plugin) {
  const ContactModel law = made_contact(plugin);
  const Contacts contacts(needs_of(law).rotation != 0);
  for (const std::size_t rows : {std::size_t{8}, k_contacts}) {
    for (const Edge edge : {Edge::end, Edge::start}) {
      ContactBlock block(law, rows, edge);
      for (std::size_t n = 0; n < rows; ++n) block.set(n, contacts.rows[n]);
      block.forbid_writing();
      block.advance(step_of(law));
    }
  }
  return ok("blocks of 8 and 64 rows between forbidden pages, inputs write-protected");
}

namespace {

/// Where the answers of row n of `a` and row m of `b` differ in a bit, in words; empty if nowhere.
std::string difference(const ContactBlock& a, std::size_t n, const ContactBlock& b, std::size_t m) {
  const ContactAnswer x = a.answer(n), y = b.answer(m);
  const auto bits = [](const Vector& u, const Vector& v) { return u.x == v.x && u.y == v.y && u.z == v.z; };
  if (!bits(x.force, y.force)) return fmt::format("the force is {} N and {} N", text(x.force), text(y.force));
  if (a.needs().couple != 0 && !bits(x.couple, y.couple)) return fmt::format("the couple is {} N m and {} N m", text(x.couple), text(y.couple));
  for (std::uint32_t h = 0; h < a.needs().history_count; ++h)
    if (a.memory(n)[h] != b.memory(m)[h]) return fmt::format("{} is {:.17g} and {:.17g}", a.needs().history_name[h], a.memory(n)[h], b.memory(m)[h]);
  return "";
}

const char* const k_row_alone = "A row's answer may depend on that row alone, not on its place or its neighbours.";

}  // namespace

Outcome check_contact_split(const PluginEntry& plugin) {
  const ContactModel law = made_contact(plugin);
  Contacts contacts(needs_of(law).rotation != 0);
  const double dt = step_of(law);
  constexpr std::size_t part = 16, stride = 29;   // prime to the count: every row once, in another order
  ContactBlock whole(law, k_contacts);
  std::vector<ContactBlock> parts;
  for (std::size_t p = 0; p < k_contacts / part; ++p) parts.emplace_back(law, part);
  for (int step = 0; step < k_steps; ++step, contacts.move_on()) {
    fill(whole, contacts.rows);
    whole.advance(dt);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      for (std::size_t n = 0; n < part; ++n) parts[p].set(n, contacts.rows[(p * part + n) * stride % k_contacts]);
      parts[p].advance(dt);
      for (std::size_t n = 0; n < part; ++n)
        if (const std::string words = difference(whole, (p * part + n) * stride % k_contacts, parts[p], n); !words.empty())
          return fail("in one block and in parts of it " + words + ".", k_row_alone);
    }
  }
  return ok(fmt::format("{} rows over {} steps give the same bits in one block and in shuffled blocks of {}", k_contacts, k_steps, part));
}

Outcome check_contact_pairs(const PluginEntry& plugin) {
  const similitude_descriptor& model = *plugin.descriptor;
  if (model.parameter_count == 0) return skipped("it has no parameters that pairs of materials could differ in");
  constexpr std::uint32_t sets = 3;
  std::vector<similitude_value> values;
  for (std::uint32_t set = 0; set < sets; ++set)
    for (const similitude_value& value : moved_values(model, 0.3 + 0.2 * set)) values.push_back(value);
  const ContactModel law = create_model<similitude_contact_functions>(plugin, trial_bed(), values, sets);
  Contacts contacts(needs_of(law).rotation != 0);
  for (std::size_t n = 0; n < k_contacts; ++n) contacts.rows[n].pair = static_cast<std::uint32_t>(n * n) % sets;
  ContactBlock mixed(law, k_contacts, Edge::far, true);
  std::vector<ContactBlock> alone;
  for (std::uint32_t set = 0; set < sets; ++set) alone.emplace_back(law, k_contacts, Edge::far, true);
  const double dt = step_of(law);
  for (int step = 0; step < k_steps; ++step, contacts.move_on()) {
    fill(mixed, contacts.rows);
    mixed.advance(dt);
    for (std::uint32_t set = 0; set < sets; ++set) {
      std::vector<ContactRow> rows = contacts.rows;
      for (ContactRow& row : rows) row.pair = set;
      fill(alone[set], rows);
      alone[set].advance(dt);
      for (std::size_t n = 0; n < k_contacts; ++n) {
        if (contacts.rows[n].pair != set) continue;
        if (const std::string words = difference(mixed, n, alone[set], n); !words.empty())
          return fail("with other pairs of materials in the block and without " + words + ".",
                      "Take each row's parameters from the set that block->pair names.");
      }
    }
  }
  return ok("3 pairs of materials mixed in a block give what each gives alone");
}

Outcome check_contact_threads(const PluginEntry& plugin) {
  constexpr std::size_t threads = 4;
  constexpr int rounds = 500;
  const ContactModel law = made_contact(plugin);
  const Contacts contacts(needs_of(law).rotation != 0);
  const double dt = step_of(law);
  ContactBlock alone(law, k_contacts);
  fill(alone, contacts.rows);
  alone.advance(dt);
  std::vector<ContactBlock> blocks;
  for (std::size_t t = 0; t < threads; ++t) {
    blocks.emplace_back(law, k_contacts);
    for (std::size_t n = 0; n < k_contacts; ++n) blocks[t].set(n, contacts.rows[(n + t * k_contacts / threads) % k_contacts]);
  }
  std::vector<std::string> words(threads);
  const std::vector<std::string> thrown = at_once(threads, [&](std::size_t t) {
    for (int round = 0; round < rounds && words[t].empty(); ++round) {
      for (std::size_t n = 0; n < k_contacts; ++n) blocks[t].forget(n);
      blocks[t].advance(dt);
      for (std::size_t n = 0; n < k_contacts && words[t].empty(); ++n)
        words[t] = difference(alone, (n + t * k_contacts / threads) % k_contacts, blocks[t], n);
    }
  });
  for (std::size_t t = 0; t < threads; ++t) {
    const std::string& word = thrown[t].empty() ? words[t] : thrown[t];
    if (!word.empty())
      return fail("when 4 threads ask at once " + word + ".",
                  "Keep nothing between calls, in the model or in statics: several threads call one model at once.");
  }
  return ok(fmt::format("4 threads at once, {} answers, the same bits as one", threads * rounds * k_contacts));
}

}  // namespace similitude::doctor
