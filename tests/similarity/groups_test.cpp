// Numbers recomputed from the paper's Table 1 and from the correlations by an independent script.
#include <gtest/gtest.h>

#include "beds.h"
#include "similarity/audit.h"
#include "similarity/groups.h"

namespace similitude {
namespace {

using testing::exact_quarter;
using testing::similar;
using testing::spouted_bed;
using testing::terminal_velocity_law;

constexpr SphereInGas k_alumina{1e-3, 1040, 1.225, 1.79e-5, 9.81};
constexpr SphereInGas k_glass{1e-3, 2500, 1.225, 1.79e-5, 9.81};
constexpr SphereInGas k_goldschmidt{2.5e-3, 2526, 1.2, 1.8e-5, 9.81};

// Tolerances below are half of the last digit that the reference gives.

TEST(Groups, ArchimedesAndReynoldsOfTheSpoutedBed) {
  EXPECT_NEAR(archimedes(k_alumina), 38960, 0.5);
  EXPECT_NEAR(archimedes(k_glass), 93719, 0.5);
  EXPECT_NEAR(reynolds(k_alumina, 0.36), 24.64, 5e-3);
}

TEST(TerminalVelocity, OfEachDragLaw) {
  EXPECT_NEAR(terminal_velocity_newton(k_alumina), 4.9956, 5e-5);
  EXPECT_NEAR(terminal_velocity_newton(k_glass), 7.748, 5e-4);
  EXPECT_NEAR(terminal_velocity(k_alumina, dalla_valle), 3.5508, 5e-5);
  EXPECT_NEAR(terminal_velocity(k_alumina, schiller_naumann), 3.943726, 5e-7);
  EXPECT_NEAR(terminal_velocity(k_glass, schiller_naumann), 6.793291, 5e-7);
  EXPECT_NEAR(terminal_velocity({1e-4, 2000, 1.2, 1.8e-5, 9.81}, schiller_naumann), 0.457536, 5e-7);
}

// Stokes: u = (rho_p - rho_f) g d^2 / (18 mu); Schiller-Naumann's correction at Re = 2e-5 is 0.15 Re^0.687 = 1e-4.
TEST(TerminalVelocity, OfDustFollowsStokes) {
  const SphereInGas dust{1e-6, 1000, 1.2, 1.8e-5, 9.81};
  const double stokes = (dust.particle_density - dust.gas_density) * 9.81 * 1e-12 / (18 * 1.8e-5);
  EXPECT_NEAR(terminal_velocity(dust, schiller_naumann) / stokes, 1, 1e-4);
}

// The force balance 4/3 Ar = C_D Re^2 holds to rounding.
TEST(TerminalVelocity, BalancesWeightAndDrag) {
  for (const double diameter : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const SphereInGas sphere{diameter, 1040, 1.225, 1.79e-5, 9.81};
    const double re = reynolds(sphere, terminal_velocity(sphere, dalla_valle));
    EXPECT_NEAR(dalla_valle(re) * re * re / (4.0 / 3 * archimedes(sphere)), 1, 1e-12);
  }
}

// The reference gives five digits: half of the last is at most 5e-5 of the value.
TEST(DragCoefficient, OfASingleSphere) {
  const double sn[][2] = {{0.1, 247.4},   {1, 27.6},      {10, 4.1511}, {100, 1.0917},
                          {500, 0.56267}, {999, 0.43844}, {2000, 0.44}};
  for (const auto& [re, expected] : sn) EXPECT_NEAR(schiller_naumann(re) / expected, 1, 5e-5) << re;
  const double dv[][2] = {{0.1, 249.92}, {1, 29.485}, {10, 4.6134}, {100, 1.2321}, {500, 0.71345}, {1000, 0.61119}};
  for (const auto& [re, expected] : dv) EXPECT_NEAR(dalla_valle(re) / expected, 1, 5e-5) << re;
}

TEST(MinimumFluidisation, ByErgunAtEachGasFraction) {
  const double table[][2] = {{0.40, 0.2916}, {0.41, 0.3118}, {0.42, 0.3326}, {0.43, 0.3539},
                             {0.44, 0.3759}, {0.45, 0.3984}, {0.46, 0.4215}};
  for (const auto& [gas_fraction, expected] : table)
    EXPECT_NEAR(minimum_fluidisation_ergun(k_alumina, gas_fraction), expected, 5e-5);
  EXPECT_NEAR(minimum_fluidisation_ergun(k_alumina, 0.4328), 0.3600, 1e-4);  // the printed 0.36 m/s
  EXPECT_NEAR(minimum_fluidisation_ergun(k_glass, 0.44), 0.6967, 5e-5);
  EXPECT_NEAR(minimum_fluidisation_ergun(k_goldschmidt, 0.42), 1.3364, 5e-5);
}

TEST(MinimumFluidisation, ByWenAndYu) {
  EXPECT_NEAR(minimum_fluidisation_wen_yu(k_alumina), 0.2704, 5e-5);
  EXPECT_NEAR(minimum_fluidisation_wen_yu(k_glass), 0.5366, 5e-5);
  EXPECT_NEAR(minimum_fluidisation_wen_yu(k_goldschmidt), 1.2628, 5e-5);
}

// Ergun's own quadratic, put back in: no root was lost to cancellation, for dust either.
TEST(MinimumFluidisation, SolvesErgunsQuadratic) {
  for (const double diameter : {1e-6, 1e-4, 1e-2}) {
    const SphereInGas s{diameter, 1040, 1.225, 1.79e-5, 9.81};
    const double re = reynolds(s, minimum_fluidisation_ergun(s, 0.42)), cube = 0.42 * 0.42 * 0.42;
    EXPECT_NEAR((1.75 / cube * re * re + 150 * 0.58 / cube * re) / archimedes(s), 1, 1e-13);
  }
}

double ratio(const std::vector<GroupComparison>& comparisons, const std::string& name) {
  for (const GroupComparison& one : comparisons)
    if (one.name == name) return one.ratio;
  ADD_FAILURE() << "no group " << name;
  return 0;
}

bool kept(const std::vector<GroupComparison>& comparisons, const std::string& name) {
  for (const GroupComparison& one : comparisons)
    if (one.name == name) return one.kept;
  return false;
}

std::vector<GroupComparison> audit(const similitude_ratios& ratios) {
  const RealScene real = spouted_bed();
  return compare_groups(describe(real), describe(simulated_bed(real, ratios)));
}

TEST(Audit, TheTerminalVelocityLawKeepsFrReArAndWhatFollows) {
  const auto groups = audit(terminal_velocity_law(0.25, 1040, 1.225));
  for (const char* name : {"Fr", "Re", "Ar", "u0/u_mf", "u0/u_t"}) {
    EXPECT_NEAR(ratio(groups, name), 1, 1e-12) << name;
    EXPECT_TRUE(kept(groups, name)) << name;
  }
}

// What no law with n/r > 1 can keep: density ratio and L/d fall by n/r = 2.8315, the jet's momentum rises by as much.
TEST(Audit, TheTerminalVelocityLawGivesUpDensityRatioAndJet) {
  const auto groups = audit(terminal_velocity_law(0.25, 1040, 1.225));
  EXPECT_NEAR(ratio(groups, "(rho_p-rho_f)/rho_f"), 0.3532, 5e-5);
  EXPECT_NEAR(ratio(groups, "L/d"), 0.3532, 5e-5);
  EXPECT_NEAR(ratio(groups, "J"), 1 / 0.3532, 5e-4);
  for (const char* name : {"rho_p/rho_f", "(rho_p-rho_f)/rho_f", "L/d", "J"}) EXPECT_FALSE(kept(groups, name)) << name;
  // St is kept to O(rho_f/rho_p): St* = rho_p*/(rho_p - rho_f)* = 1.0022.
  EXPECT_NEAR(ratio(groups, "St"), 1.0022, 5e-5);
  EXPECT_FALSE(kept(groups, "St"));
}

// Link et al. (2009), n = 2: mu* = 2, (rho_p - rho_f)* = 1/2, so rho_p = 520.61.
TEST(Audit, LinksLawKeepsTheSameGroups) {
  const auto groups = audit(similar(1, 2, 1, (1.225 + (1040 - 1.225) / 2) / 1040, 2));
  for (const char* name : {"Fr", "Re", "Ar", "u0/u_mf", "u0/u_t"}) EXPECT_NEAR(ratio(groups, name), 1, 1e-12) << name;
  EXPECT_NEAR(ratio(groups, "(rho_p-rho_f)/rho_f"), 0.5, 1e-12);
  EXPECT_NEAR(ratio(groups, "J"), 2, 1e-12);
}

// Glicksman's simplified set, n = 0.62 at r = 1/4: table 1 prints Re 0.310 and Ar 0.2383.
TEST(Audit, GlicksmansSimplifiedSetLosesReAndAr) {
  const auto groups = audit(similar(0.25, 0.62, 1, 1, 1));
  EXPECT_NEAR(ratio(groups, "Fr"), 1, 1e-12);
  EXPECT_NEAR(ratio(groups, "Re"), 0.3100, 5e-5);
  EXPECT_NEAR(ratio(groups, "Ar"), 0.2383, 5e-5);
  EXPECT_NEAR(ratio(groups, "rho_p/rho_f"), 1, 1e-12);
  EXPECT_NEAR(ratio(groups, "u0/u_t"), 0.7710, 5e-5);  // Schiller-Naumann
}

TEST(Audit, TheExactQuarterKeepsEverythingToTheBit) {
  for (const GroupComparison& group : audit(exact_quarter())) {
    EXPECT_EQ(group.ratio, 1) << group.name;
    EXPECT_TRUE(group.kept) << group.name;
  }
}

TEST(Audit, ABedAtRestHasNothingToCompare) {
  RealScene real = spouted_bed();
  for (Patch& patch : real.patches) patch.velocity = 0;
  const auto groups = compare_groups(describe(real), describe(simulated_bed(real, exact_quarter())));
  EXPECT_EQ(ratio(groups, "Fr"), 1);
  EXPECT_EQ(ratio(groups, "J"), 1);
}

}  // namespace
}  // namespace similitude
