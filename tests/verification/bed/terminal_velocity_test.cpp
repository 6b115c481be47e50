#include <gtest/gtest.h>

#include "record.h"
#include "small_bed.h"

namespace similitude::test {
// Single sphere, Schiller-Naumann, by bisection: alumina of 1 mm in air 3.943726 m/s; 0.1 mm, 2000 kg/m^3 (MFIX DEM06)
// 0.457536 m/s at g = 9.81.
struct FallCase {
  const char* name;
  double diameter, density, gas_density, gas_viscosity, velocity, fall_time, width, height;
};

class FallingSphere : public testing::TestWithParam<FallCase> {};

TEST_P(FallingSphere, ReachesItsTerminalVelocity) {
  const FallCase& fall = GetParam();
  auto text = [](double value) { return std::to_string(value * 1e6) + "e-6"; };
  const std::string yaml = R"(
similitude: 1
title: one sphere falling
scene:
  domain:    {size: [)" + text(fall.width) + " m, " + text(fall.width) + " m, " + text(fall.height) + R"( m],
              cell: [)" + text(fall.width / 4) + " m, " + text(fall.width / 4) + " m, " + text(fall.height / 40) + R"( m]}
  gas:       {density: )" + text(fall.gas_density) + R"( kg/m^3, viscosity: )" + text(fall.gas_viscosity) + R"( Pa s}
  particles: {sphere: {diameter: )" + text(fall.diameter) + R"( m, density: )" + text(fall.density) + R"( kg/m^3}}
  bed:       {fill: none}
models:
  drag: schiller_naumann
  contact: {id: linear_spring, stiffness: 1e-3 N/m, restitution: 0.9, friction: 0}
  fluid: prescribed
  scaling: exact
time: {end: 10 s, dt: 1e-4 s, gas_dt: 1e-4 s}
)";
  ParticleStore particles({.rotation = false, .coupling = true});
  const double volume = 3.14159265358979323846 / 6 * fall.diameter * fall.diameter * fall.diameter;
  particles.add(0, 0, fall.width / 2, fall.width / 2, 0.99 * fall.height, fall.diameter / 2, fall.density * volume);
  const auto bed = small_bed(yaml, &particles);
  while (bed->simulation->time() < fall.fall_time) bed->simulation->step();
  EXPECT_NEAR(-bed->simulation->particles().velocity[0].z, fall.velocity, 1e-3 * fall.velocity);
  record({"terminal velocity of a sphere", "Schiller & Naumann, bisection",
          percent(std::abs(-bed->simulation->particles().velocity[0].z / fall.velocity - 1)), ""});
  EXPECT_NEAR(bed->simulation->particles().velocity[0].x, 0, 1e-12 * fall.velocity);
}

INSTANTIATE_TEST_SUITE_P(Refvalues, FallingSphere,
                         testing::Values(FallCase{"alumina", 1e-3, 1040, 1.225, 1.79e-5, 3.943726, 5.0, 0.04, 40},
                                         FallCase{"glass", 1e-3, 2500, 1.225, 1.79e-5, 6.793291, 5.0, 0.04, 40},
                                         FallCase{"mfix_dem06", 1e-4, 2000, 1.2, 1.8e-5, 0.457536, 0.6, 0.002, 0.4}),
                         [](const auto& info) { return info.param.name; });

}  // namespace similitude::test
