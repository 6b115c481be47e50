// The single spheres, Syamlal and O'Brien's law with its fit, and drag at rest.
#include <gtest/gtest.h>

#include <cmath>

#include "drag_model.h"

namespace similitude {
namespace {

using namespace test;

TEST(SingleSphere, HasSchillerAndNaumannsCoefficient) {
  const std::pair<double, double> table[] = {{0.1, 247.4},    {1, 27.6},        {10, 4.1511}, {100, 1.0917},
                                             {500, 0.56267}, {999, 0.43844}, {2000, 0.44}};
  for (const auto& [re, c] : table) EXPECT_NEAR(schiller_naumann(re), c, 1e-4 * c) << re;
}

TEST(SingleSphere, HasDallaVallesCoefficient) {
  const std::pair<double, double> table[] = {{0.1, 249.92}, {1, 29.485}, {10, 4.6134}, {100, 1.2321}, {500, 0.71345}, {1000, 0.61119}};
  for (const auto& [re, c] : table) EXPECT_NEAR(dalla_valle(re), c, 1e-4 * c) << re;
}

TEST(DragSchillerNaumann, IsWenAndYuInAnEmptyGas) {
  const DragModel law(SCHILLER_NAUMANN, {Values{}});
  EXPECT_NEAR(exchange(law, 1, 3.5) / k_volume, 2405.9, 1e-4 * 2405.9);
  EXPECT_EQ(exchange(law, 0.5, 3.5), exchange(law, 1, 3.5));   // knows no neighbours
}

TEST(DragSyamlalOBrien, HasTheTabledVelocityRatio) {
  struct Row {
    double reynolds, gas_fraction, ratio;
  };
  const Row table[] = {{1, 0.42, 0.110569},   {1, 0.6, 0.191205},   {1, 0.85, 0.524580},   {1, 0.95, 0.813092},
                       {25, 0.42, 0.231939},  {25, 0.6, 0.358989},  {25, 0.85, 0.609450},  {25, 0.95, 0.849680},
                       {100, 0.42, 0.253959}, {100, 0.6, 0.397669}, {100, 0.85, 0.636374}, {100, 0.95, 0.864815}};
  const DragModel law(SYAMLAL_OBRIEN, {Values{}});
  for (const Row& row : table) {
    const double expected =
        k_stokes * row.gas_fraction * dalla_valle_factor(row.reynolds, row.ratio) / (row.ratio * row.ratio);
    // A ratio printed to 1e-6 enters squared.
    EXPECT_NEAR(exchange(law, row.gas_fraction, slip_for(row.reynolds)), expected, 1.5e-5 * expected)
        << row.reynolds << ' ' << row.gas_fraction;
  }
}

TEST(DragSyamlalOBrien, TendsToDallaValleInAnEmptyGas) {
  const DragModel law(SYAMLAL_OBRIEN, {Values{}});
  for (const double re : {0.01, 1.0, 30.0, 1000.0}) {
    const double alone = k_stokes * dalla_valle_factor(re);
    EXPECT_NEAR(exchange(law, 1, slip_for(re)), alone, 1e-12 * alone) << re;
    EXPECT_NEAR(exchange(law, 1 - 1e-7, slip_for(re)), alone, 1e-5 * alone) << re;
  }
}

// 0.8 * 0.85^1.28 = 0.64975 against 0.85^2.65 = 0.65007: the default constants leave a step of 5e-4 in B.
TEST(DragSyamlalOBrien, JoinsItsBranchesAtGasFraction085) {
  const DragModel usual(SYAMLAL_OBRIEN, {Values{}});
  const DragModel fitted(SYAMLAL_OBRIEN, {Values{{"minimum_fluidization_velocity", 0.36}}});
  for (const double slip : {0.1, 1.0, 3.0}) {
    const double below = exchange(usual, 0.85, slip), fitted_below = exchange(fitted, 0.85, slip);
    EXPECT_NEAR(exchange(usual, 0.85 + 1e-9, slip), below, 2e-3 * below);
    EXPECT_NEAR(exchange(fitted, 0.85 + 1e-9, slip), fitted_below, 1e-6 * fitted_below);
  }
}

TEST(DragSyamlalOBrien, FitsC1AndD1ToTheMinimumFluidizationVelocity) {
  struct Row {
    double gas_fraction, c1, d1;
  };
  const Row table[] = {{0.40, 0.8702, 2.1358}, {0.41, 0.8219, 2.4870}, {0.42, 0.7773, 2.8303},
                       {0.43, 0.7360, 3.1663}, {0.44, 0.6977, 3.4952}, {0.45, 0.6621, 3.8176}};
  for (const Row& row : table) {
    const DragModel fitted(SYAMLAL_OBRIEN, {Values{{"minimum_fluidization_velocity", 0.36},
                                                   {"gas_fraction_at_minimum_fluidization", row.gas_fraction}}});
    EXPECT_NEAR(carrying_slip(fitted, row.gas_fraction, test::alumina_bed()) * row.gas_fraction, 0.36, 1e-9);
    const DragModel tabled(SYAMLAL_OBRIEN, {Values{{"c1", row.c1}, {"d1", row.d1}}});
    for (const State& state : k_states) {   // constants printed to 5e-5
      const double k = exchange(tabled, state.gas_fraction, state.slip);
      EXPECT_NEAR(exchange(fitted, state.gas_fraction, state.slip), k, 3e-4 * k) << row.gas_fraction;
    }
  }
}

TEST(DragSyamlalOBrien, RefusesConstantsBesideAFit) {
  try {
    const DragModel law(SYAMLAL_OBRIEN, {Values{{"c1", 0.7}, {"minimum_fluidization_velocity", 0.36}}});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(),
                 "c1, d1: given together with minimum_fluidization_velocity, which sets them.\n"
                 "  Leave out c1 and d1, or minimum_fluidization_velocity.");
  }
}

TEST(DragSyamlalOBrien, RefusesAVelocityThatCannotFluidize) {
  try {
    const DragModel law(SYAMLAL_OBRIEN, {Values{{"minimum_fluidization_velocity", 0}}});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(),
                 "minimum_fluidization_velocity: no c1 makes this bed fluidize at so low a velocity.\n"
                 "  Check the velocity (superficial), the particle's density and diameter, and "
                 "gas_fraction_at_minimum_fluidization.");
  }
}

