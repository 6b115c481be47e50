// Flow between parallel plates against its closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "record.h"
#include "gas_run.h"

namespace similitude {
namespace {

using test::Box;
using test::GasRun;
using test::u;

constexpr double k_height = 0.01;     // [m]
constexpr double k_viscosity = 1e-3;  // [Pa s]
constexpr double k_density = 1;       // [kg/m^3]

// MFIX test FLD01: plates 0.01 m apart, 240 Pa over 0.2 m: u = G/(2 mu) z (h - z), 15 m/s in the middle. A piece of 0.04 m
// of the same channel, between two pressure patches, is developed from end to end.
double channel_error(int cells_across) {
  constexpr double gradient = 240 / 0.2;  // [Pa/m]
  const double h = k_height / cells_across;
  Box box({.cells = {4, 1, cells_across}, .spacing = {0.01, 0.01, h}});
  box.set_side(1, 0, SIMILITUDE_FACE_SLIP);
  box.set_side(1, 1, SIMILITUDE_FACE_SLIP);
  box.set_side(0, 0, box.pressure_patch("in", gradient * 0.04));
  box.set_side(0, 1, box.pressure_patch("out", 0));
  GasRun run(box, {.density = k_density, .viscosity = k_viscosity, .tolerance = 1e-9});
  const double dt = std::min(0.9 * 3.0 / 8 * h * h * k_density / k_viscosity, 0.3 * 0.01 / 15);
  // 20 times the slowest decay time, h^2 / (pi^2 nu): what is left of the start is 2e-9.
  const int steps = static_cast<int>(20 * k_height * k_height * k_density / (9.87 * k_viscosity) / dt);
  for (int n = 0; n < steps; ++n) run.advance(dt);
  double squares = 0;
  for (Index k = 0; k < cells_across; ++k) {
    const double z = (static_cast<double>(k) + 0.5) * h;
    const double exact = gradient / (2 * k_viscosity) * z * (k_height - z);
    for (Index i = 0; i < 4; ++i) {
      const double error = run.velocity_at(0, {i, 0, k}) - exact;
      squares += error * error;
      EXPECT_NEAR(run.velocity_at(2, {i, 0, k}), 0, 1e-6 * 15);
    }
  }
  EXPECT_NEAR(run.pressure_at({0, 0, 0}), gradient * 0.035, 1e-5 * gradient * 0.04);
  return std::sqrt(squares / (4 * cells_across));
}

TEST(Poiseuille, ConvergesToTheParabolaAtSecondOrder) {
  const double coarse = channel_error(8), middle = channel_error(16), fine = channel_error(32);
  std::printf("errors %.3g %.3g %.3g m/s: factors %.3f %.3f\n", coarse, middle, fine, coarse / middle, middle / fine);
  test::record({"flow between plates (MFIX FLD01), 8 to 32 cells", "Poiseuille's parabola",
                fmt::format("order {:.2f}, {} of the fastest", std::log2(middle / fine), test::percent(fine / 15)), "MFIX order 2"});
  EXPECT_GT(coarse / middle, 3.6);  // 4 in the limit
  EXPECT_GT(middle / fine, 3.6);
  EXPECT_LT(fine, 0.005 * 15);
}

// A lid that slides at U over a resting floor: u = U z/h, linear, so that any second-order scheme has it exactly.
TEST(Couette, IsExactBehindASlidingLid) {
  constexpr int cells = 11;
  const double h = k_height / cells, lid = 2;
  Box box({.cells = {3, 1, cells}, .spacing = {0.01, 0.01, h}, .periodic = {true, true, false}});
  box.set_side(2, 1, box.velocity_patch("lid", {lid, 0, 0}));
  GasRun run(box, {.density = k_density, .viscosity = k_viscosity});
  const double dt = 0.3 * h * h * k_density / k_viscosity;
  EXPECT_LT(run.advance_until_steady(dt, 1e-10, 20000), 20000);
  test::Worst worst;   // [-], of the lid's speed
  for (Index k = 0; k < cells; ++k) {
    worst.see(run.velocity_at(0, {1, 0, k}) / lid - (static_cast<double>(k) + 0.5) / cells);
    EXPECT_NEAR(run.velocity_at(0, {1, 0, k}), lid * (static_cast<double>(k) + 0.5) / cells, 1e-7 * lid);
  }
  test::record({"flow behind a sliding lid", "Couette's straight line", test::percent(worst.value) + " of the lid's speed", ""});
}

// Free slip on both sides feels no wall at all.
TEST(SlipWalls, LeaveAUniformStreamUniform) {
  Box box({.cells = {6, 3, 5}, .spacing = {0.01, 0.01, 0.01}, .walls = SIMILITUDE_FACE_SLIP});
  box.set_side(0, 0, box.velocity_patch("in", {1, 0, 0}));
  box.set_side(0, 1, box.pressure_patch("out", 0));
  GasRun run(box, {.density = k_density, .viscosity = 1e-2, .tolerance = 1e-10});
  for (int n = 0; n < 100; ++n) run.advance(1e-3);
  for (Index c = 0; c < run.mesh.cell_count; ++c) {
    EXPECT_NEAR(run.velocity[u(c)], 1, 1e-8);
    EXPECT_NEAR(run.pressure[u(c)], 0, 1e-7);
  }
}

}  // namespace
}  // namespace similitude
