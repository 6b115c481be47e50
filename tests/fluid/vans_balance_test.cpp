// What the gas solver must balance: mass, momentum with the particles, nothing through walls.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "gas_run.h"

namespace similitude {
namespace {

using test::Box;
using test::GasRun;
using test::u;

constexpr vans::GasOptions k_air{.density = 1.225, .viscosity = 1.79e-5, .tolerance = 1e-10};

class Random {
 public:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  void fill(std::vector<double>& field, double low, double high) {
    for (double& value : field) value = between(low, high);
  }

 private:
  std::mt19937_64 engine_{11};
};

double sum_of(const std::vector<double>& field, std::size_t axis, std::size_t cells) {
  double sum = 0;
  for (std::size_t c = 0; c < cells; ++c) sum += field[axis * cells + c];
  return sum;
}

// Model A: the gas loses E u - (E v) - R to the particles and, with the stress on what is immersed, eps (-grad p + div tau)
// plus (1 - eps) (-grad p + div tau) over all cells must vanish. Everything else is transport, which sums to zero.
// Model B: the stress sums to zero over the gas alone, and particles get none.
class VansMomentum : public testing::TestWithParam<vans::Momentum> {};

TEST_P(VansMomentum, ChangesInAPeriodicBoxByExactlyWhatParticlesGiveAndTake) {
  Box box({.cells = {6, 5, 7}, .spacing = {0.01, 0.01, 0.02}, .periodic = {true, true, true}});
  vans::GasOptions syrup = k_air;
  syrup.viscosity = 1e-3;
  syrup.momentum = GetParam();
  GasRun run(box, syrup);
  Random random;
  const std::size_t cells = u(run.mesh.cell_count);
  const double volume = run.mesh.cell_volume(), dt = 2e-3;
  random.fill(run.gas_fraction_old, 0.4, 0.99);
  run.set_velocity([&](std::size_t, double, double, double) { return random.between(-1, 1); });
  std::array<double, 3> momentum{};
  for (int n = 0; n < 20; ++n) {
    random.fill(run.gas_fraction, 0.4, 0.99);
    random.fill(run.exchange, 0, 2000);
    random.fill(run.exchange_velocity, -500, 500);
    random.fill(run.remainder, -50, 50);
    double excess = 0;  // the gas must keep its volume: what one cell gains others lose
    for (std::size_t c = 0; c < cells; ++c) excess += run.gas_fraction[c] - run.gas_fraction_old[c];
    for (double& fraction : run.gas_fraction) fraction -= excess / static_cast<double>(cells);
    const std::vector<double> fraction = run.gas_fraction;
    run.advance(dt);
    EXPECT_LT(run.report.mass_residual, 1e-9);
    for (std::size_t a = 0; a < 3; ++a) {
      double given = sum_of(run.exchange_velocity, a, cells) + sum_of(run.remainder, a, cells);
      double scale = 0;
      for (std::size_t c = 0; c < cells; ++c) {
        const double drag = run.exchange[c] * run.velocity[a * cells + c];
        const double stress = (1 - fraction[c]) * run.stress_force[a * cells + c];
        given -= drag + stress;
        scale += std::abs(drag) + std::abs(stress) + std::abs(run.exchange_velocity[a * cells + c]);
      }
      if (n > 0) {
        EXPECT_NEAR(run.report.momentum[a] - momentum[a], given * volume * dt, 1e-13 * scale * volume * dt);
      }
      momentum[a] = run.report.momentum[a];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, VansMomentum, testing::Values(vans::Momentum::model_a, vans::Momentum::model_b),
                         [](const auto& info) { return info.param == vans::Momentum::model_a ? "model_a" : "model_b"; });

TEST(VansMass, IsBalancedInEveryCellToTheToleranceWhileTheBedMoves) {
  Box box({.cells = {12, 3, 20}, .spacing = {0.005, 0.005, 0.005}});
  const std::uint8_t inlet = box.velocity_patch("inlet", {0, 0, 2}, 0.01);
  box.set_side(2, 0, inlet);
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  box.set_faces(0, 4, {0, 0, 3}, {0, 3, 10}, SIMILITUDE_FACE_NO_SLIP);
  vans::GasOptions options = k_air;
  options.tolerance = 1e-7;
  GasRun run(box, options);
  for (int n = 0; n < 60; ++n) {
    for (Index c = 0; c < run.mesh.cell_count; ++c) {
      const auto k = static_cast<double>(c / (12 * 3));
      const double fraction = k < 8 ? 0.5 + 0.05 * std::sin(0.3 * n + static_cast<double>(c % 12)) : 0.98;
      run.gas_fraction[u(c)] = fraction;
      run.exchange[u(c)] = k < 8 ? 5500 : 20;
    }
    if (n == 0) run.gas_fraction_old = run.gas_fraction;
    run.advance(5e-4);
    EXPECT_LT(run.report.mass_residual, 1.1e-7);
  }
  const double inflow = 1.225 * 2 * 12 * 3 * 0.005 * 0.005;
  EXPECT_NEAR(run.report.inflow, inflow, 1e-12 * inflow);
  // The outflow differs from the inflow by what the moving bed displaces.
  EXPECT_NEAR(run.report.outflow, inflow, 0.5 * inflow);
}

TEST(VansWalls, LetNothingThrough) {
  Box box({.cells = {8, 2, 8}, .spacing = {0.01, 0.01, 0.01}});
  box.set_side(0, 0, box.velocity_patch("inlet", {1, 0, 0}));
  box.set_side(0, 1, box.pressure_patch("outlet", 0));
  box.set_faces(0, 4, {0, 0, 0}, {0, 2, 5}, SIMILITUDE_FACE_NO_SLIP);
  GasRun run(box, k_air);
  for (int n = 0; n < 50; ++n) run.advance(1e-3);
  double through_gap = 0;
  for (Index k = 0; k < 8; ++k) {
    for (Index j = 0; j < 2; ++j) {
      const double velocity = run.solver.face_velocity(0)[u(run.mesh.face(0, {4, j, k}))];
      if (k < 5) {
        EXPECT_EQ(velocity, 0);
      }
      through_gap += velocity;
    }
  }
  EXPECT_NEAR(through_gap, 16, 1e-7 * 16);
  for (Index i = 0; i < 8; ++i) EXPECT_EQ(run.solver.face_velocity(2)[u(run.mesh.face(2, {i, 0, 0}))], 0);
}

// A plate with 500 Pa across and gas at rest: the gradient along the plate's normal is one-sided and zero on both sides.
TEST(VansStress, DoesNotPullAtAParticleBesideAPlateUnderPressure) {
  Box box({.cells = {6, 1, 4}, .spacing = {0.005, 0.005, 0.005}});
  box.set_faces(0, 3, {0, 0, 0}, {0, 1, 4}, SIMILITUDE_FACE_NO_SLIP);
  box.set_faces(2, 4, {0, 0, 0}, {3, 1, 0}, box.pressure_patch("left", 500));
  box.set_faces(2, 4, {3, 0, 0}, {6, 1, 0}, box.pressure_patch("right", 0));
  GasRun run(box, k_air);
  for (int n = 0; n < 3; ++n) run.advance(1e-3);
  EXPECT_NEAR(run.pressure_at({2, 0, 1}), 500, 1e-4);
  EXPECT_NEAR(run.pressure_at({3, 0, 1}), 0, 1e-4);
  for (const Index i : {2, 3}) {
    for (const std::size_t axis : {std::size_t{0}, std::size_t{2}}) {
      EXPECT_NEAR(run.stress_at(axis, {i, 0, 1}), 0, 1e-6 * 500 / 0.005);
    }
  }
}

TEST(VansClosedBox, MovesGasOutOfTheWayOfSinkingParticles) {
  Box box({.cells = {5, 3, 10}, .spacing = {0.01, 0.01, 0.01}});
  GasRun run(box, k_air);
  const auto layer = [&](int n) {
    for (Index c = 0; c < run.mesh.cell_count; ++c) {
      const double z = static_cast<double>(c / 15) - 6 + 0.05 * n;
      run.gas_fraction[u(c)] = 1 - 0.4 * std::exp(-z * z);
    }
    double sum = 0;
    for (const double fraction : run.gas_fraction) sum += fraction;
    for (double& fraction : run.gas_fraction) fraction *= 140 / sum;
  };
  layer(0);
  run.gas_fraction_old = run.gas_fraction;
  for (int n = 1; n < 40; ++n) {
    layer(n);
    run.advance(2e-3);
    EXPECT_LT(run.report.mass_residual, 1e-8);
  }
  EXPECT_GT(run.velocity_at(2, {2, 1, 5}), 0.01);  // upward
}

TEST(VansClosedBox, StaysAtRestToTheBitIfNothingMoves) {
  Box box({.cells = {5, 3, 4}, .spacing = {0.01, 0.01, 0.01}});
  GasRun run(box, k_air);
  std::fill(run.exchange.begin(), run.exchange.end(), 5500.0);
  for (int n = 0; n < 5; ++n) run.advance(1e-3);
  for (const double velocity : run.velocity) EXPECT_EQ(velocity, 0);
  for (const double pressure : run.pressure) EXPECT_EQ(pressure, 0);
  EXPECT_EQ(run.report.iterations, 0);
}

TEST(VansClosedBox, RefusesAnInletWithoutAnOutletInWords) {
  Box box({.cells = {4, 1, 4}});
  box.set_side(2, 0, box.velocity_patch("spout", {0, 0, 1}));
  try {
    vans::GasSolver solver(box.table(), k_air);
    FAIL() << "was accepted";
  } catch (const std::invalid_argument& problem) {
    EXPECT_STREQ(problem.what(),
                 "patch spout blows into a region without an opening: the gas has nowhere to go.\n"
                 "  Add a patch of given pressure, e.g. outlet: {face: top, pressure: 0 Pa}.");
  }
}

TEST(VansPressure, SaysWhatToDoIfItDoesNotConverge) {
  Box box({.cells = {12, 1, 24}, .spacing = {0.01, 0.01, 0.01}});
  box.set_faces(2, 0, {0, 0, 0}, {2, 1, 0}, box.velocity_patch("inlet", {0, 0, 1}));
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  vans::GasOptions options = k_air;
  options.most_iterations = 1;
  GasRun run(box, options);
  try {
    run.advance(1e-3);
    FAIL() << "converged";
  } catch (const std::runtime_error& problem) {
    const std::string text = problem.what();
    EXPECT_EQ(text.find("the pressure equation did not converge: a cell's mass balance is off by "), 0u) << text;
    EXPECT_NE(text.find(" of the throughput after 1 iterations (wanted: 1e-10)."), std::string::npos) << text;
    EXPECT_NE(text.find("\n  Use a smaller time.gas_dt, or raise models.fluid.iterations."), std::string::npos) << text;
  }
}

TEST(VansStability, HoldsAJetAtACourantNumberNearOne) {
  Box box({.cells = {16, 1, 32}, .spacing = {0.01, 0.01, 0.01}});
  box.set_faces(2, 0, {6, 0, 0}, {10, 1, 0}, box.velocity_patch("jet", {0, 0, 10}));
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  vans::GasOptions options = k_air;
  options.tolerance = 1e-7;
  GasRun run(box, options);
  double largest = 0, courant = 0;
  for (int n = 0; n < 600; ++n) {
    run.advance(0.6e-3);
    courant = std::max(courant, run.report.courant);
    for (const double velocity : run.velocity) largest = std::max(largest, std::abs(velocity));
  }
  std::printf("largest Courant number %.2f, largest velocity %.2f m/s\n", courant, largest);
  EXPECT_LT(largest, 1.5 * 10);  // no energy from nowhere: the jet is the fastest, but for its contraction
}

// E dt / (eps rho) = 1e6: the gas takes the particles' velocity at once and nothing oscillates.
TEST(VansStability, FollowsTheParticlesUnderStiffDrag) {
  Box box({.cells = {5, 4, 6}, .spacing = {0.01, 0.01, 0.01}, .periodic = {true, true, true}});
  GasRun run(box, k_air);
  const double dt = 1e-3, exchange = 1e6 * 0.5 * 1.225 / dt;
  std::fill(run.gas_fraction.begin(), run.gas_fraction.end(), 0.5);
  run.gas_fraction_old = run.gas_fraction;
  std::fill(run.exchange.begin(), run.exchange.end(), exchange);
  for (Index c = 0; c < run.mesh.cell_count; ++c) run.exchange_velocity[u(c)] = exchange * 0.3;
  for (int n = 0; n < 10; ++n) {
    run.advance(dt);
    for (Index c = 0; c < run.mesh.cell_count; ++c) EXPECT_NEAR(run.velocity[u(c)], 0.3, 0.3 * 2e-6);
  }
}

}  // namespace
}  // namespace similitude
