#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "drag_probe.h"
#include "small_bed.h"

namespace similitude::test {
namespace {

constexpr double k_diameter = 1e-3, k_density = 1040, k_gas_density = 1.225, k_gas_viscosity = 1.79e-5, k_gravity = 9.81;
constexpr double k_edge = 6e-3;        // [m], laterally periodic
constexpr double k_full_speed = 0.50;  // [m/s], at the end of the ramp
constexpr double k_ramp = 1.5;         // [s]
constexpr int k_count = 2400;          // a bed of 58 diameters, so that its looser ends weigh little

std::string bed_case(const std::string& drag, const std::string& fluid) {
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
                     k_count, k_full_speed, k_ramp, drag, fluid);
}

/// Pressure at the inlet face above the outlet's: mean of the lowest cells, carried half a cell on with the gradient there.
double pressure_drop(const SmallBed& bed) {
  const Grid& grid = *bed.assembly->grid;
  const auto& pressure = bed.simulation->gas().pressure;
  double lowest = 0, second = 0;
  const int nx = grid.cells(0), ny = grid.cells(1);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      lowest += pressure[grid.cell(i, j, 0)] / (nx * ny);
      second += pressure[grid.cell(i, j, 1)] / (nx * ny);
    }
  }
  return lowest + (lowest - second) / 2;
}

/// Volume mean of the gas fraction between 10 and 90 % of the bed's height.
double mean_gas_fraction(const SmallBed& bed, double height) {
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
double exchange_per_volume(const DragModel& drag, double gas_fraction, double slip_speed) {
  return exchange_coefficient(drag, k_diameter, k_gas_density, k_gas_viscosity, gas_fraction, slip_speed) /
         (std::numbers::pi / 6 * k_diameter * k_diameter * k_diameter);
}

/// The drag law's own u_mf [m/s]: (beta/phi) phi U / eps^2 = phi (rho_p - rho_f) g (physics.md B4), by bisection.
double minimum_fluidization_velocity(const DragModel& drag, double gas_fraction) {
  double low = 0, high = 5;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    const double carried = exchange_per_volume(drag, gas_fraction, middle / gas_fraction) * middle / (gas_fraction * gas_fraction);
    (carried < (k_density - k_gas_density) * k_gravity ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

struct Ramp {
  const char* drag;
  const char* fluid;
};
class SlowRamp : public testing::TestWithParam<Ramp> {};

TEST_P(SlowRamp, FindsTheDragLawsMinimumFluidizationVelocityAndCarriesTheBed) {
  const auto bed = small_bed(bed_case(GetParam().drag, GetParam().fluid));
  ASSERT_GE(bed->filled.height, 40 * k_diameter);
  const double weight = k_count * std::numbers::pi / 6 * k_diameter * k_diameter * k_diameter *
                        (k_density - k_gas_density) * k_gravity / (k_edge * k_edge);   // [Pa]

  // Fixed bed: dp = a U + b U^2 by least squares over the lower part of the ramp, where nothing moves yet.
  double uu = 0, uuu = 0, uuuu = 0, pu = 0, puu = 0;
  double gas_fraction_sum = 0;
  int fixed_samples = 0;
  double plateau = 0;
  int plateau_samples = 0;
  while (bed->simulation->time() < k_ramp) {
    bed->simulation->step();
    const double velocity = k_full_speed * std::min(bed->simulation->time() / k_ramp, 1.0);
    const double drop = pressure_drop(*bed);
    if (drop > 0.1 * weight && drop < 0.7 * weight && plateau_samples == 0) {
      const double u = velocity;
      uu += u * u;
      uuu += u * u * u;
      uuuu += u * u * u * u;
      pu += drop * u;
      puu += drop * u * u;
      gas_fraction_sum += mean_gas_fraction(*bed, bed->filled.height);
      ++fixed_samples;
    }
    if (velocity > 0.42) {
      plateau += drop;
      ++plateau_samples;
    }
  }
  ASSERT_GT(fixed_samples, 100);
  ASSERT_GT(plateau_samples, 100);
  plateau /= plateau_samples;
  EXPECT_NEAR(plateau, weight, 0.02 * weight);

  const double determinant = uu * uuuu - uuu * uuu;
  const double a = (pu * uuuu - puu * uuu) / determinant, b = (puu * uu - pu * uuu) / determinant;
  const double crossing = (-a + std::sqrt(a * a + 4 * b * plateau)) / (2 * b);
  const double gas_fraction = gas_fraction_sum / fixed_samples;
  const double expected = minimum_fluidization_velocity(bed->assembly->drag, gas_fraction);
  EXPECT_NEAR(crossing, expected, 0.05 * expected);
  RecordProperty("u_mf", fmt::format("{:.4f}", crossing));
  std::printf("  %s in %s: u_mf %.4f m/s at eps %.4f; the law's own %.4f; plateau %.1f Pa of %.1f Pa\n", GetParam().drag,
              GetParam().fluid, crossing, gas_fraction,
              expected, plateau, weight);
}

INSTANTIATE_TEST_SUITE_P(DragLaws, SlowRamp, testing::Values(Ramp{"syamlal_obrien", "vans"}, Ramp{"gidaspow", "vans"}, Ramp{"gidaspow", "porous"}),
                         [](const auto& info) { return fmt::format("{}_{}", info.param.drag, info.param.fluid); });

}  // namespace similitude::test
