/// The smoothing by itself: self-adjoint, conservative, as wide as it was asked to be.

#include <gtest/gtest.h>

#include "bed.h"
#include "coupling/cell_map.h"
#include "coupling/smoothing.h"

namespace similitude::testing {
namespace {

CellRows random_field(const CellMap& map, unsigned seed) {
  CellRows field(map.cell_count());
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (Row& r : field) r = {unit(random), unit(random), unit(random), unit(random)};
  return field;
}

double dot(const CellRows& a, const CellRows& b) {
  double sum = 0;
  for (std::size_t c = 0; c < a.size(); ++c) sum += a[c].x * b[c].x + a[c].y * b[c].y + a[c].z * b[c].z + a[c].w * b[c].w;
  return sum;
}

ModelScene scene_with_plate_and_seam() {
  ModelScene scene = small_scene();
  Baffle plate = plate_across(scene);
  plate.extent[2] = {2 * scene.cell[2], 7 * scene.cell[2]};
  scene.baffles = {plate};
  scene.periodic = {false, true, false};
  return scene;
}

TEST(Smoothing, IsSelfAdjoint) {
  const Grid grid(scene_with_plate_and_seam());
  const CellMap map(grid);
  Smoothing smoothing(map, 25e-3);
  const CellRows a = random_field(map, 1), b = random_field(map, 2);
  CellRows smooth_a = a, smooth_b = b;
  smoothing.apply(smooth_a);
  smoothing.apply(smooth_b);
  EXPECT_NEAR(dot(a, smooth_b) / dot(smooth_a, b), 1, 1e-14);
}

TEST(Smoothing, KeepsTheSumAndTheSign) {
  const Grid grid(scene_with_plate_and_seam());
  const CellMap map(grid);
  Smoothing smoothing(map, 40e-3);
  CellRows field(map.cell_count());
  field[grid.cell(3, 0, 4)] = {1, 2, 3, 4};
  smoothing.apply(field);
  Row sum;
  for (const Row& r : field) {
    EXPECT_GE(r.x, 0);
    sum.x += r.x;
    sum.w += r.w;
  }
  EXPECT_NEAR(sum.x, 1, 1e-14);
  EXPECT_NEAR(sum.w, 4, 4e-14);
}

TEST(Smoothing, LeavesAUniformFieldUntouchedToTheBit) {
  const Grid grid(scene_with_plate_and_seam());
  const CellMap map(grid);
  Smoothing smoothing(map, 40e-3);
  CellRows field(map.cell_count(), Row{0.3, -7.1, 1e-5, 13.2});
  smoothing.apply(field);
  for (const Row& r : field) {
    EXPECT_EQ(r.x, 0.3);
    EXPECT_EQ(r.w, 13.2);
  }
}

TEST(Smoothing, DampsTheChequerPatternWithoutTurningIt) {
  ModelScene scene = small_scene();
  scene.periodic = {true, true, false};
  const Grid grid(scene);
  const CellMap map(grid);
  Smoothing smoothing(map, 20e-3);
  CellRows field(map.cell_count());
  for (int k = 0; k < 11; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 8; ++i) field[grid.cell(i, j, k)].x = (i + j + k) % 2 ? -1 : 1;
  const CellRows before = field;
  smoothing.apply(field);
  const double kept = dot(before, field) / dot(before, before);
  EXPECT_GE(kept, 0);
  EXPECT_LT(kept, 0.01);
}

TEST(Smoothing, DoesNothingWhereTheTentIsWideEnough) {
  const Grid grid(small_scene());
  const CellMap map(grid);
  Smoothing smoothing(map, 3.8e-3);   // the tent of 4 mm counts as 0.961 x 4 mm wide, sqrt(8 ln 2 / 6) of the cell
  EXPECT_EQ(smoothing.steps(), 0);
}

/// [m], standard deviation along x of a deposit averaged over where in its cell the particle lies.
double deviation_of_kernel(double cell, double length) {
  ModelScene scene = small_scene();
  scene.cell = {cell, cell, cell};
  scene.size = {60 * cell, cell, cell};
  scene.periodic = {false, true, true};
  scene.smoothing_length = length;
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  const int places = 16;
  double variance = 0;
  for (int n = 0; n < places; ++n) {
    const double x = (30 + (n + 0.5) / places) * cell;
    ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
    add(particles, scene, {x, cell / 2, cell / 2});
    coupling.start(particles);
    double mass = 0, second = 0;
    for (int i = 0; i < 60; ++i) {
      const double solids = 1 - coupling.fields().gas_fraction[grid.cell(i, 0, 0)];
      mass += solids;
      second += solids * ((i + 0.5) * cell - x) * ((i + 0.5) * cell - x);
    }
    variance += second / mass / places;
  }
  return std::sqrt(variance);
}

// The full width at half maximum of a Gaussian is 2 sqrt(2 ln 2) standard deviations. The mean of the tent over 16 places in a
// cell is h^2/6 within h^2/(6*16^2): 2e-4 of the width here at most.
TEST(Smoothing, MakesKernelAndSmoothingTogetherAsWideAsAskedOnTwoGrids) {
  const double length = 18e-3;
  for (const double cell : {4e-3, 6e-3}) {
    EXPECT_NEAR(2 * std::sqrt(2 * std::numbers::ln2) * deviation_of_kernel(cell, length) / length, 1, 5e-4) << cell;
  }
}

TEST(Smoothing, IsThreeDiametersOfTheLargestClassUnlessGiven) {
  ModelScene scene = small_scene();
  scene.particles.push_back(scene.particles[0]);
  scene.particles[1].diameter = 6e-3;
  const Grid grid(scene);
  const DragFromFunctions drag;
  EXPECT_EQ(Coupling(scene, grid, drag.model(), true).smoothing_length(), 3 * 6e-3);
  scene.smoothing_length = 11e-3;
  EXPECT_EQ(Coupling(scene, grid, drag.model(), true).smoothing_length(), 11e-3);
}

}  // namespace
}  // namespace similitude::testing
