#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "record.h"
#include "small_bed.h"

namespace similitude::test {
namespace {

constexpr double k_diameter = 1e-3, k_density = 1040, k_edge = 0.02;   // [m], [kg/m^3], [m]

/// A loose cloud without overlaps: a lattice with jitter, moving at up to 1 m/s with a net drift.
ParticleStore cloud(int per_edge) {
  ParticleStore particles({.rotation = true, .coupling = true});
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double pitch = k_edge / per_edge;
  const double jitter = (pitch - k_diameter) / 2;
  const double mass = k_density * std::numbers::pi / 6 * k_diameter * k_diameter * k_diameter;
  std::uint64_t id = 0;
  for (int k = 0; k < per_edge; ++k) {
    for (int j = 0; j < per_edge; ++j) {
      for (int i = 0; i < per_edge; ++i) {
        const std::size_t row =
            particles.add(id++, 0, pitch * (i + 0.5) + jitter * unit(random), pitch * (j + 0.5) + jitter * unit(random),
                          pitch * (k + 0.5) + jitter * unit(random), k_diameter / 2, mass);
        particles.velocity[row].x = 0.5 + unit(random);
        particles.velocity[row].y = unit(random);
        particles.velocity[row].z = -0.7 + unit(random);
      }
    }
  }
  return particles;
}

/// Changes of total momentum over 500 gas steps, and what the gas and the particles exchanged meanwhile [kg m/s].
struct Balance {
  std::array<double, 3> change{};
  double exchanged = 0;
};

Balance balance_of(const std::string& momentum) {
  ParticleStore particles = cloud(13);
  const auto bed = small_bed(fmt::format(R"(
similitude: 1
title: a cloud of spheres in a periodic box
scene:
  domain:    {{size: [20 mm, 20 mm, 20 mm], cell: 2.5 mm}}
  periodic:  [x, y, z]
  gravity:   [0 m/s^2, 0 m/s^2, 0 m/s^2]
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{alumina: {{diameter: 1 mm, density: 1040 kg/m^3}}}}
  bed:       {{fill: none}}
models:
  drag: gidaspow
  contact: {{id: linear_spring, stiffness: 500 N/m, restitution: 0.74, friction: 0.2}}
  fluid: {{id: vans, momentum: {}}}
  scaling: exact
time: {{end: 1 s, dt: 3e-6 s, gas_dt: 6e-5 s}}
)",
                                         momentum),
                             &particles);
  Simulation& simulation = *bed->simulation;
  simulation.step();
  const auto before = simulation.momentum();
  const double gas_before = simulation.gas_report().momentum[2];
  for (int step = 0; step < 500; ++step) simulation.step();
  const auto after = simulation.momentum();
  Balance balance;
  balance.exchanged = std::abs(simulation.gas_report().momentum[2] - gas_before);
  for (std::size_t axis = 0; axis < 3; ++axis) balance.change[axis] = after[axis] - before[axis];
  return balance;
}

}  // namespace

// A closed system: what the gas loses the particles gain, to rounding, collisions and pressure included.
class PeriodicBox : public testing::TestWithParam<const char*> {};

TEST_P(PeriodicBox, KeepsTheMomentumOfGasParticlesAndRemainder) {
  const Balance balance = balance_of(GetParam());
  ASSERT_GT(balance.exchanged, 1e-8);   // [kg m/s]: the gas has been dragged along
  Worst worst;   // [-]
  for (std::size_t axis = 0; axis < 3; ++axis) {
    worst.see(balance.change[axis] / balance.exchanged);
    EXPECT_NEAR(balance.change[axis], 0, 1e-12 * balance.exchanged) << "axis " << axis;
  }
  record({fmt::format("momentum of gas and particles in a periodic box, {}", GetParam()), "constant", fmt::format("{:.1g} of what was exchanged", worst.value), ""});
}

INSTANTIATE_TEST_SUITE_P(Models, PeriodicBox, testing::Values("model_a", "model_b"),
                         [](const auto& info) { return std::string(info.param); });

// The equations as printed give the gas eps grad p and nobody the rest: what the test above measures is lost.
TEST(PeriodicBoxAsPrinted, LosesMomentum) {
  const Balance balance = balance_of("as_printed");
  double largest = 0;
  for (const double change : balance.change) largest = std::max(largest, std::abs(change));
  EXPECT_GT(largest, 1e-6 * balance.exchanged);
}

}  // namespace similitude::test
