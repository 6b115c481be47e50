// Scaling laws against the recomputed table of the published quarter-scale beds.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include <similitude/sphere_in_gas.h>

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


// --------------------------------------------------------------------------------------------- the similarity family

/// Random beds and members: 200 draws from a fixed seed, over the whole range of what is simulated.
struct Draw {
  similitude_bed bed = alumina_bed();
  double r, n, gas_density;
};

std::vector<Draw> draws() {
  std::mt19937_64 random(20130524);
  const auto between = [&](double low, double high) {   // evenly in the logarithm
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
  };
  std::vector<Draw> all(200);
  for (Draw& d : all) {
    d.bed.gas_density = between(0.1, 50);
    d.bed.particle_density = d.bed.gas_density * between(2, 5000);
    d.bed.gas_viscosity = between(5e-6, 1e-3);
    d.bed.particle_diameter = d.bed.drag_diameter = between(5e-5, 1e-2);
    d.r = between(1.0 / 32, 2);
    d.n = between(1.0 / 32, 8);
    d.gas_density = between(0.05, 20);
  }
  return all;
}

similitude_bed scaled(const similitude_bed& real, const similitude_ratios& r) {
  similitude_bed bed = real;
  bed.gas_density *= r.gas_density;
  bed.gas_viscosity *= r.gas_viscosity;
  bed.particle_density *= r.particle_density;
  bed.particle_diameter *= r.diameter;
  bed.drag_diameter *= r.drag_diameter;
  return bed;
}

similitude_ratios similarity(const similitude_bed& bed, double r, double n, const char* free_density, double value) {
  return ratios(ScalingModel(SIMILARITY, {Values{{"geometry", r}, {"n", n}, {free_density, value}}}, bed), bed);
}

void expect_same_groups(const similitude_bed& real, const similitude_ratios& r) {
  const SphereInGas exact = sphere_in_gas(real), small = sphere_in_gas(scaled(real, r));
  EXPECT_NEAR(r.velocity * r.velocity / r.length, 1, 1e-12);                                        // Fr
  EXPECT_NEAR(reynolds(small, r.velocity) / reynolds(exact, 1), 1, 1e-12);
  // (rho_p - rho_f)* loses the digits by which rho_p exceeds rho_f in both beds.
  const double lost = real.particle_density / (real.particle_density - real.gas_density);
  EXPECT_NEAR(archimedes(small) / archimedes(exact), 1, 1e-12 * lost);
}

TEST(ScalingSimilarity, KeepsFroudeReynoldsAndArchimedesWhateverIsFree) {
  for (const Draw& d : draws()) {
    expect_same_groups(d.bed, similarity(d.bed, d.r, d.n, "gas_density", d.gas_density));
    expect_same_groups(d.bed, similarity(d.bed, d.r, d.n, "particle_density", d.gas_density));
  }
}

TEST(ScalingSimilarity, ScalesErgunsMinimumFluidisationAsAllSpeeds) {
  for (const Draw& d : draws()) {
    const similitude_ratios r = similarity(d.bed, d.r, d.n, "gas_density", d.gas_density);
    const double ratio = minimum_fluidisation_ergun(sphere_in_gas(scaled(d.bed, r)), 0.42) /
                         minimum_fluidisation_ergun(sphere_in_gas(d.bed), 0.42);
    EXPECT_NEAR(ratio / std::sqrt(d.r), 1, 1e-12 * d.bed.particle_density / (d.bed.particle_density - d.bed.gas_density));
  }
}

// St* = rho_p* n^2 u* / (mu* r) = rho_p* / (rho_p - rho_f)*: 1 to O(rho_f / rho_p), exactly 1 + (n/r - 1) rho_f/rho_p.
TEST(ScalingSimilarity, KeepsTheStokesNumberToTheDensityRatio) {
  for (const Draw& d : draws()) {
    const similitude_ratios r = similarity(d.bed, d.r, d.n, "gas_density", d.gas_density);
    const double stokes = r.particle_density * r.diameter * r.diameter * r.velocity / (r.gas_viscosity * r.length);
    const double expected = 1 + (d.n / d.r - 1) * d.bed.gas_density / d.bed.particle_density;
    EXPECT_NEAR(stokes / expected, 1, 1e-12);
  }
}

