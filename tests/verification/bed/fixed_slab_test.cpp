#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include <fmt/format.h>

#include "drag_probe.h"
#include "record.h"
#include "small_bed.h"

namespace similitude::test {
namespace {

constexpr double k_diameter = 1e-3;          // [m]
constexpr double k_gas_density = 1.225;      // [kg/m^3]
constexpr double k_gas_viscosity = 1.79e-5;  // [Pa s]
constexpr int k_across = 4, k_high = 30;     // cells
constexpr int k_slab_from = 6, k_slab_to = 24;

double gas_fraction_at(double pitch) {
  const double spheres_per_length = k_diameter / pitch;
  return 1 - std::numbers::pi / 6 * (spheres_per_length * spheres_per_length * spheres_per_length);
}

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

/// Spheres that overlap, in lattices denser than theirs, hardly push: the spring is soft beside their mass.
std::string slab_case(double pitch, double superficial_velocity, const std::string& drag, const std::string& fluid) {
  return fmt::format(R"(
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
  contact: {{id: linear_spring, stiffness: 1 N/m, restitution: 0.9, friction: 0}}
  fluid: {5}
  scaling: exact
time: {{end: 1 s, dt: 1e-4 s}}
)",
                     k_across * 2 * pitch, k_high * 2 * pitch, 2 * pitch, superficial_velocity, drag, fluid);
}

std::unique_ptr<SmallBed> steady_slab(double pitch, double superficial_velocity, const std::string& drag, const std::string& fluid) {
  ParticleStore particles = heavy_lattice(pitch);
  auto bed = small_bed(slab_case(pitch, superficial_velocity, drag, fluid), &particles);
  while (bed->simulation->time() < 0.05) bed->simulation->step();
  return bed;
}

// Well inside: the smoothing length is three diameters, 1.5 cells or less.
constexpr int k_inside_from = k_slab_from + 4, k_inside_to = k_slab_to - 5;

/// [Pa/m]
double pressure_gradient(const SmallBed& bed) {
  const auto& pressure = bed.simulation->gas().pressure;
  const Grid& grid = *bed.assembly->grid;
  return (pressure[grid.cell(1, 1, k_inside_from)] - pressure[grid.cell(1, 1, k_inside_to)]) /
         ((k_inside_to - k_inside_from) * grid.spacing(2));
}

/// dp/L = beta u_s / eps with beta = n K, u_s = U / eps (model A), for any drag law.
double closed_form(const SmallBed& bed, double pitch, double slip) {
  const double gas_fraction = gas_fraction_at(pitch);
  const double beta = exchange_coefficient(bed.assembly->drag, k_diameter, k_gas_density, k_gas_viscosity, gas_fraction, slip) /
                      (pitch * pitch * pitch);
  return beta * slip / gas_fraction;
}

/// [N/m^3], per volume of a sphere inside the slab: drag and stress on it less the weight of the paper's alumina in gas.
double net_lift(const SmallBed& bed, double pitch) {
  constexpr double k_alumina = 1040, k_gravity = 9.81;   // [kg/m^3], [m/s^2]
  const ParticleStore& particles = bed.simulation->particles();
  double lift = 0;
  int count = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const double z = particles.position[p].z / (2 * pitch);
    if (z < k_inside_from || z > k_inside_to) continue;
    const double drag = particles.gas[p].w * (particles.gas[p].z - particles.velocity[p].z);
    lift += (drag + particles.stress_force[p].z) / (std::numbers::pi / 6 * (k_diameter * k_diameter * k_diameter));
    ++count;
  }
  return lift / count - (k_alumina - k_gas_density) * k_gravity;
}

}  // namespace

struct SlabCase {
  const char* drag;
  double pitch_over_diameter;
  const char* fluid = "vans";
};
class FixedSlab : public testing::TestWithParam<SlabCase> {};

