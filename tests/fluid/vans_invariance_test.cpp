// What must not change a bit: the number of threads, a restart, units scaled by powers of two.
#include <gtest/gtest.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "gas_run.h"
#include "spout.h"

namespace similitude {
namespace {

using test::GasRun;
using test::Spout;
using test::u;

GasRun run_in(const Spout& spout) {
  return GasRun(spout.box, {.density = 1.225, .viscosity = 1.79e-5 * spout.units.viscosity, .tolerance = 1e-7});
}

TEST(VansBits, AreTheSameForAnyNumberOfThreads) {
  const int before = omp_get_max_threads();
  std::vector<std::vector<double>> velocities, pressures;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    const Spout spout({13, 7, 97});  // large enough that work is shared
    GasRun gas = run_in(spout);
    for (int n = 0; n < 10; ++n) spout.step(gas, n);
    velocities.push_back(gas.velocity);
    pressures.push_back(gas.pressure);
  }
  omp_set_num_threads(before);
  for (const std::size_t other : {1u, 2u}) {
    EXPECT_EQ(velocities[0], velocities[other]);
    EXPECT_EQ(pressures[0], pressures[other]);
  }
}

TEST(VansBits, SurviveARestart) {
  const Spout spout;
  GasRun through = run_in(spout);
  std::vector<double> state;
  for (int n = 0; n < 12; ++n) {
    if (n == 6) break;
    spout.step(through, n);
  }
  state.resize(through.solver.state_size());
  through.solver.save(state.data());
  GasRun resumed = run_in(spout);
  resumed.solver.load(state.data());
  resumed.time = through.time;
  resumed.gas_fraction_old = through.gas_fraction_old;
  resumed.velocity = through.velocity;
  resumed.pressure = through.pressure;
  for (int n = 6; n < 12; ++n) {
    spout.step(through, n);
    spout.step(resumed, n);
  }
  EXPECT_EQ(through.velocity, resumed.velocity);
  EXPECT_EQ(through.pressure, resumed.pressure);
  EXPECT_EQ(through.stress_force, resumed.stress_force);
}

// The exact scaling law at r = 1/4: length r, time and velocity r^1/2, viscosity r^3/2, pressure r, drag r^-1/2.
TEST(VansBits, AreKeptByABedScaledByPowersOfTwo) {
  const Spout real, model({13, 3, 37}, {.length = 0.25, .time = 0.5, .viscosity = 0.125, .exchange = 2});
  GasRun in_real = run_in(real), in_model = run_in(model);
  for (int n = 0; n < 15; ++n) {
    real.step(in_real, n);
    model.step(in_model, n);
    ASSERT_EQ(in_real.report.iterations, in_model.report.iterations);
  }
  for (std::size_t row = 0; row < in_real.velocity.size(); ++row) {
    ASSERT_EQ(in_real.velocity[row] * 0.5, in_model.velocity[row]) << row;
    ASSERT_EQ(in_real.stress_force[row], in_model.stress_force[row]) << row;
  }
  for (std::size_t row = 0; row < in_real.pressure.size(); ++row) ASSERT_EQ(in_real.pressure[row] * 0.25, in_model.pressure[row]);
  EXPECT_EQ(in_real.report.mass_residual, in_model.report.mass_residual);
  EXPECT_EQ(in_real.report.courant, in_model.report.courant);
}

TEST(VansSizes, MayBeOddOrASingleCell) {
  for (const std::array<int, 3> cells : {std::array{7, 1, 13}, std::array{5, 3, 9}, std::array{31, 1, 5}}) {
    const Spout spout(cells);
    GasRun gas = run_in(spout);
    for (int n = 0; n < 10; ++n) {
      spout.step(gas, n, 2e-4);
      EXPECT_LT(gas.report.mass_residual, 1.1e-7);
    }
  }
}

TEST(VansPressure, TakesAFewIterationsInTheSpoutedBedOf24000Cells) {
  const Spout spout({30, 4, 200});
  GasRun gas = run_in(spout);
  double best = 1;
  int iterations = 0;
  for (int n = 0; n < 30; ++n) {
    const auto begin = std::chrono::steady_clock::now();
    spout.step(gas, n, 3e-4);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    iterations = std::max(iterations, gas.report.iterations);
  }
  std::printf("24 000 cells: %.2f ms a step with %d threads, at most %d iterations, Courant number %.2f\n", best * 1e3,
              omp_get_max_threads(), iterations, gas.report.courant);
  EXPECT_LE(iterations, 14);
}

}  // namespace
}  // namespace similitude
