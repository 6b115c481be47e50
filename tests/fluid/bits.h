#pragma once
/// What must not change a bit of a gas solver: the number of threads, a restart, units scaled by powers of two. `run_in` makes a
/// run of the solver in a spout.

#include <gtest/gtest.h>
#include <omp.h>

#include "spout.h"

namespace similitude::test {

template <class RunIn>
void expect_the_same_bits_for_any_number_of_threads(const RunIn& run_in) {
  const int before = omp_get_max_threads();
  std::vector<std::vector<double>> velocities, pressures;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    const Spout spout({13, 7, 97});  // large enough that work is shared
    auto run = run_in(spout);
    for (int n = 0; n < 10; ++n) spout.step(run, n);
    velocities.push_back(run.velocity);
    pressures.push_back(run.pressure);
  }
  omp_set_num_threads(before);
  for (const std::size_t other : {1u, 2u}) {
    EXPECT_EQ(velocities[0], velocities[other]);
    EXPECT_EQ(pressures[0], pressures[other]);
  }
}

template <class RunIn>
void expect_the_same_bits_after_a_restart(const RunIn& run_in) {
  const Spout spout;
  auto through = run_in(spout), resumed = run_in(spout);
  for (int n = 0; n < 6; ++n) spout.step(through, n);
  std::vector<double> state(through.solver.state_size());
  through.solver.save(state.data());
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

/// The exact scaling law at r = 1/4: length r, time and velocity r^1/2, viscosity r^3/2, pressure r, drag r^-1/2.
template <class RunIn>
void expect_the_same_bits_in_a_bed_scaled_by_powers_of_two(const RunIn& run_in) {
  const Spout real, model({13, 3, 37}, {.length = 0.25, .time = 0.5, .viscosity = 0.125, .exchange = 2});
  auto in_real = run_in(real), in_model = run_in(model);
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

}  // namespace similitude::test
