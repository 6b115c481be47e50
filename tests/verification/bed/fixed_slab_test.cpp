#include <gtest/gtest.h>

#include <numbers>

#include <fmt/format.h>

#include "drag_probe.h"
#include "small_bed.h"

namespace similitude::test {
namespace {

constexpr double k_diameter = 1e-3;          // [m]
constexpr double k_gas_density = 1.225;      // [kg/m^3]
constexpr double k_gas_viscosity = 1.79e-5;  // [Pa s]
constexpr int k_across = 4, k_high = 30;     // cells
constexpr int k_slab_from = 6, k_slab_to = 24;

/// A cubic lattice, two spheres per cell edge, so heavy that the gas does not move it.
ParticleStore heavy_lattice(double pitch) {
  ParticleStore particles({.rotation = false, .coupling = true});
  constexpr double k_immovable = 1e9;   // [kg/m^3]
  const double mass = k_immovable * std::numbers::pi / 6 * k_diameter * k_diameter * k_diameter;
  std::uint64_t id = 0;
  for (int k = 2 * k_slab_from; k < 2 * k_slab_to; ++k) {
    for (int j = 0; j < 2 * k_across; ++j) {
      for (int i = 0; i < 2 * k_across; ++i) {
        particles.add(id++, 0, pitch * (i + 0.5), pitch * (j + 0.5), pitch * (k + 0.5), k_diameter / 2, mass);
      }
    }
  }
  return particles;
}

}  // namespace

// physics.md B4: dp/L = beta u_s / eps with beta = n K, u_s = U / eps (model A), for any drag law.
struct SlabCase {
  const char* drag;
  double pitch_over_diameter;
};
class FixedSlab : public testing::TestWithParam<SlabCase> {};

TEST_P(FixedSlab, HasTheClosedFormPressureDropOfItsDragLaw) {
  const SlabCase& slab = GetParam();
  const double pitch = slab.pitch_over_diameter * k_diameter;
  const double cell = 2 * pitch;
  const double gas_fraction =
      1 - std::numbers::pi / 6 / (slab.pitch_over_diameter * slab.pitch_over_diameter * slab.pitch_over_diameter);
  const double slip = 1.0;   // [m/s]
  const std::string yaml = fmt::format(R"(
similitude: 1
title: gas through a slab of fixed spheres
scene:
  domain:    {{size: [{0:.17g} m, {0:.17g} m, {1:.17g} m], cell: {2:.17g} m}}
  periodic:  [x, y]
  gravity:   [0 m/s^2, 0 m/s^2, 0 m/s^2]
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{sphere: {{diameter: 1 mm, density: 1e9 kg/m^3}}}}
  bed:       {{fill: none}}
  patches:
    inlet:  {{face: bottom, velocity: {3:.17g} m/s, ramp: 5 ms}}
    outlet: {{face: top, pressure: 0 Pa}}
models:
  drag: {4}
  contact: {{id: linear_spring, stiffness: 1e6 N/m, restitution: 0.9, friction: 0}}
  fluid: vans
  scaling: exact
time: {{end: 1 s, dt: 1e-4 s}}
)",
                                       k_across * cell, k_high * cell, cell, gas_fraction * slip, slab.drag);
  ParticleStore particles = heavy_lattice(pitch);
  const auto bed = small_bed(yaml, &particles);
  while (bed->simulation->time() < 0.05) bed->simulation->step();

  const auto& pressure = bed->simulation->gas().pressure;
  const Grid& grid = *bed->assembly->grid;
  // Well inside: the smoothing length is three diameters, 1.5 cells or less.
  const int low = k_slab_from + 4, high = k_slab_to - 5;
  const double measured = (pressure[grid.cell(1, 1, low)] - pressure[grid.cell(1, 1, high)]) / ((high - low) * cell);
  const double beta = exchange_coefficient(bed->assembly->drag, k_diameter, k_gas_density, k_gas_viscosity, gas_fraction, slip) / (pitch * pitch * pitch);
  const double expected = beta * slip / gas_fraction;
  EXPECT_NEAR(measured, expected, 0.01 * expected);
}

INSTANTIATE_TEST_SUITE_P(DragLaws, FixedSlab,
                         testing::Values(SlabCase{"syamlal_obrien", 1.0}, SlabCase{"syamlal_obrien", 1.15},
                                         SlabCase{"syamlal_obrien", 1.5}, SlabCase{"gidaspow", 1.0}, SlabCase{"gidaspow", 1.15},
                                         SlabCase{"gidaspow", 1.5}, SlabCase{"schiller_naumann", 1.0},
                                         SlabCase{"schiller_naumann", 1.15}, SlabCase{"schiller_naumann", 1.5}),
                         [](const auto& info) {
                           return fmt::format("{}_pitch_{}", info.param.drag,
                                              static_cast<int>(100 * info.param.pitch_over_diameter));
                         });

}  // namespace similitude::test
