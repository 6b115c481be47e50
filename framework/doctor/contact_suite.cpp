#include <fmt/format.h>
#include <similitude/restitution.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "doctor/contact_block.h"
#include "doctor/contact_impact.h"
#include "doctor/contact_symmetry.h"
#include "doctor/suites.h"
#include "doctor/trial_values.h"

namespace similitude::doctor {
namespace {

constexpr double k_wall = std::numeric_limits<double>::infinity();
constexpr int k_steps_per_contact = 1000;
constexpr double k_longest_contact = 30;   // [contact times], beyond which partners stick

/// Asked over sizes and speeds, before anything is built on the answer.
Outcome check_setup_functions(const PluginEntry& plugin) {
  const ContactModel law = made_contact(plugin);
  double least = k_wall, most = 0;
  for (const double ratio : {1.0, 3.0, k_wall}) {
    for (const double speed : {1e-3, 0.1, 1.0, 10.0}) {
      const ImpactStart start{.speed = speed, .radius_ratio = ratio};
      const double time = told_contact_time(law, start), step = told_stable_step(law, start);
      const std::string where = fmt::format("for an effective mass of {:.3g} kg, a radius of {:.3g} m and a speed of {:g} m/s",
                                            effective_mass(start), effective_radius(start), speed);
      if (!(time > 0)) return fail(fmt::format("contact_time is {:g} s {}.", time, where), "It is a duration: above zero, or infinite where partners never part.");
      if (!(step > 0)) return fail(fmt::format("largest_stable_step is {:g} s {}.", step, where), "It is a limit of the time step, above zero.");
      if (!(step < time))
        return fail(fmt::format("largest_stable_step is {:.3g} s {}, as long as the whole contact, {:.3g} s.", step, where, time),
                    "An explicit step must be shorter than the contact: a linear spring's limit is 2/w0, its contact pi/w0.");
      least = std::min(least, time);
      most = std::max(most, time);
    }
  }
  const double reach = reach_of(law, trial_bed().particle_diameter);
  if (!(reach >= 0) || !std::isfinite(reach))
    return fail(fmt::format("reach is {:g} m for a diameter of {:g} m.", reach, trial_bed().particle_diameter), "It is a gap, zero or above.");
  return ok(fmt::format("contact times {:.3g} to {:.3g} s, reach {:g} m for 1 mm", least, most, reach));
}

/// From the largest gap in reach to a twentieth of a diameter, at rest and fast.
Outcome check_finite(const PluginEntry& plugin) {
  const ContactModel law = made_contact(plugin);
  const double diameter = trial_bed().particle_diameter, reach = reach_of(law, diameter);
  ContactBlock block(law, SIMILITUDE_ROW_MULTIPLE);
  int asked = 0;
  for (const double overlap : {-0.999 * reach, 0.0, 1e-12 * diameter, 1e-6 * diameter, 1e-3 * diameter, 0.05 * diameter}) {
    for (const Vector& velocity : {Vector{0, 0, 0}, Vector{-10, 0, 0}, Vector{10, 0, 0}, Vector{0, 10, 0}, Vector{-1e-12, 1e-12, 0}}) {
      for (const double ratio : {1.0, k_wall}) {
        ContactRow c;
        c.overlap = overlap + 0.0;   // no negative zero
        c.velocity = velocity;
        c.radius_i = diameter / 2;
        c.radius_j = ratio * c.radius_i;
        c.effective_mass = effective_mass({.radius_ratio = ratio});
        block.set(0, c);
        for (std::size_t n = 0; n < block.rows(); ++n) block.forget(n);
        block.advance(1e-6);
        const ContactAnswer a = block.answer(0);
        ++asked;
        const double sum = a.force.x + a.force.y + a.force.z + a.couple.x + a.couple.y + a.couple.z;
        if (!std::isfinite(sum))
          return fail(fmt::format("the force is not finite at an overlap of {:g} m and a velocity of ({:g}, {:g}, {:g}) m/s, {}.", c.overlap,
                                  velocity.x, velocity.y, velocity.z, std::isinf(ratio) ? "on a wall" : "of two spheres"),
                      "Keep zero overlap, zero velocity and infinite radii (a flat wall) out of denominators and roots.");
      }
    }
  }
  return ok(fmt::format("{} contacts from a gap of {:g} m to a twentieth of a diameter, at rest and at 10 m/s", asked, reach));
}

Outcome check_pushes_apart(const PluginEntry& plugin) {
  const ContactModel law = made_contact(plugin);
  const double diameter = trial_bed().particle_diameter;
  ContactBlock block(law, SIMILITUDE_ROW_MULTIPLE);
  ContactRow c;
  c.overlap = 0.05 * diameter;   // where a simulation warns
  c.radius_i = c.radius_j = diameter / 2;
  c.effective_mass = effective_mass({});
  block.set(0, c);
  block.advance(1e-6);
  const double force = block.answer(0).force.x;
  if (!(force > 0))
    return fail(fmt::format("two spheres at rest that overlap by a twentieth of a diameter feel {:g} N along the normal.", force),
                "The normal points from j to i: the force on i is along +normal where it pushes the partners apart.");
  return ok(fmt::format("{:.3g} N between two spheres at rest that overlap by a twentieth of a diameter", force));
}

bool can_be_played(double time) { return std::isfinite(time) && time > 0; }
const char* const k_no_time = "its contact time is not a finite time";

std::vector<ImpactStart> many_impacts() {
  std::vector<ImpactStart> starts;
  for (const double ratio : {1.0, 2.0, k_wall})
    for (const double degrees : {0.0, 20.0, 45.0, 70.0})
      for (const double spin : {0.0, 1.0, -1.0})
        starts.push_back({.speed = 0.5, .angle = degrees * k_pi / 180, .spin = spin, .radius_ratio = ratio});
  return starts;
}

/// Semi-implicit Euler at a thousand steps a contact returns a linear spring's energy to 2e-3; a gain beyond 1e-2 is the law's.
Outcome check_energy(const PluginEntry& plugin) {
  constexpr double tolerance = 0.01;
  const ContactModel law = made_contact(plugin);
  const double time = told_contact_time(law, {.speed = 0.5});
  if (!can_be_played(time)) return skipped(k_no_time);
  const std::vector<ImpactStart> starts = many_impacts();
  const double dt = std::min(time / k_steps_per_contact, told_stable_step(law, {.speed = 0.5}) / 50);
  const std::vector<ImpactEnd> ends = play(law, starts, dt, k_longest_contact * time);
  double least = 1, most = 0;
  int stuck = 0;
  for (std::size_t n = 0; n < ends.size(); ++n) {
    if (!ends[n].parted) {
      ++stuck;
      continue;
    }
    if (!(ends[n].energy_ratio <= 1 + tolerance))
      return fail(fmt::format("an impact at {:g} m/s and {:.0f} degrees {} ends with {:.4g} times its energy.", starts[n].speed,
                              starts[n].angle * 180 / k_pi, std::isinf(starts[n].radius_ratio) ? "on a wall" : "of two spheres", ends[n].energy_ratio),
                  "Damping must act against the motion, in the normal and in the tangential direction, and friction against the slip.");
    least = std::min(least, ends[n].energy_ratio);
    most = std::max(most, ends[n].energy_ratio);
  }
  return ok(fmt::format("{} impacts of spheres and walls keep {:.3g} to {:.3g} of their energy{}", ends.size() - static_cast<std::size_t>(stuck), least, most,
                        stuck == 0 ? "" : fmt::format("; {} stick", stuck)));
}

/// Parameters that declare themselves coefficients of restitution are measured; half a step's phase error is 1e-3.
Outcome check_restitution(const PluginEntry& plugin) {
  constexpr double tolerance = 0.01;
  const similitude_descriptor& model = *plugin.descriptor;
  std::vector<std::uint32_t> places;
  for (std::uint32_t p = 0; p < model.parameter_count; ++p)
    if (model.parameters[p].scales_as == SIMILITUDE_SCALES_AS_RESTITUTION) places.push_back(p);
  if (places.empty()) return skipped("no parameter says that it scales as a restitution");
  std::string measured;
  for (const double wanted : {0.5, 0.7, 0.9, 1.0}) {
    std::vector<similitude_value> values = trial_values(model);
    bool inside = true;
    for (const std::uint32_t p : places) {
      inside = inside && wanted >= model.parameters[p].minimum && wanted <= model.parameters[p].maximum;
      values[p].real = wanted;
    }
    if (!inside) continue;
    const ContactModel law = create_model<similitude_contact_functions>(plugin, trial_bed(), values);
    const ImpactStart pair{.speed = 0.5}, wall{.speed = 0.5, .radius_ratio = k_wall};
    const double time = told_contact_time(law, wall);
    if (!can_be_played(time)) return skipped(k_no_time);
    const double dt = std::min(told_contact_time(law, pair) / k_steps_per_contact, time / k_steps_per_contact);
    for (const ImpactEnd& end : play(law, {pair, wall}, dt, k_longest_contact * time)) {
      if (end.parted && std::abs(end.restitution - wanted) <= tolerance) continue;
      return fail(end.parted ? fmt::format("a head-on impact at 0.5 m/s with a restitution of {:g} rebounds with {:.4g}.", wanted, end.restitution)
                             : fmt::format("a head-on impact at 0.5 m/s with a restitution of {:g} does not rebound.", wanted),
                  "Take the damping from the restitution and the pair's effective mass: similitude::damping_ratio() in restitution.h.");
    }
    measured += fmt::format("{}{:g}", measured.empty() ? "" : ", ", wanted);
  }
  return ok(measured.empty() ? "no value to try lies within the declared range" : "rebounds with " + measured + ", of two spheres and on a wall, within 0.01");
}

Outcome check_contact_time(const PluginEntry& plugin) {
  constexpr double tolerance = 0.05;   // of the time: it sets the number of steps per contact, 20
  const ContactModel law = made_contact(plugin);
  std::string told;
  for (const double speed : {0.05, 0.5, 5.0}) {
    for (const double ratio : {1.0, k_wall}) {
      const ImpactStart start{.speed = speed, .radius_ratio = ratio};
      const double time = told_contact_time(law, start);
      if (!can_be_played(time)) return skipped(k_no_time);
      const double dt = std::min(time / k_steps_per_contact, told_stable_step(law, start) / 50);
      const ImpactEnd end = play(law, {start}, dt, k_longest_contact * time).front();
      if (!end.parted) return fail(fmt::format("it tells {:.3g} s for an impact at {:g} m/s, which does not end within 30 times that.", time, speed),
                                   "contact_time is the duration of a head-on impact; leave it out, and the SDK plays one.");
      const auto agrees = [&](double seen) { return std::abs(seen - time) <= tolerance * time; };
      if (!agrees(end.force_time) && !agrees(end.overlap_time))
        return fail(fmt::format("it tells {:.4g} s for an impact at {:g} m/s, which lasts {:.4g} s.", time, speed, end.overlap_time),
                    "contact_time is the duration of a head-on impact; leave it out, and the SDK plays one.");
    }
  }
  return ok("head-on impacts at 0.05, 0.5 and 5 m/s last as long as told, within 5 %");
}

/// A contact that is pressed to half the depth of an impact and disturbed by a hundredth must not swing ever wider at 0.95
/// of the step it calls stable. An undamped spring may swing by 1/sqrt(1 - 0.95^2) = 3.2 of that.
Outcome check_stable_step(const PluginEntry& plugin) {
  constexpr double share = 0.95, disturbance = 0.01, most_growth = 10;
  constexpr int steps = 500;
  const ContactModel law = made_contact(plugin);
  double widest = 0;
  for (const double ratio : {1.0, k_wall}) {
    const ImpactStart start{.speed = 0.5, .radius_ratio = ratio};
    const double time = told_contact_time(law, start);
    if (!can_be_played(time)) return skipped(k_no_time);
    const ImpactEnd end = play(law, {start}, time / k_steps_per_contact, k_longest_contact * time).front();
    const double dt = share * told_stable_step(law, start), mass = effective_mass(start);
    ContactBlock block(law, SIMILITUDE_ROW_MULTIPLE);
    ContactRow c;
    c.radius_i = trial_bed().particle_diameter / 2;
    c.radius_j = ratio * c.radius_i;
    c.effective_mass = mass;
    c.overlap = end.deepest / 2;
    const double rest = c.overlap;
    block.set(0, c);
    block.advance(dt);
    const double load = block.answer(0).force.x;
    for (std::size_t n = 0; n < block.rows(); ++n) block.forget(n);
    c.overlap = (1 + disturbance) * rest;
    for (int step = 0; step < steps; ++step) {
      block.set(0, c);
      block.advance(dt);
      c.velocity.x += dt * (block.answer(0).force.x - load) / mass;
      c.overlap -= dt * c.velocity.x;
      const double swing = std::abs(c.overlap - rest) / (disturbance * rest);
      widest = std::max(widest, swing);
      if (!(swing <= most_growth))
        return fail(fmt::format("at 0.95 of the step it calls stable, {:.3g} s, a pressed contact swings ever wider: {:.3g} times after {} steps.",
                                told_stable_step(law, start), swing, step + 1),
                    "In a packed bed a linear spring-dashpot's limit is (sqrt(1 + 4 zeta^2) - 2 zeta)/w0: similitude::stable_step_in_a_bed() in restitution.h.");
    }
  }
  return ok(fmt::format("at 0.95 of it a pressed contact swings by {:.2g} times its disturbance at most, over 500 steps", widest));
}

}  // namespace

std::vector<Check> contact_suite() {
  return {{"stays in its columns", check_contact_edges},
          {"finite", check_finite, true},
          {"pushes apart", check_pushes_apart, true},
          {"Newton's third law", check_third_law},
          {"parity of its memory", check_parity},
          {"turned space", check_turned_space},
          {"block split", check_contact_split, true},
          {"set-up functions", check_setup_functions},
          {"no energy gained", check_energy},
          {"restitution", check_restitution},
          {"contact time", check_contact_time},
          {"largest stable step", check_stable_step},
          {"pairs of materials", check_contact_pairs},
          {"threads", check_contact_threads}};
}

}  // namespace similitude::doctor
