// What the two advection schemes promise: orders of accuracy on a smooth wave, no new extremes at a step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "gas_run.h"

namespace similitude {
namespace {

using test::Box;
using test::GasRun;
using test::u;
using vans::Advection;

constexpr double k_length = 1, k_stream = 1;   // [m], [m/s]

/// A velocity w(x) across a uniform stream along x, carried once around a periodic box: no pressure arises, and without
/// viscosity to speak of w comes back as it was.
struct Carried {
  Carried(Advection scheme, int n, int steps, const std::function<double(double)>& shape)
      : box({.cells = {n, 1, 1}, .spacing = {k_length / n, 1, 1}, .periodic = {true, true, true}}),
        run(box, {.density = 1, .viscosity = 1e-12, .advection = scheme, .tolerance = 1e-9}) {
    run.set_velocity([&](std::size_t axis, double x, double, double) { return axis == 0 ? k_stream : axis == 2 ? shape(x) : 0; });
    for (int s = 0; s < steps; ++s) {
      run.advance(k_length / k_stream / steps);
      for (int i = 0; i < n; ++i) {
        lowest = std::min(lowest, w(i));
        highest = std::max(highest, w(i));
      }
    }
  }
  double w(int i) const { return run.solver.face_velocity(2)[u(run.mesh.face(2, {i, 0, 0}))]; }

  Box box;
  GasRun run;
  double lowest = 1e300, highest = -1e300;   // [m/s], at any time
};

double wave_error(Advection scheme, int n) {
  const auto shape = [](double x) { return std::sin(2 * std::numbers::pi * x / k_length); };
  const Carried wave(scheme, n, 4 * n, shape);   // a Courant number of a quarter
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += std::abs(wave.w(i) - shape((i + 0.5) * k_length / n));
  return sum / n;
}

/// Of the errors at 64, 128 and 256 cells, the order between the last two.
double observed_order(Advection scheme, const char* name) {
  const double coarse = wave_error(scheme, 64), middle = wave_error(scheme, 128), fine = wave_error(scheme, 256);
  const double order = std::log2(middle / fine);
  std::printf("%s: mean errors %.3g %.3g %.3g, orders %.2f %.2f\n", name, coarse, middle, fine, std::log2(coarse / middle), order);
  return order;
}

TEST(Advection, UpwindIsOfFirstOrder) {
  const double order = observed_order(Advection::upwind, "upwind");
  EXPECT_GT(order, 0.85);   // from below: numerical diffusion of |u| h/2 still damps the coarse waves
  EXPECT_LT(order, 1.1);
}

TEST(Advection, TvdIsOfSecondOrder) { EXPECT_GT(observed_order(Advection::tvd, "tvd"), 1.8); }

TEST(Advection, TvdIsFarMoreAccurateThanUpwind) {
  EXPECT_LT(20 * wave_error(Advection::tvd, 64), wave_error(Advection::upwind, 64));
}

class AdvectedStep : public testing::TestWithParam<Advection> {};

// 0, then 1, then 0: rounding aside nothing leaves [0, 1] on the whole way round.
TEST_P(AdvectedStep, MakesNoNewExtremes) {
  const Carried step(GetParam(), 80, 160, [](double x) { return x > 0.25 && x < 0.5 ? 1.0 : 0.0; });
  EXPECT_GT(step.lowest, -1e-9);
  EXPECT_LT(step.highest, 1 + 1e-9);
  double amount = 0;
  for (int i = 0; i < 80; ++i) amount += step.w(i) / 80;
  EXPECT_NEAR(amount, 0.25, 1e-9);   // and none is lost
}

INSTANTIATE_TEST_SUITE_P(Schemes, AdvectedStep, testing::Values(Advection::tvd, Advection::upwind),
                         [](const auto& info) { return info.param == Advection::tvd ? "tvd" : "upwind"; });

}  // namespace
}  // namespace similitude