TEST_P(FixedSlab, HasTheClosedFormPressureDropOfItsDragLaw) {
  const SlabCase& slab = GetParam();
  const double pitch = slab.pitch_over_diameter * k_diameter;
  const double slip = 1.0;   // [m/s]
  const auto bed = steady_slab(pitch, gas_fraction_at(pitch) * slip, slab.drag, slab.fluid);
  const double expected = closed_form(*bed, pitch, slip);
  const double gradient = pressure_gradient(*bed);
  EXPECT_NEAR(gradient, expected, 0.01 * expected);
  record({"pressure drop of a slab of fixed spheres", "closed form of the drag law", percent(std::abs(gradient / expected - 1)), ""});
}

/// "gidaspow_pitch_150"
std::string name_of(const testing::TestParamInfo<SlabCase>& info) {
  return fmt::format("{}_pitch_{}", info.param.drag, static_cast<int>(100 * info.param.pitch_over_diameter));
}

INSTANTIATE_TEST_SUITE_P(DragLaws, FixedSlab,
                         testing::Values(SlabCase{"syamlal_obrien", 1.0}, SlabCase{"syamlal_obrien", 1.15},
                                         SlabCase{"syamlal_obrien", 1.5}, SlabCase{"gidaspow", 1.0}, SlabCase{"gidaspow", 1.15},
                                         SlabCase{"gidaspow", 1.5}, SlabCase{"schiller_naumann", 1.0},
                                         SlabCase{"schiller_naumann", 1.15}, SlabCase{"schiller_naumann", 1.5}),
                         name_of);

// Model B carries the same load through the same slab: beta/eps in the drag, 1 instead of eps before the gradient.
INSTANTIATE_TEST_SUITE_P(ModelB, FixedSlab,
                         testing::Values(SlabCase{"gidaspow", 1.0, "{id: vans, momentum: model_b}"},
                                         SlabCase{"gidaspow", 1.5, "{id: vans, momentum: model_b}"},
                                         SlabCase{"syamlal_obrien", 1.15, "{id: vans, momentum: model_b}"}),
                         name_of);

// Without inertia the same load: nothing else acts in a uniform bed.
INSTANTIATE_TEST_SUITE_P(Porous, FixedSlab,
                         testing::Values(SlabCase{"gidaspow", 1.0, "porous"}, SlabCase{"gidaspow", 1.5, "porous"},
                                         SlabCase{"syamlal_obrien", 1.15, "porous"}),
                         name_of);

// The velocity at which the paper's alumina, packed at a gas fraction of 0.4328, is just weightless under Ergun's drag.
// 0.3600 m/s with the pressure gradient on the particles, 0.6530 m/s as printed, without.
struct Weightless {
  const char* name;
  const char* fluid;
  double velocity;   // [m/s]
};
class MinimumFluidization : public testing::TestWithParam<Weightless> {};

TEST_P(MinimumFluidization, OfAUniformBedIsWhereItsNetForceVanishes) {
  const double pitch = k_diameter * std::cbrt(std::numbers::pi / 6 / (1 - 0.4328));
  const std::string fluid = GetParam().fluid;
  const auto lift_at = [&](double velocity) { return net_lift(*steady_slab(pitch, velocity, "gidaspow", fluid), pitch); };
  double before = 0.3, now = 0.7;
  double lift_before = lift_at(before), lift = lift_at(now);
  for (int iteration = 0; iteration < 8 && std::abs(now - before) > 1e-4 * now; ++iteration) {
    const double next = now - lift * (now - before) / (lift - lift_before);   // secant
    before = now;
    lift_before = lift;
    now = next;
    lift = lift_at(now);
  }
  EXPECT_NEAR(now, GetParam().velocity, 0.01 * GetParam().velocity);
  record({"velocity at which a uniform bed is weightless", "closed form (Ergun)", percent(std::abs(now / GetParam().velocity - 1)), ""});
  std::printf("  %s: weightless at %.4f m/s\n", GetParam().name, now);
}

INSTANTIATE_TEST_SUITE_P(Models, MinimumFluidization,
                         testing::Values(Weightless{"model_a", "vans", 0.3600},
                                         Weightless{"model_b", "{id: vans, momentum: model_b}", 0.3600},
                                         Weightless{"as_printed", "{id: vans, momentum: as_printed}", 0.6530},
                                         Weightless{"porous", "porous", 0.3600}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace similitude::test
