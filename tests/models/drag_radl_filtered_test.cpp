// Radl & Sundaresan (2014): Beetstra's drag times 1 - f h, f = 1 / (a L_c / cell + 1), L_c = d Fr_p^(1/3). What is inside is
// read off from very large cells, where f = 1, and from those of 5 mm. Below a solids fraction of 0.016 nothing is
// tested: the published a jumps there from 21.5 to 2.5.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "drag_model.h"

namespace similitude {
namespace {

using namespace test;

/// 1 - K over Beetstra's.
double correction(const DragModel& law, double phi, double cell_size) {
  static const DragModel beetstra(BEETSTRA, {Values{}});
  Particle particle{.gas_fraction = 1 - phi, .slip = 0.7};
  particle.cell_size = cell_size;
  return 1 - exchange(law, particle) / exchange(beetstra, particle);
}

/// h, the correction of cells that resolve nothing.
double reduction(const DragModel& law, double phi) { return correction(law, phi, 1e9); }

/// a L_c [m]: the cell at which half of h is reached.
double half_cell(const DragModel& law, double phi) {
  return k_cell_size * (reduction(law, phi) / correction(law, phi, k_cell_size) - 1);
}

constexpr double k_packed_size = 1.79;   // a from solids fraction 0.4 on

const DragModel& law() {
  static const DragModel model(RADL_FILTERED, {Values{}});
  return model;
}

TEST(DragRadlFiltered, FindsTheClustersOfAluminaFromItsTrueTerminalVelocity) {
  const double cluster = half_cell(law(), 0.5) / k_packed_size;
  const double froude = std::pow(cluster / k_diameter, 3);
  EXPECT_NEAR(std::sqrt(froude * 9.81 * k_diameter), 3.943726, 1e-6);   // u_t of the tables
  EXPECT_NEAR(froude, 1585.4, 0.05);
  EXPECT_NEAR(cluster, 11.660e-3, 1e-6);
}

// Stokes' 31.6 m/s is eight times the true velocity, and L_c goes with u_t^(2/3).
TEST(DragRadlFiltered, WithStokesHasMfixsLargerClusters) {
  const DragModel stokes(RADL_FILTERED, {Values{{"terminal_velocity", "stokes"}}});
  const double cluster = half_cell(stokes, 0.5) / k_packed_size;
  EXPECT_NEAR(cluster, 46.7e-3, 0.05e-3);
  EXPECT_NEAR(std::pow(cluster / k_diameter, 3), 1.02e5, 0.01e5);
  EXPECT_NEAR(correction(stokes, 0.4, k_cell_size) / correction(law(), 0.4, k_cell_size), 0.3, 0.02);
}

// The part of the drag that 1 mm alumina loses in cells of 5 mm, in per cent.
TEST(DragRadlFiltered, CorrectsAluminaInCellsOf5MillimetresByLittle) {
  EXPECT_NEAR(correction(law(), 0.02, k_cell_size), 0.02, 0.005);
  EXPECT_NEAR(correction(law(), 0.2, k_cell_size), 0.11, 0.005);
  EXPECT_NEAR(correction(law(), 0.4, k_cell_size), 0.18, 0.005);
  EXPECT_NEAR(correction(law(), 0.58, k_cell_size), 0.08, 0.005);
}

TEST(DragRadlFiltered, TendsToBeetstraInSmallCells) {
  for (const double phi : {0.02, 0.2, 0.4, 0.58}) {
    EXPECT_NEAR(correction(law(), phi, 1e-9), 0, 1e-6) << phi;
    EXPECT_NEAR(correction(law(), phi, 0), 0, 1e-15) << phi;
  }
}

// h at the published pieces' ends; its largest value leaves 6 % of the drag.
TEST(DragRadlFiltered, LosesMostOfTheDragInLargeCells) {
  const double table[][2] = {{0.02, 0.1594}, {0.03, 0.239}, {0.08, 0.492}, {0.12, 0.739}, {0.18, 0.887},
                             {0.34, 0.943},  {0.48, 0.850}, {0.55, 0.680}, {0.6, 0}};
  for (const auto& row : table) EXPECT_NEAR(reduction(law(), row[0] + 1e-9), row[1], 1e-6) << row[0];
}

TEST(DragRadlFiltered, IsContinuousToAHundredthWhereItsPiecesMeet) {
  for (const double phi : {0.03, 0.08, 0.12, 0.18, 0.34, 0.48, 0.55, 0.6}) {
    EXPECT_NEAR(reduction(law(), phi + 1e-9), reduction(law(), phi - 1e-9), 0.01) << phi;
  }
  const double cluster = half_cell(law(), 0.5) / k_packed_size;
  for (const double phi : {0.1, 0.18, 0.25, 0.4}) {
    EXPECT_NEAR(half_cell(law(), phi + 1e-9) / cluster, half_cell(law(), phi - 1e-9) / cluster, 0.01) << phi;
  }
  // -8.82, not -8.20, brings a to 1.785 here; -8.20 would give 1.878.
  EXPECT_NEAR(half_cell(law(), 0.4 - 1e-9) / cluster, 1.785, 5e-4);
}

TEST(DragRadlFiltered, RefusesABedInWhichNothingFalls) {
  for (const bool weightless : {true, false}) {
    similitude_bed bed = alumina_bed();
    (weightless ? bed.gravity : bed.particle_density) = 0;
    try {
      const DragModel refused(RADL_FILTERED, {Values{}}, bed);
      FAIL();
    } catch (const std::runtime_error& e) {
      EXPECT_STREQ(e.what(),
                   "radl_filtered needs particles that fall in their gas.\n"
                   "  Check scene.particles, scene.gas.density and scene.gravity, or use beetstra.");
    }
  }
}

}  // namespace
}  // namespace similitude