TEST(ScalingSimilarity, TakesTheParticleDensityInPlaceOfTheGasDensity) {
  const similitude_bed bed = alumina_bed();
  const similitude_ratios r = similarity(bed, 0.25, 0.5, "particle_density", 1);
  EXPECT_NEAR(r.particle_density, 1, 1e-15);
  EXPECT_NEAR(r.gas_density, 1 / (0.5 + 0.5 * 1.225 / 1040), 1e-14);
}

TEST(ScalingSimilarity, RefusesBothDensities) {
  try {
    ScalingModel(SIMILARITY, {Values{{"geometry", 1}, {"n", 2}, {"gas_density", 1}, {"particle_density", 1}}});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "gas_density, particle_density: either follows from the other.\n  Leave one of the two out.");
  }
}

void expect_equal_ratios(const similitude_ratios& a, const similitude_ratios& b, double within) {
  for (const auto ratio : {&similitude_ratios::length, &similitude_ratios::diameter, &similitude_ratios::drag_diameter,
                           &similitude_ratios::particle_density, &similitude_ratios::gas_density,
                           &similitude_ratios::gas_viscosity, &similitude_ratios::velocity, &similitude_ratios::time,
                           &similitude_ratios::stiffness, &similitude_ratios::modulus, &similitude_ratios::energy_loss,
                           &similitude_ratios::parcel_weight})
    EXPECT_NEAR(a.*ratio / (b.*ratio), 1, within);
}

TEST(ScalingSimilarity, HoldsLinksLawAndTheTerminalVelocityLaw) {
  for (const Draw& d : draws()) {
    if (d.n >= 1) {
      expect_equal_ratios(ratios(ScalingModel(LINK, {Values{{"n", d.n}}}, d.bed), d.bed),
                          similarity(d.bed, 1, d.n, "gas_density", 1), 0);
    }
    if (d.r <= 1) {
      const similitude_ratios law = ratios(ScalingModel(TERMINAL_VELOCITY, {Values{{"geometry", d.r}}}, d.bed), d.bed);
      expect_equal_ratios(law, similarity(d.bed, d.r, law.diameter, "gas_density", law.gas_density), 1e-12);
      expect_equal_ratios(law, similarity(d.bed, d.r, law.diameter, "particle_density", 1), 1e-12);
    }
  }
}

// Table 1: rho_p 520.6 kg/m^3, mu 3.58e-5 Pa s.
TEST(ScalingLink, HasTheTabledRatios) {
  const similitude_ratios r = ratios(ScalingModel(LINK, {Values{{"n", 2}}}));
  EXPECT_NEAR(1040 * r.particle_density, 520.613, 5e-4);
  EXPECT_EQ(r.gas_viscosity, 2.0);
  EXPECT_EQ(r.gas_density, 1.0);
  EXPECT_EQ(r.length, 1.0);
  EXPECT_EQ(r.time, 1.0);
  EXPECT_NEAR(r.stiffness, 1.0, 0.0013);   // K* = rho_p* n = 1 + rho_f/rho_p
}

// Two members are the real bed to the last bit of every mantissa at r = 1/4: nothing but exponents changes.
TEST(ScalingSimilarity, IsExactWithPowersOfTwo) {
  const similitude_bed bed = alumina_bed();
  const similitude_ratios exact = ratios(ScalingModel(EXACT, {Values{{"geometry", 0.25}}}));
  expect_equal_ratios(similarity(bed, 0.25, 0.25, "gas_density", 1), exact, 0);
  expect_equal_ratios(ratios(ScalingModel(GLICKSMAN_FULL, {Values{{"geometry", 0.25}, {"gas_density", 1}}})), exact, 0);
}

TEST(ScalingGlicksmanFull, KeepsTheViscosityByDefault) {
  const similitude_ratios r = ratios(ScalingModel(GLICKSMAN_FULL, {Values{{"geometry", 0.25}}}));
  EXPECT_EQ(r.gas_viscosity, 1.0);
  EXPECT_EQ(r.gas_density, 8.0);
  EXPECT_EQ(r.particle_density, 8.0);
  EXPECT_EQ(r.diameter, 0.25);
}

