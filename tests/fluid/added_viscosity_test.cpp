// Viscosity that something adds to the gas acts as molecular viscosity does.
#include <gtest/gtest.h>

#include <cmath>

#include "gas_run.h"

namespace similitude {
namespace {

using test::Box;
using test::GasRun;

/// A stirred box between walls and a baffle: every stress is there.
std::vector<double> stirred(double molecular, double added) {
  Box box({.cells = {8, 6, 7}, .spacing = {0.01, 0.02, 0.01}, .periodic = {true, false, false}});
  box.set_faces(2, 3, {2, 0, 0}, {5, 6, 0}, SIMILITUDE_FACE_NO_SLIP);
  GasRun run(box, {.density = 1.2, .viscosity = molecular});
  run.set_velocity([](std::size_t axis, double x, double y, double z) { return std::sin(40 * x + 30 * y + 20 * z + static_cast<double>(axis)); });
  const std::vector<double> everywhere(static_cast<std::size_t>(run.mesh.cell_count), added);
  for (int n = 0; n < 20; ++n) {
    similitude_gas_step step = run.row();
    step.dt = 1e-3;
    if (added > 0) step.added_viscosity = everywhere.data();
    run.report.struct_size = sizeof run.report;
    run.solver.advance(step, run.report);
  }
  return run.velocity;
}

TEST(AddedViscosity, ActsAsMolecularViscosityDoes) {
  const std::vector<double> molecular = stirred(8e-3, 0), half = stirred(4e-3, 4e-3), thin = stirred(4e-3, 0);
  double largest = 0, difference = 0, effect = 0;
  for (std::size_t c = 0; c < molecular.size(); ++c) {
    largest = std::max(largest, std::abs(molecular[c]));
    difference = std::max(difference, std::abs(molecular[c] - half[c]));
    effect = std::max(effect, std::abs(molecular[c] - thin[c]));
  }
  EXPECT_LT(difference, 1e-12 * largest);
  EXPECT_GT(effect, 1e-2 * largest);
}

}  // namespace
}  // namespace similitude
