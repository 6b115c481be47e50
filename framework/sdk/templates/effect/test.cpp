#include <gtest/gtest.h>

#include <numbers>

#include "@name@.h"

namespace {

TEST(@Type@, AddsItsShareOfStokesDrag) {
  similitude::Particle<double> sphere{};
  sphere.diameter = 1e-3;
  sphere.gas_viscosity = 1.79e-5;
  const double stokes = 3 * std::numbers::pi * 1.79e-5 * 1e-3;  // [kg/s]
  EXPECT_DOUBLE_EQ(@Type@{.share = 0.5}.particles(sphere).linear_coefficient, 0.5 * stokes);
  EXPECT_EQ(@Type@{.share = 0.5}.particles(sphere).force.x, 0);
}

}  // namespace