// ------------------------------------------------------------------------------------------------------- Glicksman

similitude_ratios glicksman(const Values& values, const similitude_bed& bed = alumina_bed()) {
  return ratios(ScalingModel(GLICKSMAN, {values}, bed), bed);
}

// Printed 0.62, for u_mf = 0.36 m/s; the published tables never say at which gas fraction. Recomputed for each.
TEST(ScalingGlicksman, HasTheTabledDiameters) {
  EXPECT_NEAR(glicksman({{"geometry", 0.25}, {"minimum_fluidization_velocity", 0.36}}).diameter, 0.6196, 5e-5);
  const double alumina[][2] = {{0.40, 0.6361}, {0.42, 0.6262}, {0.44, 0.6158}, {0.45, 0.6105}, {0.4328, 0.6196}};
  for (const auto& [gas_fraction, n] : alumina)
    EXPECT_NEAR(glicksman({{"geometry", 0.25}, {"gas_fraction_at_minimum_fluidization", gas_fraction}}).diameter, n, 5e-5);
  similitude_bed glass = alumina_bed();
  glass.particle_density = 2500;
  const double beads[][2] = {{0.40, 0.5915}, {0.42, 0.5793}, {0.4328, 0.5714}};
  for (const auto& [gas_fraction, n] : beads)
    EXPECT_NEAR(glicksman({{"geometry", 0.25}, {"gas_fraction_at_minimum_fluidization", gas_fraction}}, glass).diameter, n, 5e-5);
  EXPECT_EQ(glicksman({{"geometry", 0.25}}).diameter,
            glicksman({{"geometry", 0.25}, {"gas_fraction_at_minimum_fluidization", 0.42}}).diameter);
}

TEST(ScalingGlicksman, TakesTheGasFractionFromTheVelocity) {
  EXPECT_NEAR(gas_fraction_ergun(sphere_in_gas(alumina_bed()), 0.36), 0.4328, 5e-5);
}

TEST(ScalingGlicksman, ScalesErgunsMinimumFluidisationAsAllSpeeds) {
  for (const Draw& d : draws()) {
    if (d.r > 1) continue;
    const similitude_ratios r = glicksman({{"geometry", d.r}, {"gas_fraction_at_minimum_fluidization", 0.45}}, d.bed);
    const double ratio = minimum_fluidisation_ergun(sphere_in_gas(scaled(d.bed, r)), 0.45) /
                         minimum_fluidisation_ergun(sphere_in_gas(d.bed), 0.45);
    EXPECT_NEAR(ratio / std::sqrt(d.r), 1, 1e-12);
    EXPECT_GE(r.diameter, d.r * (1 - 1e-12));                       // inertia alone
    EXPECT_LE(r.diameter, std::sqrt(std::sqrt(d.r)) * (1 + 1e-12));   // viscosity alone
    EXPECT_EQ(r.particle_density, 1);
    EXPECT_EQ(r.gas_density, 1);
    EXPECT_EQ(r.gas_viscosity, 1);
  }
}

TEST(ScalingGlicksman, RefusesAVelocityThatWouldCarryAnything) {
  try {
    glicksman({{"geometry", 0.25}, {"minimum_fluidization_velocity", 6}});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "minimum_fluidization_velocity: by Ergun no bed of these particles is so hard to lift.\n"
                           "  Check the velocity (superficial), and the particle's density and diameter.");
  }
}

TEST(ScalingGlicksman, RefusesVelocityAndGasFractionTogether) {
  try {
    glicksman({{"geometry", 0.25}, {"minimum_fluidization_velocity", 0.36}, {"gas_fraction_at_minimum_fluidization", 0.42}});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "minimum_fluidization_velocity, gas_fraction_at_minimum_fluidization: either follows from the "
                           "other.\n  Leave one of the two out.");
  }
}

// ---------------------------------------------------------------------------------------------------------- grains

class ScalingGrains : public testing::TestWithParam<const char*> {};

