// A law is a template over its number type, so a test calls it with plain doubles.
#include <gtest/gtest.h>

#include "@name@.h"

namespace {

constexpr @Type@ k_law{.exponent = 2.65};

/// Spheres of 1 mm in air, at a gas fraction and a slip speed [m/s].
similitude::DragState<double> spheres(double gas_fraction, double slip_speed) {
  return {.diameter = 1e-3,
          .gas_fraction = gas_fraction,
          .slip_speed = slip_speed,
          .gas_density = 1.225,
          .gas_viscosity = 1.79e-5};
}

TEST(@Type@, IsStokesDragOnASingleSphereAtRest) {
  const auto s = spheres(1.0, 0.0);
  EXPECT_DOUBLE_EQ(k_law.exchange(s), similitude::stokes_exchange(s));
}

// Wen & Yu: beta / phi = 0.75 C_D eps rho_f |u - v| / d eps^-2.65, with C_D at the superficial Reynolds number.
TEST(@Type@, IsWenAndYuBesideOtherParticles) {
  const auto s = spheres(0.6, 1.0);
  const double drag_coefficient = similitude::schiller_naumann(0.6 * particle_reynolds(s));
  EXPECT_NEAR(k_law.exchange(s) / similitude::sphere_volume(1e-3),
              0.75 * drag_coefficient * 0.6 * 1.225 * 1.0 / 1e-3 * std::pow(0.6, -2.65), 1e-9 * 3000);
}

}  // namespace
