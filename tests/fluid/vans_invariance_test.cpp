// What must not change a bit: the number of threads, a restart, units scaled by powers of two.
#include <gtest/gtest.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "bits.h"
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
  test::expect_the_same_bits_for_any_number_of_threads([](const Spout& spout) { return run_in(spout); });
}

TEST(VansBits, SurviveARestart) {
  test::expect_the_same_bits_after_a_restart([](const Spout& spout) { return run_in(spout); });
}

TEST(VansBits, AreKeptByABedScaledByPowersOfTwo) {
  test::expect_the_same_bits_in_a_bed_scaled_by_powers_of_two([](const Spout& spout) { return run_in(spout); });
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
