// The bed as a porous medium: closed forms, balances, and what must not change a bit.
#include <gtest/gtest.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "bits.h"
#include "gas_run.h"
#include "porous_solver.h"
#include "spout.h"

namespace similitude {
namespace {

using test::Box;
using test::Spout;
using test::u;
using PorousRun = test::RunOf<porous::PorousSolver, porous::GasOptions>;

constexpr double k_density = 1.225, k_viscosity = 1.79e-5, k_cell = 0.01;   // [kg/m^3], [Pa s], [m]

PorousRun run_in(const Box& box, double tolerance = 1e-10) { return PorousRun(box, {.density = k_density, .tolerance = tolerance}); }
PorousRun run_in(const Spout& spout) { return run_in(spout.box, 1e-7); }

/// beta [kg/(m^3 s)] of Ergun (1952), spheres of 1 mm, model A.
double ergun(double fraction, double slip) {
  constexpr double d = 1e-3;
  const double solids = 1 - fraction;
  return 150 * solids * solids * k_viscosity / (fraction * d * d) + 1.75 * solids * k_density * slip / d;
}

struct Column {
  explicit Column(double superficial)
      : box({.cells = {3, 2, 30}, .spacing = {k_cell, k_cell, k_cell}}) {
    box.set_side(2, 0, box.velocity_patch("inlet", {0, 0, superficial}));
    box.set_side(2, 1, box.pressure_patch("outlet", 0));
  }
  Box box;
};

// dp/L = beta u_s/eps through a slab of the bed, gas before and after it.
TEST(PorousColumn, HasTheClosedFormPressureDrop) {
  const double superficial = 0.36, fraction = 0.4328, slip = superficial / fraction;
  Column set_up(superficial);
  PorousRun run = run_in(set_up.box);
  for (Index c = 0; c < run.mesh.cell_count; ++c) {
    const bool bed = c / 6 >= 5 && c / 6 < 25;
    run.gas_fraction[u(c)] = bed ? fraction : 1;
    run.exchange[u(c)] = bed ? ergun(fraction, slip) : 0;
  }
  run.gas_fraction_old = run.gas_fraction;
  for (int n = 0; n < 20; ++n) run.advance(1e-3);
  const double exact = ergun(fraction, slip) * slip / fraction;   // [Pa/m]
  EXPECT_NEAR((run.pressure_at({1, 1, 7}) - run.pressure_at({1, 1, 22})) / 0.15, exact, 1e-9 * exact);
  EXPECT_NEAR(run.stress_at(2, {1, 0, 15}), exact, 1e-8 * exact);
  // From end to end: 19 faces inside, half the resistance at the mean gas fraction on the first and the last, and a
  // thousandth of the bed's outside.
  const double narrowing = fraction / (0.5 * (1 + fraction));
  const double whole = (19 + narrowing * narrowing) * k_cell * exact;
  EXPECT_NEAR(run.pressure_at({1, 1, 0}), whole, 5e-4 * whole);
}

// Whatever the resistance does, the flux through a change of gas fraction is the same on every face.
TEST(PorousColumn, CarriesTheSameFluxThroughAJumpOfGasFraction) {
  Column set_up(1);
  PorousRun run = run_in(set_up.box, 1e-12);
  for (Index c = 0; c < run.mesh.cell_count; ++c) {
    run.gas_fraction[u(c)] = c / 6 < 15 ? 0.4 : 0.9;
    run.exchange[u(c)] = c / 6 < 15 ? 6000 : 100;
  }
  run.gas_fraction_old = run.gas_fraction;
  for (int n = 0; n < 5; ++n) run.advance(1e-3);
  for (Index k = 1; k < 30; ++k) {
    const double fraction = 0.5 * (run.gas_fraction[u(run.mesh.cell({1, 1, k - 1}))] + run.gas_fraction[u(run.mesh.cell({1, 1, k}))]);
    EXPECT_NEAR(fraction * run.solver.face_velocity(2)[u(run.mesh.face(2, {1, 1, k}))], 1, 1e-10) << k;
  }
}

// A given pressure across the bed and E from the velocity of the last step, as a host does it: eps G = beta(u) u. Without
// damping the error keeps its size here, with changing sign, as the drag is all but quadratic.
TEST(PorousColumn, FindsTheVelocityOfErgunsBedUnderAGivenPressure) {
  constexpr double fraction = 0.4, gradient = 1e6;   // [Pa/m]: a particle Reynolds number of thousands
  Box box({.cells = {2, 2, 10}, .spacing = {k_cell, k_cell, k_cell}});
  box.set_side(2, 0, box.pressure_patch("in", gradient * 10 * k_cell));
  box.set_side(2, 1, box.pressure_patch("out", 0));
  PorousRun run = run_in(box);
  std::fill(run.gas_fraction.begin(), run.gas_fraction.end(), fraction);
  run.gas_fraction_old = run.gas_fraction;
  const double slope = ergun(fraction, 1) - ergun(fraction, 0), start = ergun(fraction, 0);
  const double goal = (-start + std::sqrt(start * start + 4 * slope * fraction * gradient)) / (2 * slope);
  double error_before = 1e300;
  for (int n = 0; n < 25; ++n) {
    for (Index c = 0; c < run.mesh.cell_count; ++c) run.exchange[u(c)] = ergun(fraction, std::abs(run.velocity_at(2, {0, 0, 5})));
    run.advance(1e-3);
    const double error = std::abs(run.velocity_at(2, {1, 1, 5}) - goal) / goal;
    if (error > 1e-9) {
      EXPECT_LT(error, 0.55 * error_before) << n;
    }
    error_before = error;
  }
  EXPECT_LT(error_before, 1e-6);
}

// Gas in a bed that moves as a whole moves with it, whatever its resistance was a step ago.
TEST(PorousColumn, MovesWithABedThatMovesAsAWhole) {
  Box box({.cells = {4, 3, 5}, .spacing = {k_cell, k_cell, k_cell}, .periodic = {true, true, true}});
  PorousRun run = run_in(box);
  std::fill(run.gas_fraction.begin(), run.gas_fraction.end(), 0.5);
  run.gas_fraction_old = run.gas_fraction;
  for (const double exchange : {5000.0, 800.0, 20000.0}) {
    std::fill(run.exchange.begin(), run.exchange.end(), exchange);
    for (Index c = 0; c < run.mesh.cell_count; ++c) run.exchange_velocity[u(c)] = exchange * 0.3;
    run.advance(1e-3);
    for (Index c = 0; c < run.mesh.cell_count; ++c) EXPECT_NEAR(run.velocity[u(c)], 0.3, 1e-12);
  }
}

// The gas hands on all that it gets: drag and stress on the particles, with what is owed, sum to zero, as its own momentum
// is none. (The least resistance takes nothing where there are particles.)
TEST(PorousMomentum, PassesThroughTheGasToRounding) {
  Box box({.cells = {6, 5, 7}, .spacing = {0.01, 0.01, 0.02}, .periodic = {true, true, true}});
  PorousRun run = run_in(box);
  const std::size_t cells = u(run.mesh.cell_count);
  std::mt19937_64 engine(11);
  const auto fill = [&](std::vector<double>& field, double low, double high) {
    for (double& value : field) value = std::uniform_real_distribution<double>(low, high)(engine);
  };
  fill(run.gas_fraction, 0.4, 0.99);
  run.gas_fraction_old = run.gas_fraction;
  fill(run.exchange, 50, 2000);
  fill(run.exchange_velocity, -500, 500);
  fill(run.remainder, -50, 50);
  for (int n = 0; n < 60; ++n) run.advance(1e-3);   // until the damped resistance is the given one
  for (std::size_t a = 0; a < 3; ++a) {
    double given = 0, scale = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      const double drag = run.exchange[c] * run.velocity[a * cells + c];
      const double stress = (1 - run.gas_fraction[c]) * run.stress_force[a * cells + c];
      given += run.exchange_velocity[a * cells + c] + run.remainder[a * cells + c] - drag - stress;
      scale += std::abs(drag) + std::abs(stress) + std::abs(run.exchange_velocity[a * cells + c]);
    }
    EXPECT_NEAR(given, 0, 1e-13 * scale);
    EXPECT_EQ(run.report.momentum[a], 0);
  }
}

TEST(PorousMass, IsBalancedInEveryCellToTheToleranceWhileTheBedMoves) {
  const Spout spout;
  PorousRun gas = run_in(spout);
  for (int n = 0; n < 40; ++n) {
    spout.step(gas, n);
    EXPECT_LT(gas.report.mass_residual, 1.1e-7);
  }
}

TEST(PorousWalls, LetNothingThroughAndDoNotPullBesideAPlateUnderPressure) {
  Box box({.cells = {6, 1, 4}, .spacing = {0.005, 0.005, 0.005}});
  box.set_faces(0, 3, {0, 0, 0}, {0, 1, 4}, SIMILITUDE_FACE_NO_SLIP);
  box.set_faces(2, 4, {0, 0, 0}, {3, 1, 0}, box.pressure_patch("left", 500));
  box.set_faces(2, 4, {3, 0, 0}, {6, 1, 0}, box.pressure_patch("right", 0));
  PorousRun run = run_in(box);
  std::fill(run.exchange.begin(), run.exchange.end(), 5500.0);
  for (int n = 0; n < 3; ++n) run.advance(1e-3);
  for (Index k = 0; k < 4; ++k) EXPECT_EQ(run.solver.face_velocity(0)[u(run.mesh.face(0, {3, 0, k}))], 0);
  EXPECT_NEAR(run.pressure_at({2, 0, 1}), 500, 1e-4);
  EXPECT_NEAR(run.pressure_at({3, 0, 1}), 0, 1e-4);
  for (const Index i : {2, 3}) EXPECT_NEAR(run.stress_at(0, {i, 0, 1}), 0, 1e-6 * 500 / 0.005);
}

TEST(PorousClosedBox, StaysAtRestToTheBitIfNothingMoves) {
  Box box({.cells = {5, 3, 4}, .spacing = {0.01, 0.01, 0.01}});
  PorousRun run = run_in(box);
  for (const double exchange : {0.0, 5500.0}) {
    std::fill(run.exchange.begin(), run.exchange.end(), exchange);
    for (int n = 0; n < 3; ++n) run.advance(1e-3);
    for (const double velocity : run.velocity) EXPECT_EQ(velocity, 0);
    for (const double pressure : run.pressure) EXPECT_EQ(pressure, 0);
  }
}

TEST(PorousBits, AreTheSameForAnyNumberOfThreads) {
  test::expect_the_same_bits_for_any_number_of_threads([](const Spout& spout) { return run_in(spout); });
}

TEST(PorousBits, SurviveARestart) {
  test::expect_the_same_bits_after_a_restart([](const Spout& spout) { return run_in(spout); });
}

TEST(PorousBits, AreKeptByABedScaledByPowersOfTwo) {
  test::expect_the_same_bits_in_a_bed_scaled_by_powers_of_two([](const Spout& spout) { return run_in(spout); });
}

struct Cost {
  double seconds = 1;   // [s], of the fastest step
  int iterations = 0;   // at most
};

template <class Run>
Cost cost_of(const Spout& spout, Run gas) {
  Cost cost;
  for (int n = 0; n < 30; ++n) {
    const auto begin = std::chrono::steady_clock::now();
    spout.step(gas, n, 3e-4);
    cost.seconds = std::min(cost.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    if (n > 3) cost.iterations = std::max(cost.iterations, gas.report.iterations);
  }
  return cost;
}

// Both solvers in the same spouted bed of 24 000 cells, each at its default tolerance. The ratio is for the reader: a
// machine that does other things makes no test of it.
TEST(PorousPrice, IsAFewIterationsOfThePressureEquation) {
  const Spout spout({30, 4, 200});
  const Cost vans = cost_of(spout, test::GasRun(spout.box, {.density = k_density, .viscosity = k_viscosity}));
  const Cost porous = cost_of(spout, PorousRun(spout.box, {.density = k_density}));
  std::printf("24 000 cells, %d threads: vans %.2f ms a step, at most %d iterations; porous %.2f ms, %d; ratio %.2f\n",
              omp_get_max_threads(), vans.seconds * 1e3, vans.iterations, porous.seconds * 1e3, porous.iterations,
              porous.seconds / vans.seconds);
  EXPECT_LE(porous.iterations, 14);
}

}  // namespace
}  // namespace similitude