TEST(TerminalVelocity, IsTheTabledOne) {
  EXPECT_NEAR(carrying_slip(DragModel(SYAMLAL_OBRIEN, {Values{}}), 1, test::alumina_bed()), 3.5508, 6e-5);
  EXPECT_NEAR(carrying_slip(DragModel(SCHILLER_NAUMANN, {Values{}}), 1, test::alumina_bed()), 3.943726, 6e-7);
}

TEST(Drag, IsStokesWhereNothingSlips) {
  const double ergun = 150 * 0.58 / 0.42 / 18;   // of Stokes' at gas fraction 0.42
  EXPECT_DOUBLE_EQ(exchange(DragModel(SCHILLER_NAUMANN, {Values{}}), 1, 0), k_stokes);
  EXPECT_NEAR(exchange(DragModel(GIDASPOW, {Values{}}), 0.42, 0) / k_stokes, ergun, 1e-12 * ergun);
  EXPECT_DOUBLE_EQ(exchange(DragModel(GIDASPOW, {Values{}}), 1, 0), k_stokes);
  // C_D Re / 24 = 4.8^2 / 24 = 0.96 at v_r = 1; v_r tends to A = eps^4.14.
  EXPECT_NEAR(exchange(DragModel(SYAMLAL_OBRIEN, {Values{}}), 1, 0), 0.96 * k_stokes, 1e-12 * k_stokes);
  const double dense = 0.96 * 0.42 / std::pow(0.42, 4.14);
  EXPECT_NEAR(exchange(DragModel(SYAMLAL_OBRIEN, {Values{}}), 0.42, 0) / k_stokes, dense, 1e-11 * dense);
}

TEST(DragSyamlalOBrien, FitsTheSameConstantsInABedScaledByPowersOfTwo) {
  similitude_bed small = test::alumina_bed();
  small.particle_diameter = small.drag_diameter /= 4;
  small.gas_viscosity /= 8;
  const DragModel real(SYAMLAL_OBRIEN, {Values{{"minimum_fluidization_velocity", 0.36}}});
  const DragModel scaled(SYAMLAL_OBRIEN, {Values{{"minimum_fluidization_velocity", 0.18}}}, small);
  for (const State& state : k_states) {
    EXPECT_EQ(exchange(real, state.gas_fraction, state.slip), exchange(scaled, state.gas_fraction, state.slip));
  }
}

}  // namespace
}  // namespace similitude
