#include <gtest/gtest.h>

#include <cmath>

#include "small_bed.h"

namespace similitude::test {
namespace {

// A jet between plates, where a gas without inertia is wrong but must stay tame.
constexpr const char* k_spout = R"(
similitude: 1
title: a small spouted bed with draft plates
scene:
  domain:    {size: [30 mm, 6 mm, 90 mm], cell: 3 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles: {alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 3000}}
  bed:       {fill: settle, cache: false}
  patches:
    spout:      {face: bottom, x: [12 mm, 18 mm], velocity: 6 m/s, ramp: 10 ms}
    background: {face: bottom, rest: true, velocity: 0.2 m/s, ramp: 10 ms}
    outlet:     {face: top, pressure: 0 Pa}
  baffles:   {plates: {at_x: [9 mm, 21 mm], z: [9 mm, 30 mm], thickness: 1 mm}}
models:
  drag: syamlal_obrien
  contact: {id: linear_spring, stiffness: 200 N/m, restitution: 0.74, friction: 0.2}
  fluid: porous
  scaling: exact
time: {end: 0.1 s, dt: auto}
)";

}  // namespace

TEST(PorousSpout, StaysFiniteAndThrowsParticlesUp) {
  const auto bed = small_bed(k_spout);
  for (const TimeStepLimit& limit : bed->steps.limits) EXPECT_NE(limit.name, "gas CFL");
  double largest_courant = 0, highest = 0;
  while (bed->simulation->time() < 0.1) {
    bed->simulation->step();   // throws if a guard trips
    largest_courant = std::max(largest_courant, bed->simulation->gas_report().courant);
    EXPECT_LT(bed->simulation->gas_report().mass_residual, 1.1e-6);
  }
  for (const Row& velocity : bed->simulation->particles().velocity) ASSERT_TRUE(std::isfinite(velocity.x + velocity.y + velocity.z));
  for (const double pressure : bed->simulation->gas().pressure) ASSERT_TRUE(std::isfinite(pressure));
  for (const Row& position : bed->simulation->particles().position) highest = std::max(highest, position.z);
  EXPECT_GT(highest, 1.2 * bed->filled.height);
  EXPECT_TRUE(bed->warnings.empty()) << bed->warnings.front();
  std::printf("  largest Courant number %.2f, bed %.1f mm, highest particle %.1f mm\n", largest_courant, 1e3 * bed->filled.height,
              1e3 * highest);
}

}  // namespace similitude::test
