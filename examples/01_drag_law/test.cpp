// A law is a template over its number type, so a test calls it with plain doubles.
#include <gtest/gtest.h>

#include "di_felice.h"

namespace {

constexpr DiFelice k_law{.exponent = 3.7, .dip = 0.65};

/// Spheres of 1 mm in air, at a gas fraction and a slip speed [m/s].
similitude::DragState<double> spheres(double gas_fraction, double slip_speed) {
  return {.diameter = 1e-3,
          .gas_fraction = gas_fraction,
          .slip_speed = slip_speed,
          .gas_density = 1.225,
          .gas_viscosity = 1.79e-5};
}

/// beta / phi [kg/(m^3 s)], as the literature tabulates it.
double beta_over_phi(double gas_fraction, double slip_speed) {
  return k_law.exchange(spheres(gas_fraction, slip_speed)) / similitude::sphere_volume(1e-3);
}

// The paper's formulas, evaluated apart from this code, to five digits: 0.75 C_D rho_f u eps^(2-chi) / d with
// C_D = (0.63 + 4.8/sqrt(Re))^2.
TEST(DiFelice, FollowsItsFormulaFromDenseToDilute) {
  EXPECT_NEAR(beta_over_phi(0.4, 1.0), 5764.5, 0.05);
  EXPECT_NEAR(beta_over_phi(0.6, 1.0), 2993.9, 0.05);
  EXPECT_NEAR(beta_over_phi(0.85, 2.0), 2558.3, 0.05);
  EXPECT_NEAR(beta_over_phi(1.0, 3.5), 2842.2, 0.05);
}

// No slip: what is left is Stokes' drag with Dalla Valle's 4.8^2/24 = 0.96 and the full exponent.
TEST(DiFelice, IsFiniteAtRest) {
  const auto s = spheres(0.5, 0.0);
  EXPECT_DOUBLE_EQ(k_law.exchange(s), 0.96 * similitude::stokes_exchange(s) * std::pow(0.5, 1 - 3.7));
}

}  // namespace
