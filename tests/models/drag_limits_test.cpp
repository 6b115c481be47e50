// Where a drag law must meet a simpler one, where it is smooth, and where it is known to jump.
#include <gtest/gtest.h>

#include <cmath>

#include "drag_model.h"

namespace similitude {
namespace {

using namespace test;

constexpr double k_reynolds[] = {0, 0.01, 1, 30, 300, 3000};
/// To the other side of a jump in the gas fraction.
constexpr double k_step = 1e-9;

void expect_factor(const DragModel& law, double gas_fraction, double reynolds, double expected, double relative = 1e-12) {
  EXPECT_NEAR(factor(law, gas_fraction, reynolds), expected, relative * expected) << gas_fraction << ' ' << reynolds;
}

TEST(DragInAnEmptyGas, IsTheSingleSpheres) {
  const DragModel wen_yu(WEN_YU, {Values{}}), di_felice(DI_FELICE, {Values{}}), rong(RONG, {Values{}}),
      as_in_mfix(DI_FELICE, {Values{{"drag_coefficient", "schiller_naumann"}}}), tenneti(TENNETI, {Values{}});
  for (const double re : k_reynolds) {
    expect_factor(wen_yu, 1, re, schiller_naumann_factor(re));
    expect_factor(as_in_mfix, 1, re, schiller_naumann_factor(re));
    expect_factor(tenneti, 1, re, schiller_naumann_factor(re));
    expect_factor(di_felice, 1, re, dalla_valle_factor(re));
    expect_factor(rong, 1, re, dalla_valle_factor(re));
  }
}

TEST(DragInAnEmptyGas, IsStokesAtRestForLatticeBoltzmannLaws) {
  for (const char* file : {BEETSTRA, TANG, TENNETI, KOCH_HILL, KOCH_HILL_LADD}) {
    EXPECT_DOUBLE_EQ(factor(DragModel(file, {Values{}}), 1, 0), 1) << file;
  }
}

// F over Stokes' at the superficial velocity is the factor over eps.
TEST(DragAtRest, IsTheLawsOwnCreepingFlow) {
  const DragModel ergun(ERGUN, {Values{}}), beetstra(BEETSTRA, {Values{}}), tang(TANG, {Values{}});
  for (const double eps : {0.3, 0.42, 0.6, 0.9}) {
    const double phi = 1 - eps;
    const double array = 10 * phi / (eps * eps) + eps * eps * (1 + 1.5 * std::sqrt(phi));
    expect_factor(ergun, eps, 0, 150 * phi / (18 * eps * eps) * eps);
    expect_factor(beetstra, eps, 0, array * eps);
    expect_factor(tang, eps, 0, array * eps);
  }
}

// Three groups' simulations of the same array, solids fraction 0.4: they agree to 9 %.
TEST(DragAtRest, InAnArrayOfSolidsFraction04IsEachSourcesOwn) {
  EXPECT_NEAR(factor(DragModel(TENNETI, {Values{}}), 0.6, 0) / 0.6, 10.9, 0.05);
  EXPECT_NEAR(factor(DragModel(BEETSTRA, {Values{}}), 0.6, 0) / 0.6, 11.8, 0.05);
  EXPECT_NEAR(factor(DragModel(KOCH_HILL, {Values{}}), 0.6, 0) / 0.6, 11.1, 0.05);
}

// chi = 3.7 in viscous and inertial flow, 3.05 where 1.5 - log10(eps Re) = 0. Rong at eps 0.5: 3.975 and less 3.55 / 4.
TEST(DragExponents, DipAtASuperficialReynoldsNumberOf32) {
  const double eps = 0.5, middle = std::pow(10, 1.5);
  const auto chi = [eps](const char* file, double superficial) {
    const double alone = dalla_valle_factor(superficial);
    return 1 - std::log(factor(DragModel(file, {Values{}}), eps, superficial / eps) / alone) / std::log(eps);
  };
  EXPECT_NEAR(chi(DI_FELICE, 0), 3.7, 1e-12);
  EXPECT_NEAR(chi(DI_FELICE, middle), 3.05, 1e-12);
  EXPECT_NEAR(chi(DI_FELICE, 10 * middle), 3.7 - 0.65 * std::exp(-0.5), 1e-12);
  EXPECT_NEAR(chi(RONG, 0), 2.65 * 1.5, 1e-12);
  EXPECT_NEAR(chi(RONG, middle), 2.65 * 1.5 - (5.3 - 3.5 * 0.5) * 0.25, 1e-12);
}

// eps^-2.65 is Richardson and Zaki's exponent 4.65 in creeping flow: U/u_t = eps u_s/u_t.
TEST(DragWenYu, HindersCreepingFlowAsRichardsonAndZaki) {
  const DragModel law(WEN_YU, {Values{}});
  for (const double eps : {0.5, 0.7, 0.9}) {
    // eps weight = factor u_s: u_s / u_t = eps / factor in creeping flow.
    const double settling = eps * (eps / factor(law, eps, 0));
    EXPECT_NEAR(settling, std::pow(eps, 4.65), 1e-12);
  }
}

TEST(DragGidaspow, JumpsAtGasFraction08FromErgunToWenAndYu) {
  const DragModel law(GIDASPOW, {Values{}}), ergun(ERGUN, {Values{}}), wen_yu(WEN_YU, {Values{}});
  const double below = exchange(law, 0.8, 2), above = exchange(law, 0.8 + k_step, 2);
  EXPECT_DOUBLE_EQ(below, exchange(ergun, 0.8, 2));
  EXPECT_DOUBLE_EQ(above, exchange(wen_yu, 0.8 + k_step, 2));
  EXPECT_NEAR(above / below, 2780.4 / 4958.8, 1e-4);   // five digits each
}

TEST(DragHuilinGidaspow, PassesSmoothlyThroughTheMeanOfErgunAndWenAndYu) {
  const DragModel law(HUILIN_GIDASPOW, {Values{}}), ergun(ERGUN, {Values{}}), wen_yu(WEN_YU, {Values{}});
  for (const double slip : {0.0, 0.3, 2.0, 20.0}) {
    const double here = exchange(law, 0.8, slip);
    EXPECT_NEAR(here, 0.5 * (exchange(ergun, 0.8, slip) + exchange(wen_yu, 0.8, slip)), 1e-12 * here);
    EXPECT_NEAR(exchange(law, 0.8 + k_step, slip), here, 1e-6 * here);
  }
  // atan leaves a tail: 0.6 % of Ergun in an empty gas.
  const double ergun_share = 0.5 - std::atan(262.5 * 0.2) / k_pi;
  EXPECT_NEAR(ergun_share, 0.00606, 5e-6);
  expect_factor(law, 1, 300, ergun_share * factor(ergun, 1, 300) + (1 - ergun_share) * factor(wen_yu, 1, 300));
}

TEST(DragKochHill, JumpsByOnePerCentAtSolidsFraction04) {
  const DragModel law(KOCH_HILL, {Values{}});
  const auto creeping = [&](double eps) { return factor(law, eps, 0) / (eps * eps); };
  EXPECT_NEAR(creeping(0.6 + k_step), 18.33, 0.005);
  EXPECT_NEAR(creeping(0.6 - k_step), 18.52, 0.005);
}

// phi ln phi: -3.7e-9 at 1e-10, and 3 sqrt(phi/2) = 2e-5 leads.
TEST(DragKochHill, IsSmoothTowardsAnEmptyGas) {
  const DragModel law(KOCH_HILL, {Values{}});
  EXPECT_NEAR(factor(law, 1 - 1e-10, 0), 1 + 3 * std::sqrt(0.5e-10), 1e-7);
  EXPECT_NEAR(factor(law, 1, 100), 1 + (0.0673 + 0.0232) * 50, 1e-12);
}

// Beyond Re = 1000 and solids fractions of 0.6, which Tang simulated, the fit leaves physics.
TEST(DragTang, TurnsNegativeFarBeyondItsRange) {
  const DragModel law(TANG, {Values{}});
  EXPECT_GT(factor(law, 0.3, 1e4), 0);
  EXPECT_LT(factor(law, 0.3, 1.9e4), 0);
}

TEST(DragHaiderLevenspiel, IsHinderedAsWenAndYuOrNotAtAll) {
  const DragModel hindered(HAIDER_LEVENSPIEL, {Values{{"sphericity", 0.8}}});
  const DragModel alone(HAIDER_LEVENSPIEL, {Values{{"sphericity", 0.8}, {"hindrance", "none"}}});
  for (const double re : k_reynolds) {
    const double single = factor(alone, 1, re);
    EXPECT_EQ(factor(alone, 0.5, re), single);
    expect_factor(hindered, 1, re, single);
    expect_factor(hindered, 0.5, 2 * re, single * std::pow(0.5, -2.65));
  }
}

// Both fit the same spheres: 3 % apart at Re 1, 5 % at 100, 11 % at 1000, as their tables say.
TEST(DragHaiderLevenspiel, OfASphereIsNearSchillerAndNaumann) {
  const DragModel law(HAIDER_LEVENSPIEL, {Values{}});
  expect_factor(law, 1, 1, schiller_naumann_factor(1.0), 0.04);
  expect_factor(law, 1, 100, schiller_naumann_factor(100.0), 0.06);
  expect_factor(law, 1, 999, schiller_naumann_factor(999.0), 0.11);
}

// A law is a template: what a pack does is what doubles do.
TEST(DragCorrelations, AreTheSameForPacksAndDoubles) {
  for (const double eps : {0.35, 0.61, 0.9, 1.0}) {
    for (const double re : k_reynolds) {
      const Pack packed_eps(eps), packed_re(re);
      EXPECT_DOUBLE_EQ(ergun_factor(packed_re, packed_eps)[0], ergun_factor(re, eps));
      EXPECT_DOUBLE_EQ(wen_yu_factor(packed_re, packed_eps)[0], wen_yu_factor(re, eps));
      EXPECT_DOUBLE_EQ(di_felice_dip(packed_re)[0], di_felice_dip(re));
      EXPECT_DOUBLE_EQ(beetstra_factor(packed_re, packed_eps)[0], beetstra_factor(re, eps));
      EXPECT_DOUBLE_EQ(hill_koch_ladd_array(Pack(1.0 - packed_eps), 16.14, -8.48, 8.16)[0],
                       hill_koch_ladd_array(1.0 - eps, 16.14, -8.48, 8.16));
      EXPECT_DOUBLE_EQ(hill_koch_ladd_slope(packed_eps)[0], hill_koch_ladd_slope(eps));
    }
  }
}

}  // namespace
}  // namespace similitude