TEST_P(ScalingGrains, ShowTheGasTheParticlesAndCollisionsTheGrain) {
  const similitude_ratios r = ratios(ScalingModel(GetParam(), {Values{{"n", 1.5}}}));
  EXPECT_EQ(r.diameter, 1.5);
  EXPECT_EQ(r.drag_diameter, 1.0);
  EXPECT_EQ(r.parcel_weight, 1.5 * 1.5 * 1.5);
  for (const double kept : {r.length, r.time, r.velocity, r.particle_density, r.gas_density, r.gas_viscosity, r.energy_loss})
    EXPECT_EQ(kept, 1.0);
}

TEST_P(ScalingGrains, LoseMoreEnergyOnlyIfAsked) {
  const similitude_ratios r = ratios(ScalingModel(GetParam(), {Values{{"n", 1.5}, {"restitution_correction", 1}}}));
  EXPECT_EQ(r.energy_loss, 1.5);
}

std::string name_of_grains(const testing::TestParamInfo<const char*>& info) {
  return std::array{"parcel", "coarse_grain", "bierwisch"}[info.index];
}

INSTANTIATE_TEST_SUITE_P(Laws, ScalingGrains, testing::Values(PARCEL, COARSE_GRAIN, BIERWISCH), name_of_grains);

TEST(ScalingParcel, LeavesSpringsAsGiven) {
  const similitude_ratios r = ratios(ScalingModel(PARCEL, {Values{{"n", 2}}}));
  EXPECT_EQ(r.stiffness, 1.0);
  EXPECT_EQ(r.modulus, 1.0);
}

// A grain of n^3 the mass on a spring n^3 as stiff swings as fast: sqrt(m/k) is kept. By Hertz F ~ E sqrt(d) overlap^(3/2).
TEST(ScalingCoarseGrain, KeepsTheTimeOfAnImpact) {
  const similitude_ratios r = ratios(ScalingModel(COARSE_GRAIN, {Values{{"n", 2}}}));
  EXPECT_EQ(r.stiffness, 8.0);
  EXPECT_NEAR(r.modulus * std::sqrt(r.diameter), 8, 1e-14);
}

// Stress: force over area at the same overlap over the diameter, k overlap / d^2 and E sqrt(d) overlap^(3/2) / d^2.
TEST(ScalingBierwisch, KeepsTheStress) {
  const similitude_ratios r = ratios(ScalingModel(BIERWISCH, {Values{{"n", 2}}}));
  EXPECT_EQ(r.stiffness * r.diameter / (r.diameter * r.diameter), 1.0);
  EXPECT_EQ(r.modulus, 1.0);
}

// ---------------------------------------------------------------------------------------------------------- by hand

TEST(ScalingCustom, FollowsTheSharedRulesWhereNothingIsSaid) {
  const similitude_ratios r = ratios(ScalingModel(CUSTOM, {Values{{"length", 0.25}, {"diameter", 0.5}, {"particle_density", 2}}}));
  EXPECT_EQ(r.velocity, 0.5);
  EXPECT_EQ(r.time, 0.5);
  EXPECT_EQ(r.drag_diameter, 0.5);
  EXPECT_EQ(r.stiffness, 0.25);
  EXPECT_EQ(r.modulus, 0.5);
}

TEST(ScalingCustom, TakesEveryRatioByHand) {
  const Values values{{"length", 2},  {"diameter", 3}, {"drag_diameter", 4}, {"particle_density", 5}, {"gas_density", 6},
                      {"gas_viscosity", 7}, {"velocity", 8}, {"time", 9}, {"stiffness", 10}, {"modulus", 11},
                      {"energy_loss", 12}, {"parcel_weight", 13}};
  const similitude_ratios r = ratios(ScalingModel(CUSTOM, {values}));
  const double all[] = {r.length, r.diameter, r.drag_diameter, r.particle_density, r.gas_density, r.gas_viscosity,
                        r.velocity, r.time, r.stiffness, r.modulus, r.energy_loss, r.parcel_weight};
  for (int i = 0; i < 12; ++i) EXPECT_EQ(all[i], i + 2) << i;
}

}  // namespace
}  // namespace similitude
