// Scaling laws against the recomputed table of the published quarter-scale beds.
#include <gtest/gtest.h>

#include <cmath>

#include "plugin_file.h"

namespace similitude {
namespace {

using test::alumina_bed;
using test::Values;
using ScalingModel = test::TestModel<similitude_scaling_functions>;

similitude_ratios ratios(const ScalingModel& law, const similitude_bed& bed = alumina_bed()) {
  similitude_ratios r{};
  r.struct_size = sizeof r;
  similitude_status status{};
  law.functions().ratios(law.instance(), &bed, &r, &status);
  if (status.code) throw std::runtime_error(status.text);
  return r;
}

TEST(ScalingExact, IsTheIdentityByDefault) {
  const similitude_ratios r = ratios(ScalingModel(EXACT, {Values{}}));
  for (const double ratio : {r.length, r.diameter, r.drag_diameter, r.particle_density, r.gas_density, r.gas_viscosity,
                             r.velocity, r.time, r.stiffness, r.modulus, r.energy_loss, r.parcel_weight}) {
    EXPECT_EQ(ratio, 1.0);
  }
}

TEST(ScalingExact, HasRatiosOfPowersOfTwoAtAQuarter) {
  const similitude_ratios r = ratios(ScalingModel(EXACT, {Values{{"geometry", 0.25}}}));
  EXPECT_EQ(r.length, 1.0 / 4);
  EXPECT_EQ(r.diameter, 1.0 / 4);
  EXPECT_EQ(r.gas_viscosity, 1.0 / 8);
  EXPECT_EQ(r.velocity, 1.0 / 2);
  EXPECT_EQ(r.time, 1.0 / 2);
  EXPECT_EQ(r.stiffness, 1.0 / 16);
  EXPECT_EQ(r.modulus, 1.0 / 4);
  EXPECT_EQ(r.particle_density, 1.0);
  EXPECT_EQ(r.gas_density, 1.0);
}

TEST(ScalingTerminalVelocity, HasTheTabledRatiosAtAQuarter) {
  const similitude_ratios r = ratios(ScalingModel(TERMINAL_VELOCITY, {Values{{"geometry", 0.25}}}));
  EXPECT_NEAR(r.diameter, 0.70787, 5e-6);
  EXPECT_NEAR(1.225 * r.gas_density, 3.4611, 5e-5);
  EXPECT_EQ(r.drag_diameter, r.diameter);
  EXPECT_EQ(r.length, 0.25);
  EXPECT_EQ(r.velocity, 0.5);
  EXPECT_EQ(r.time, 0.5);
  EXPECT_EQ(r.particle_density, 1.0);
  EXPECT_EQ(r.gas_viscosity, 1.0);
  EXPECT_EQ(r.modulus, 0.25);
  EXPECT_EQ(r.stiffness, 0.25 * r.diameter);
}

TEST(ScalingTerminalVelocity, KeepsReynoldsAndArchimedesNumbers) {
  const similitude_bed bed = alumina_bed();
  for (const double geometry : {1.0 / 16, 0.1, 0.25, 0.7, 1.0}) {
    const similitude_ratios r = ratios(ScalingModel(TERMINAL_VELOCITY, {Values{{"geometry", geometry}}}));
    const double buoyant = (bed.particle_density * r.particle_density - bed.gas_density * r.gas_density) /
                           (bed.particle_density - bed.gas_density);
    EXPECT_NEAR(r.gas_density * r.velocity * r.diameter / r.gas_viscosity, 1, 1e-14);
    EXPECT_NEAR(r.gas_density * buoyant * r.diameter * r.diameter * r.diameter, 1, 1e-13);   // mu* = 1
  }
}

TEST(ScalingTerminalVelocity, GainsNothingAtFullSize) {
  const similitude_ratios r = ratios(ScalingModel(TERMINAL_VELOCITY, {Values{{"geometry", 1}}}));
  EXPECT_NEAR(r.diameter, 1, 1e-15);
  EXPECT_NEAR(r.gas_density, 1, 1e-15);
}

// Newton's law u_t = sqrt(4 g d (rho_p - rho_f) / (3 C_D rho_f)) with C_D = 4/9: 4.9956 m/s real, 2.4978 m/s at a quarter.
TEST(ScalingTerminalVelocity, HalvesTheTerminalVelocityAtAQuarter) {
  const similitude_bed bed = alumina_bed();
  const similitude_ratios r = ratios(ScalingModel(TERMINAL_VELOCITY, {Values{{"geometry", 0.25}}}));
  const auto newton = [](double d, double rho_f) { return std::sqrt(3 * 9.81 * d * (1040 - rho_f) / rho_f); };
  EXPECT_NEAR(newton(bed.particle_diameter, bed.gas_density), 4.9956, 5e-5);
  EXPECT_NEAR(newton(bed.particle_diameter * r.diameter, bed.gas_density * r.gas_density), 2.4978, 5e-5);
}

TEST(ScalingTerminalVelocity, RefusesParticlesThatFloat) {
  similitude_bed bed = alumina_bed();
  bed.particle_density = 1;
  try {
    ratios(ScalingModel(TERMINAL_VELOCITY, {Values{{"geometry", 0.25}}}), bed);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "terminal_velocity needs particles heavier than their gas.\n"
                           "  Check scene.particles and scene.gas.density.");
  }
}

}  // namespace
}  // namespace similitude
