#pragma once
/// The paper's alumina in a laterally periodic column under a slow ramp of gas.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "drag_probe.h"
#include "small_bed.h"

namespace similitude::test {

constexpr double k_diameter = 1e-3, k_density = 1040, k_gas_density = 1.225, k_gas_viscosity = 1.79e-5, k_gravity = 9.81;
constexpr double k_edge = 6e-3;        // [m], laterally periodic

/// A bed and the ramp of gas through it.
struct RampCase {
  std::string drag = "gidaspow", fluid = "vans";
  int count = 2400;          // a bed of 58 diameters, so that its looser ends weigh little
  double full_speed = 0.50;  // [m/s], at the end of the ramp
  double ramp = 1.5;         // [s]

  double velocity(double time) const { return full_speed * std::min(time / ramp, 1.0); }   // [m/s], superficial
  /// [Pa], of the particles, less their buoyancy, over the cross-section.
  double weight() const {
    return count * std::numbers::pi / 6 * k_diameter * k_diameter * k_diameter * (k_density - k_gas_density) * k_gravity /
           (k_edge * k_edge);
  }
};

inline std::string bed_case(const RampCase& ramp) {
  return fmt::format(R"(
similitude: 1
title: a laterally periodic bed under a slow ramp of gas
scene:
  domain:    {{size: [6 mm, 6 mm, 120 mm], cell: 2 mm}}
  periodic:  [x, y]
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{alumina: {{diameter: 1 mm, density: 1040 kg/m^3, count: {}}}}}
  bed:       {{fill: settle, cache: false}}
  patches:
    inlet:  {{face: bottom, velocity: {} m/s, ramp: {} s}}
    outlet: {{face: top, pressure: 0 Pa}}
models:
  drag: {}
  contact: {{id: linear_spring, stiffness: 100 N/m, restitution: 0.74, friction: 0.2}}
  fluid: {}
  scaling: exact
time: {{end: 2 s, dt: auto}}
)",
                     ramp.count, ramp.full_speed, ramp.ramp, ramp.drag, ramp.fluid);
}

/// Volume mean of the gas fraction between 10 and 90 % of the bed's height.
inline double mean_gas_fraction(const SmallBed& bed, double height) {
  const Grid& grid = *bed.assembly->grid;
  const auto& fraction = bed.simulation->exchange().gas_fraction;
  double sum = 0, volume = 0;
  for (int k = 0; k < grid.cells(2); ++k) {
    const double low = std::max(k * grid.spacing(2), 0.1 * height), high = std::min((k + 1) * grid.spacing(2), 0.9 * height);
    if (high <= low) continue;
    for (int j = 0; j < grid.cells(1); ++j) {
      for (int i = 0; i < grid.cells(0); ++i) {
        sum += (high - low) * fraction[grid.cell(i, j, k)];
        volume += high - low;
      }
    }
  }
  return sum / volume;
}

/// beta/phi [kg/(m^3 s)] of the law under test.
inline double exchange_per_volume(const DragModel& drag, double gas_fraction, double slip_speed) {
  return exchange_coefficient(drag, k_diameter, k_gas_density, k_gas_viscosity, gas_fraction, slip_speed) /
         (std::numbers::pi / 6 * k_diameter * k_diameter * k_diameter);
}

}  // namespace similitude::test
