// Drag laws against the table of beta/phi [kg/(m^3 s)] for d = 1 mm, rho_f = 1.225, mu = 1.79e-5, printed to five digits
// and rebuilt from the public codes' formulas; and against their limits.
#include <gtest/gtest.h>
#include <similitude/drag_law.h>

#include <cmath>
#include <vector>

#include "columns.h"
#include "plugin_file.h"

namespace similitude {
namespace {

using test::Column;
using test::Values;
using DragModel = test::TestModel<similitude_drag_functions>;

constexpr double k_diameter = 1e-3, k_density = 1.225, k_viscosity = 1.79e-5;
const double k_volume = sphere_volume(k_diameter);
const double k_stokes = 3 * k_pi * k_viscosity * k_diameter;

struct State {
  double gas_fraction, slip;
};
constexpr State k_states[] = {{0.4, 1}, {0.45, 0.8}, {0.6, 1}, {0.8, 2}, {0.8001, 2}, {0.85, 2}, {0.9, 3}, {0.99, 4}, {1, 3.5}};

/// K [kg/s] of one particle; the same state in all rows must give the same bits.
double exchange(const DragModel& law, double gas_fraction, double slip, double viscosity = k_viscosity) {
  Column d(8, k_diameter), eps(8, gas_fraction), u(8, slip), rho(8, k_density), mu(8, viscosity), k(8);
  const similitude_drag_block block = {sizeof block, 8,       d.data(), eps.data(), u.data(), rho.data(),
                                       mu.data(),    nullptr, nullptr,  k.data()};
  similitude_status status{};
  law.functions().exchange(law.instance(), &block, &status);
  EXPECT_EQ(status.code, 0) << status.text;
  for (std::size_t row = 1; row < 8; ++row) EXPECT_EQ(k[row], k[0]);
  return k[0];
}

double slip_for(double reynolds) { return reynolds * k_viscosity / (k_density * k_diameter); }

void expect_table(const DragModel& law, const std::vector<double>& beta_over_phi) {
  for (std::size_t s = 0; s < std::size(k_states); ++s) {
    const double value = exchange(law, k_states[s].gas_fraction, k_states[s].slip) / k_volume;
    EXPECT_NEAR(value, beta_over_phi[s], 1e-4 * beta_over_phi[s]) << "eps " << k_states[s].gas_fraction;
  }
}

/// The interstitial slip at which a bed of this gas fraction is carried: (beta/phi) u = eps (rho_p - rho_f) g.
double carrying_slip(const DragModel& law, double gas_fraction, const similitude_bed& bed) {
  const auto carried = [&](double slip) {
    Column d(8, bed.drag_diameter), eps(8, gas_fraction), u(8, slip), rho(8, bed.gas_density), mu(8, bed.gas_viscosity), k(8);
    const similitude_drag_block block = {sizeof block, 8,       d.data(), eps.data(), u.data(), rho.data(),
                                         mu.data(),    nullptr, nullptr,  k.data()};
    similitude_status status{};
    law.functions().exchange(law.instance(), &block, &status);
    return k[0] * slip > gas_fraction * (bed.particle_density - bed.gas_density) * bed.gravity * sphere_volume(bed.drag_diameter);
  };
  double low = 0, high = 100;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (carried(middle) ? high : low) = middle;
  }
  return high;
}

TEST(SingleSphere, HasSchillerAndNaumannsCoefficient) {
  const std::pair<double, double> table[] = {{0.1, 247.4},    {1, 27.6},        {10, 4.1511}, {100, 1.0917},
                                             {500, 0.56267}, {999, 0.43844}, {2000, 0.44}};
  for (const auto& [re, c] : table) EXPECT_NEAR(schiller_naumann(re), c, 1e-4 * c) << re;
}

TEST(SingleSphere, HasDallaVallesCoefficient) {
  const std::pair<double, double> table[] = {{0.1, 249.92}, {1, 29.485}, {10, 4.6134}, {100, 1.2321}, {500, 0.71345}, {1000, 0.61119}};
  for (const auto& [re, c] : table) EXPECT_NEAR(dalla_valle(re), c, 1e-4 * c) << re;
}

TEST(DragSyamlalOBrien, GivesTheTabledExchange) {
  expect_table(DragModel(SYAMLAL_OBRIEN, {Values{}}), {5510.9, 4272.8, 3563.3, 3798.1, 3797.4, 3504.2, 3732.9, 3226.2, 2842.2});
}

TEST(DragGidaspow, GivesTheTabledExchange) {
  expect_table(DragModel(GIDASPOW, {Values{}}), {6171.2, 4996.7, 3933.8, 4958.8, 2779.6, 2447.3, 2730.9, 2660.3, 2405.9});
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

TEST(MinimumFluidization, IsErgunsAndSyamlalOBriens) {
  const DragModel gidaspow(GIDASPOW, {Values{}}), syamlal(SYAMLAL_OBRIEN, {Values{}});
  const double table[][3] = {{0.40, 0.2916, 0.3311}, {0.42, 0.3326, 0.3704}, {0.44, 0.3759, 0.4123}, {0.46, 0.4215, 0.4568}};
  for (const auto& row : table) {
    EXPECT_NEAR(carrying_slip(gidaspow, row[0], test::alumina_bed()) * row[0], row[1], 6e-5);
    EXPECT_NEAR(carrying_slip(syamlal, row[0], test::alumina_bed()) * row[0], row[2], 6e-5);
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

// r = 1/4 of the exactly similar family: d 2^-2, u 2^-1, mu 2^-3, rho 1; K scales as r^(5/2) = 2^-5.
TEST(Drag, KeepsItsBitsInABedScaledByPowersOfTwo) {
  for (const char* file : {SYAMLAL_OBRIEN, GIDASPOW, SCHILLER_NAUMANN}) {
    const DragModel law(file, {Values{}});
    Column d(8, k_diameter), eps(8, 1), u(8), rho(8, k_density), mu(8, k_viscosity), k(8);
    Column small_d(8, k_diameter / 4), small_u(8), small_mu(8, k_viscosity / 8), small_k(8);
    for (std::size_t row = 0; row < 8; ++row) {
      eps[row] = k_states[row].gas_fraction;
      u[row] = 0.7 * k_states[row].slip;
      small_u[row] = u[row] / 2;
    }
    const similitude_drag_block real = {sizeof real, 8,       d.data(), eps.data(), u.data(), rho.data(),
                                        mu.data(),   nullptr, nullptr,  k.data()};
    const similitude_drag_block small = {sizeof small,    8,       small_d.data(), eps.data(),    small_u.data(), rho.data(),
                                         small_mu.data(), nullptr, nullptr,        small_k.data()};
    similitude_status status{};
    law.functions().exchange(law.instance(), &real, &status);
    law.functions().exchange(law.instance(), &small, &status);
    for (std::size_t row = 0; row < 8; ++row) EXPECT_EQ(small_k[row] * 32, k[row]) << file;
  }
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

TEST(Drag, NeedsNoFurtherColumns) {
  for (const char* file : {SYAMLAL_OBRIEN, GIDASPOW, SCHILLER_NAUMANN}) {
    const DragModel law(file, {Values{}});
    similitude_drag_needs needs = {sizeof needs, -1, -1};
    law.functions().needs(law.instance(), &needs);
    EXPECT_EQ(needs.sauter_diameter, 0);
    EXPECT_EQ(needs.cell_size, 0);
  }
}

}  // namespace
}  // namespace similitude
