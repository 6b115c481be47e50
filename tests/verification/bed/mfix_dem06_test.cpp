// MFIX DEM06: a sphere of 0.1 mm released in air that rises at 0.4 m/s. Schiller & Naumann's drag, g = 9.80665 m/s^2. The reference
// is a fourth-order integration of its equation of motion (MFIX 21.3.2, tests/dem/DEM06).
#include <array>
#include <cmath>

#include "record.h"
#include "small_bed.h"

namespace similitude::test {
namespace {

constexpr double k_diameter = 1e-4, k_density = 2000;   // [m], [kg/m^3]
// [s], [m/s] in the laboratory, of MFIX's AUTOTEST/POST_VEL.dat.
constexpr std::array<std::array<double, 2>, 7> k_velocities{{{0.01, -0.01255261}, {0.02, -0.02238662}, {0.03, -0.03008038},
                                                             {0.04, -0.03609337}, {0.05, -0.04078891}, {0.07, -0.04731164},
                                                             {0.35, -0.05739251}}};

double worst_error(const std::string& fluid, const char* smoothing) {
  const auto yaml = fmt::format(R"(
similitude: 1
title: one sphere in rising air
scene:
  domain:    {{size: [4 mm, 4 mm, 48 mm], cell: 1 mm}}
  periodic:  [x, y]
  gravity:   9.80665 m/s^2
  gas:       {{density: 1.2 kg/m^3, viscosity: 1.8e-5 Pa s}}
  particles: {{sphere: {{diameter: 0.1 mm, density: 2000 kg/m^3}}}}
  bed:       {{fill: none}}
  patches:
    inlet:  {{face: bottom, velocity: 0.4 m/s, ramp: 0 s}}
    outlet: {{face: top, pressure: 0 Pa}}
models:
  drag: schiller_naumann
  contact: {{id: linear_spring, stiffness: 1 N/m, restitution: 0.9, friction: 0}}
  fluid: {}
  scaling: exact
coupling: {{smoothing: {}}}
time: {{end: 1 s, dt: 5e-6 s, gas_dt: 1e-4 s}}
)",
                                fluid, smoothing);
  ParticleStore particles({.rotation = false, .coupling = true});
  const double volume = 3.14159265358979323846 / 6 * k_diameter * k_diameter * k_diameter;
  particles.add(0, 0, 2.2e-3, 2.2e-3, 40e-3, k_diameter / 2, k_density * volume);
  const auto bed = small_bed(yaml, &particles);
  double worst = 0;   // of the final velocity
  for (const auto& [time, velocity] : k_velocities) {
    while (bed->simulation->time() < time * (1 - 1e-9)) bed->simulation->step();
    const double ours = bed->simulation->particles().velocity[0].z;
    std::printf("  t %.2f s: %.6f m/s, reference %.6f\n", time, ours, velocity);
    worst = std::max(worst, std::abs(ours - velocity) / std::abs(k_velocities.back()[1]));
  }
  return worst;
}

}  // namespace

TEST(MfixDem06, OneWayTheSphereFollowsItsEquationOfMotion) {
  const double error = worst_error("{id: prescribed, velocity_z: 0.4 m/s}", "3 mm");
  EXPECT_LT(error, 0.002);   // dt g over the final velocity is 0.09 %: first order in time, and once more for the gas step's K
  record({"drag and gravity on a sphere, one-way", "MFIX DEM06, integrated equation", percent(error), "MFIX 0.005 %"});
}

// Two-way the sphere rides in the gas that it drags along itself. Spread over some cells, that disturbance is small beside what is
// measured; nothing is subtracted.
TEST(MfixDem06, TwoWayItsOwnDisturbanceOfTheGasStaysBelowAPerCent) {
  const double error = worst_error("vans", "3 mm");
  EXPECT_LT(error, 0.01);
  record({"the same, two-way", "MFIX DEM06, integrated equation", percent(error), "MFIX 0.6 to 4.8 %"});
}

}  // namespace similitude::test
