// Decaying vortices in a periodic box: u = sin x cos z, w = -cos x sin z, both times exp(-2 nu t). Taylor & Green 1937.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "record.h"
#include "gas_run.h"

namespace similitude {
namespace {

using test::Box;
using test::GasRun;
using test::u;

double vortex_error(int n, double viscosity, double end) {
  const double h = 2 * std::numbers::pi / n;
  Box box({.cells = {n, 1, n}, .spacing = {h, 1, h}, .periodic = {true, true, true}});
  GasRun run(box, {.density = 1, .viscosity = viscosity, .tolerance = 1e-9});
  run.set_velocity([](std::size_t axis, double x, double, double z) {
    return axis == 0 ? std::sin(x) * std::cos(z) : axis == 2 ? -std::cos(x) * std::sin(z) : 0;
  });
  const int steps = n * n / 8;  // the step falls with the square of the spacing, and so the time error with the space error
  for (int s = 0; s < steps; ++s) run.advance(end / steps);
  double squares = 0;
  for (Index k = 0; k < n; ++k) {
    for (Index i = 0; i < n; ++i) {
      const double x = static_cast<double>(i) * h, z = (static_cast<double>(k) + 0.5) * h;
      const double exact = std::sin(x) * std::cos(z) * std::exp(-2 * viscosity * end);
      const double error = run.solver.face_velocity(0)[u(run.mesh.face(0, {i, 0, k}))] - exact;
      squares += error * error;
    }
  }
  return std::sqrt(squares) / n;
}

TEST(TaylorGreen, DecaysAtSecondOrder) {
  const double coarse = vortex_error(16, 0.1, 1), middle = vortex_error(32, 0.1, 1), fine = vortex_error(64, 0.1, 1);
  std::printf("errors %.3g %.3g %.3g: factors %.2f %.2f\n", coarse, middle, fine, coarse / middle, middle / fine);
  test::record({"decaying vortices, 16 to 64 cells", "Taylor & Green 1937", fmt::format("order {:.2f}, {} of the velocity", std::log2(middle / fine), test::percent(fine)), ""});
  test::record_curve("taylor_green", "cells per side,error of velocity,second order", {{16, coarse, coarse}, {32, middle, coarse / 4}, {64, fine, coarse / 16}});
  // At least second order: 4. What is left on these grids falls faster, the limiter's clipping of extremes included.
  EXPECT_GT(coarse / middle, 4);
  EXPECT_GT(middle / fine, 4);
}

}  // namespace
}  // namespace similitude
