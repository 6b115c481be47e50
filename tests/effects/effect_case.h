#pragma once
/// One or a few spheres in a box under an effect, placed by hand.

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "small_bed.h"

namespace similitude::test {

inline constexpr double k_pi = 3.14159265358979323846;

struct Placed {
  std::array<double, 3> place{}, velocity{}, spin{};   // [m], [m/s], [rad/s]
};

/// A case with one class of spheres.
struct EffectCase {
  double diameter = 1e-3, density = 2500;                   // [m], [kg/m^3]
  double gas_density = 1e-9, gas_viscosity = 1e-12;         // [kg/m^3], [Pa s]: as good as none
  std::string gravity = "9.81 m/s^2";
  std::string contact = "{id: linear_spring, stiffness: 1000 N/m, restitution: 0.5, friction: 0.5}";
  std::string fluid = "prescribed";
  std::string effects = "[]";
  double dt = 1e-6;                                         // [s]
  int sub_steps = 1;                                        // per gas step
  double edge = 0.04;                                       // [m], of the box

  std::string yaml() const {
    return fmt::format(R"(
similitude: 1
title: effect
scene:
  domain:    {{size: [{0} m, {0} m, {0} m], cell: {1} m}}
  gas:       {{density: {2} kg/m^3, viscosity: {3} Pa s}}
  particles: {{ball: {{diameter: {4} m, density: {5} kg/m^3}}}}
  gravity:   {6}
  bed:       {{fill: none}}
models: {{drag: schiller_naumann, contact: {7}, fluid: {8}, scaling: exact, effects: {9}}}
time: {{end: 1 s, dt: {10} s, gas_dt: {11} s}}
)",
                       edge, edge / 4, gas_density, gas_viscosity, diameter, density, gravity, contact, fluid, effects, dt, sub_steps * dt);
  }
  double mass() const { return density * k_pi / 6 * diameter * diameter * diameter; }

  std::unique_ptr<SmallBed> with(const std::vector<Placed>& balls) const {
    const Assembly assembly = assemble(case_of(yaml()).scene, built_plugins());
    ParticleStore particles(store_fields(assembly));
    for (const Placed& ball : balls) {
      const std::size_t row =
          particles.add(particles.size(), 0, ball.place[0], ball.place[1], ball.place[2], diameter / 2, mass());
      particles.velocity[row] = {ball.velocity[0], ball.velocity[1], ball.velocity[2], mass()};
      if (particles.fields.rotation) {
        Row& spin = particles.angular_velocity[row];
        spin = {ball.spin[0], ball.spin[1], ball.spin[2], spin.w};
      }
    }
    return small_bed(yaml(), &particles);
  }
};

inline void run_until(SmallBed& bed, double time) {
  while (bed.simulation->time() < time) bed.simulation->step();
}

/// An effect alone, with parameters by name: numbers, or the text of a choice.
inline EffectModel effect_model(const std::string& id, const std::map<std::string, double>& numbers = {},
                                const std::map<std::string, std::string>& choices = {}) {
  const PluginEntry& plugin = *built_plugins().find("effect", id);
  std::vector<similitude_value> values;
  for (std::uint32_t p = 0; p < plugin.descriptor->parameter_count; ++p) {
    const similitude_parameter& row = plugin.descriptor->parameters[p];
    const auto number = numbers.find(row.name);
    const auto choice = choices.find(row.name);
    values.push_back({number != numbers.end() ? number->second : row.default_value,
                      choice != choices.end() ? choice->second.c_str() : row.default_text});
  }
  return create_model<similitude_effect_functions>(plugin, similitude_bed{}, values);
}

}  // namespace similitude::test
