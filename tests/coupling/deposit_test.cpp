/// Solids on cells: nothing is lost, nothing crosses what is closed, the same bits for any number of threads.

#include <gtest/gtest.h>
#include <omp.h>

#include <limits>

#include "bed.h"
#include "coupling/cell_map.h"
#include "coupling/deposit.h"
#include "record.h"

namespace similitude::testing {
namespace {

constexpr double k_rounding = 1e-13;   // [-], sums of some thousand terms of one sign

double relative_error_of_volume(const ModelScene& scene, const ParticleStore& particles) {
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  coupling.start(particles);
  // 1 - eps loses digits where a cell is nearly empty: compare against the volume of the box.
  return std::abs(solids_volume(coupling, grid) - particle_volume(particles)) /
         (static_cast<double>(grid.cell_count()) * grid.cell_volume());
}

void expect_kept(const char* where, double error) {
  EXPECT_LT(error, k_rounding);
  test::record({std::string("volume of the solids on cells, ") + where, "volume of the particles", fmt::format("{:.1g} of the box", error), ""});
}

TEST(Deposit, KeepsTheVolumeOfParticlesAnywhereInAClosedBox) {
  const ModelScene scene = small_scene();
  expect_kept("anywhere in a closed box", relative_error_of_volume(scene, scattered(scene, 500)));
}

TEST(Deposit, KeepsTheVolumeInCornersOnEdgesAndOnFaces) {
  const ModelScene scene = small_scene();
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  for (const double x : {0.0, 0.5, 1.0})
    for (const double y : {0.0, 0.5, 1.0})
      for (const double z : {0.0, 0.5, 1.0}) add(particles, scene, {x * scene.size[0], y * scene.size[1], z * scene.size[2]});
  expect_kept("centres on walls, edges and corners", relative_error_of_volume(scene, particles));
}

TEST(Deposit, KeepsTheVolumeBesideBafflesOfEveryDirection) {
  double worst = 0;
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    ModelScene scene = small_scene();
    Baffle plate = plate_across(scene);
    plate.normal = axis;
    plate.position = 3 * scene.cell[static_cast<std::size_t>(axis)];
    for (std::size_t a = 0; a < 3; ++a) plate.extent[a] = {scene.cell[a], scene.size[a] - scene.cell[a]};
    plate.extent[static_cast<std::size_t>(axis)] = {plate.position, plate.position};
    scene.baffles = {plate};
    worst = std::max(worst, relative_error_of_volume(scene, scattered(scene, 500)));
  }
  expect_kept("beside baffles of all three directions", worst);
}

TEST(Deposit, KeepsTheVolumeOfParticlesLargerThanCells) {
  ModelScene scene = small_scene();
  scene.particles[0].diameter = scene.particles[0].drag_diameter = 9e-3;
  scene.smoothing_length = 18e-3;
  expect_kept("particles larger than cells", relative_error_of_volume(scene, scattered(scene, 20)));
}

TEST(Deposit, WrapsAroundPeriodicSeamsEvenForParticlesJustOutsideTheBox) {
  ModelScene scene = small_scene();
  scene.periodic = {true, true, true};
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling inside(scene, grid, drag.model(), true), outside(scene, grid, drag.model(), true);
  const double beyond = 0.3e-3;   // [m], a skin
  ParticleStore a(StoreFields{.rotation = false, .coupling = true}), b = a;
  add(a, scene, {scene.size[0] - beyond, beyond, scene.size[2] - beyond});
  add(b, scene, {-beyond, scene.size[1] + beyond, -beyond});
  inside.start(a);
  outside.start(b);
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    EXPECT_NEAR(inside.fields().gas_fraction[c], outside.fields().gas_fraction[c], k_rounding);
  }
  // Both sides of the seam hold the particle.
  EXPECT_LT(inside.fields().gas_fraction[grid.cell(0, 0, 0)], 1);
  EXPECT_LT(inside.fields().gas_fraction[grid.cell(7, 0, 10)], 1);
}

TEST(Deposit, KeepsTheVolumeInPeriodicBoxesOfOneOrTwoCells) {
  for (const int cells : {1, 2}) {
    ModelScene scene = small_scene();
    scene.periodic = {true, true, true};
    for (std::size_t a = 0; a < 3; ++a) scene.size[a] = cells * scene.cell[a];
    EXPECT_LT(relative_error_of_volume(scene, scattered(scene, 3)), k_rounding);
  }
}

// A floor-to-ceiling plate makes two beds: no trace of one may reach the other, by tent or by smoothing.
TEST(Deposit, LetsNothingThroughABaffle) {
  ModelScene scene = small_scene();
  scene.baffles = {plate_across(scene)};
  scene.smoothing_length = 30e-3;
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  for (int n = 0; n < 20; ++n) add(particles, scene, {19.9e-3, 0.5e-3 + n * 1e-3, 2e-3 + n * 3e-3});
  GasFields gas = gas_at_rest(grid);
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  for (int k = 0; k < grid.cells(2); ++k) {
    for (int j = 0; j < grid.cells(1); ++j) {
      for (int i = 4; i < grid.cells(0); ++i) {
        EXPECT_EQ(coupling.fields().gas_fraction[grid.cell(i, j, k)], 1.0);
        EXPECT_EQ(coupling.fields().exchange[grid.cell(i, j, k)], 0.0);
      }
    }
  }
  EXPECT_LT(coupling.fields().gas_fraction[grid.cell(3, 2, 5)], 1.0);
}

