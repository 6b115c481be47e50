// Lid-driven cavity against Ghia, Ghia & Shin 1982 (data/README.md): within 2 % of the lid speed on 64 x 64 cells.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "record.h"
#include "gas_run.h"

namespace similitude {
namespace {

using test::Box;
using test::GasRun;
using test::u;

constexpr int k_cells = 64;

struct Point {
  double position, value;
};

/// The first block of a file: Ghia's points.
std::vector<Point> ghia(const char* component, int reynolds) {
  char name[64];
  std::snprintf(name, sizeof name, "/fld03_%s_re%05d.dat", component, reynolds);
  std::ifstream file(std::string(SIMILITUDE_CAVITY_DATA) + name);
  std::vector<Point> points;
  for (std::string line; std::getline(file, line);) {
    if (line.find("MFIX") != std::string::npos) break;
    std::istringstream text(line);
    Point point{};
    if (text >> point.position >> point.value) points.push_back(point);
  }
  return points;
}

/// Values at cell centres of a unit length, continued linearly to the walls.
double between_cells(const std::vector<double>& values, double position, double low_wall, double high_wall) {
  const double where = position * k_cells - 0.5;
  const int cell = static_cast<int>(std::floor(where));
  const auto value = [&](int n) {
    return n < 0 ? 2 * low_wall - values[0] : n >= k_cells ? 2 * high_wall - values[k_cells - 1] : values[u(n)];
  };
  const double share = where - cell;
  return (1 - share) * value(cell) + share * value(cell + 1);
}

void compare(int reynolds, double end) {
  Box box({.cells = {k_cells, 1, k_cells}, .spacing = {1.0 / k_cells, 1, 1.0 / k_cells}, .periodic = {false, true, false}});
  box.set_side(2, 1, box.velocity_patch("lid", {1, 0, 0}));
  const double viscosity = 1.0 / reynolds;
  GasRun run(box, {.density = 1, .viscosity = viscosity, .tolerance = 1e-6});
  const double dt = std::min(0.7 / k_cells, 0.9 * 3.0 / 16 / (viscosity * k_cells * k_cells));
  while (run.time < end) run.advance(dt);
  const std::vector<double> settled = run.velocity;
  run.advance(dt);
  double change = 0;
  for (std::size_t c = 0; c < settled.size(); ++c) change = std::max(change, std::abs(run.velocity[c] - settled[c]));
  EXPECT_LT(change / dt, 2e-3);  // lid speeds per time the lid needs to pass once: steady

  std::vector<double> across, upward;
  for (Index n = 0; n < k_cells; ++n) {
    across.push_back(run.solver.face_velocity(0)[u(run.mesh.face(0, {k_cells / 2, 0, n}))]);
    upward.push_back(run.solver.face_velocity(2)[u(run.mesh.face(2, {n, 0, k_cells / 2}))]);
  }
  double worst_across = 0, worst_upward = 0;
  std::vector<std::array<double, 3>> curve;
  for (const Point& point : ghia("ug", reynolds)) {
    const double here = between_cells(across, point.position, 0, 1);
    worst_across = std::max(worst_across, std::abs(here - point.value));
    curve.push_back({point.position, here, point.value});
    EXPECT_NEAR(here, point.value, 0.02) << "u at y " << point.position;
  }
  for (const Point& point : ghia("vg", reynolds)) {
    if (reynolds == 400 && std::abs(point.value + 0.23827) < 1e-6) continue;  // a misprint: data/README.md
    const double here = between_cells(upward, point.position, 0, 0);
    worst_upward = std::max(worst_upward, std::abs(here - point.value));
    EXPECT_NEAR(here, point.value, 0.02) << "v at x " << point.position;
  }
  test::record({fmt::format("lid-driven cavity, Re {}, 64 x 64", reynolds), "Ghia et al. 1982",
                fmt::format("{:.3f} (u), {:.3f} (v) of the lid's speed", worst_across, worst_upward), "MFIX 0.003 to 0.010 on 128 x 128"});
  test::record_curve(fmt::format("cavity_{}", reynolds), "height over the floor,u / lid,Ghia et al. (1982)", curve);
  std::printf("Re %d: largest differences u %.4f, v %.4f; change %.1e\n", reynolds, worst_across, worst_upward, change / dt);
}

TEST(LidDrivenCavity, AgreesWithGhiaAtReynolds100) { compare(100, 15); }
TEST(LidDrivenCavity, AgreesWithGhiaAtReynolds400) { compare(400, 35); }
TEST(LidDrivenCavity, AgreesWithGhiaAtReynolds1000) { compare(1000, 60); }

}  // namespace
}  // namespace similitude
