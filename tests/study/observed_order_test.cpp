#include "study/observed_order.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace similitude;

namespace {

Estimate within(double value, double share) {
  Estimate e = exactly(value);
  e.low = value * (1 - share);
  e.high = value * (1 + share);
  return e;
}

/// Errors C h^p (against the step r: C (h^p - r^p)) of steps 4, 2 and 1 microseconds.
std::vector<OrderPoint> errors(double order, double reference, double noise) {
  std::vector<OrderPoint> points;
  for (const double h : {4e-6, 2e-6, 1e-6})
    points.push_back({h, within(1e4 * (std::pow(h, order) - std::pow(reference, order)), noise)});
  return points;
}

}  // namespace

// A minimum is found to the square root of rounding, relative to what it is a minimum of.
constexpr double k_of_a_minimum = 1e-5;

TEST(ObservedOrder, IsThatOfThePowerLaw) {
  for (const double order : {1.0, 1.5, 2.0, 4.0})
    EXPECT_NEAR(observed_order(errors(order, 0, 0.01), 0).value, order, k_of_a_minimum);
}

TEST(ObservedOrder, ErrorsAgainstTheFinestStepAreCorrectedForItsOwn) {
  for (const double order : {1.0, 2.0})
    EXPECT_NEAR(observed_order(errors(order, 0.5e-6, 0.01), 0.5e-6).value, order, k_of_a_minimum);
}

TEST(ObservedOrder, IntervalComesFromTheErrors) {
  // Two errors, 4 : 1 within 10 % each: log2(4 x 1.1/0.9) and log2(4 x 0.9/1.1).
  const std::vector<OrderPoint> points{{2, within(0.4, 0.1)}, {1, within(0.1, 0.1)}};
  const Estimate order = observed_order(points, 0);
  EXPECT_NEAR(order.value, 2, k_of_a_minimum);
  EXPECT_NEAR(order.low, std::log2(4 * 0.9 / 1.1), 1e-6);
  EXPECT_NEAR(order.high, std::log2(4 * 1.1 / 0.9), 1e-6);
}

TEST(ObservedOrder, ErrorsInTheNoiseGiveNone) {
  std::vector<OrderPoint> points = errors(1, 0, 0.01);
  points[1].error.low = points[2].error.low = 0;
  EXPECT_EQ(observed_order(points, 0).gap, "fewer than two errors stand out of the noise");
}