TEST(Deposit, GivesAParticleInACellCentreToThatCellAlone) {
  ModelScene scene = small_scene();
  scene.smoothing_length = 1e-3;   // less than the tent: no smoothing
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  add(particles, scene, {2.5 * scene.cell[0], 3.5 * scene.cell[1], 4.5 * scene.cell[2]});
  coupling.start(particles);
  EXPECT_EQ(coupling.smoothing_steps(), 0);
  const double expected = 1 - particle_volume(particles) / grid.cell_volume();
  EXPECT_NEAR(coupling.fields().gas_fraction[grid.cell(2, 3, 4)], expected, k_rounding);
  EXPECT_NEAR(coupling.fields().gas_fraction[grid.cell(1, 3, 4)], 1, k_rounding);
}

// Tent weights by hand: a quarter of a cell off centre gives a quarter to the neighbour.
TEST(Stencil, HasTheWeightsOfTheTent) {
  const ModelScene scene = small_scene();
  const Grid grid(scene);
  const CellMap map(grid);
  const Stencil s = map.stencil({2.75 * scene.cell[0], 3.5 * scene.cell[1], 4.25 * scene.cell[2], 0});
  double here = 0, east = 0, below = 0, both = 0;
  for (std::size_t m = 0; m < 8; ++m) {
    if (s.cell[m] == grid.cell(2, 3, 4)) here += s.weight[m];
    if (s.cell[m] == grid.cell(3, 3, 4)) east += s.weight[m];
    if (s.cell[m] == grid.cell(2, 3, 3)) below += s.weight[m];
    if (s.cell[m] == grid.cell(3, 3, 3)) both += s.weight[m];
  }
  EXPECT_NEAR(here, 0.75 * 0.75, k_rounding);
  EXPECT_NEAR(east, 0.25 * 0.75, k_rounding);
  EXPECT_NEAR(below, 0.75 * 0.25, k_rounding);
  EXPECT_NEAR(both, 0.25 * 0.25, k_rounding);
}

// Around the edge of a plate: what cannot step through it sideways stays on its own side in its own row.
TEST(Stencil, FoldsBackAtTheEndOfAPlate) {
  ModelScene scene = small_scene();
  Baffle plate = plate_across(scene);
  plate.extent[2] = {0, 5 * scene.cell[2]};
  scene.baffles = {plate};
  const Grid grid(scene);
  const CellMap map(grid);
  const Stencil under = map.stencil({3.9 * scene.cell[0], 2.5 * scene.cell[1], 4.9 * scene.cell[2], 0});
  for (std::size_t m = 0; m < 8; ++m) {
    if (under.weight[m] > 0) {
      EXPECT_LT(under.cell[m] % 8, 4u);   // nothing beyond the plate's plane
    }
  }
  const Stencil over = map.stencil({3.9 * scene.cell[0], 2.5 * scene.cell[1], 5.5 * scene.cell[2], 0});
  double beyond = 0;
  for (std::size_t m = 0; m < 8; ++m) beyond += over.cell[m] == grid.cell(4, 2, 5) ? over.weight[m] : 0;
  EXPECT_NEAR(beyond, 0.4, k_rounding);
}

class SameBits : public ::testing::Test {
 protected:
  void TearDown() override { omp_set_num_threads(before_); }
  int before_ = omp_get_max_threads();
};

TEST_F(SameBits, ForOneTwoAndThreeThreads) {
  ModelScene scene = small_scene();
  scene.baffles = {plate_across(scene)};
  scene.periodic = {false, true, false};
  const Grid grid(scene);
  const DragFromFunctions drag;
  const GasFields gas = rough_gas(grid);
  std::vector<ExchangeFields> results;
  std::vector<ParticleStore> beds;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    Coupling coupling(scene, grid, drag.model(), true);
    ParticleStore particles = scattered(scene, 700);
    coupling.start(particles);
    coupling.deposit(particles, gas, 1e-4);
    coupling.interpolate(particles, gas, 1e-4);
    coupling.settle_accounts(particles);
    coupling.deposit(particles, gas, 1e-4);
    coupling.interpolate(particles, gas, 1e-4);
    results.push_back(coupling.fields());
    beds.push_back(std::move(particles));
  }
  for (std::size_t n = 1; n < results.size(); ++n) {
    EXPECT_EQ(results[n].gas_fraction, results[0].gas_fraction);
    EXPECT_EQ(results[n].exchange, results[0].exchange);
    EXPECT_EQ(results[n].exchange_velocity, results[0].exchange_velocity);
    EXPECT_EQ(results[n].remainder, results[0].remainder);
    for (std::size_t p = 0; p < beds[0].size(); ++p) {
      EXPECT_EQ(beds[n].gas[p].x, beds[0].gas[p].x);
      EXPECT_EQ(beds[n].gas[p].w, beds[0].gas[p].w);
      EXPECT_EQ(beds[n].stress_force[p].z, beds[0].stress_force[p].z);
      EXPECT_EQ(beds[n].drag_impulse[p].y, beds[0].drag_impulse[p].y);
    }
  }
}

}  // namespace
}  // namespace similitude::testing
