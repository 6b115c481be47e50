#include "output/monitors.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scratch.h"

using namespace similitude;
using namespace similitude::test;

namespace {

/// `layers` of `across` particles each, one diameter apart.
ParticleStore level_bed(int layers, int across, double diameter) {
  ParticleStore store;
  std::uint64_t id = 0;
  for (int k = 0; k < layers; ++k)
    for (int i = 0; i < across; ++i)
      store.add(id++, 0, diameter * (i + 0.5), 0.005, diameter * (k + 0.5), diameter / 2, 1e-6);
  return store;
}

}  // namespace

TEST(BedHeight, OfALevelBedIsItsHeight) {
  EXPECT_NEAR(expanded_bed_height(level_bed(100, 1, 1e-3)), 0.1, 1e-15);
  EXPECT_NEAR(expanded_bed_height(level_bed(100, 10, 1e-3)), 0.1, 0.5e-3);  // half a layer, where the 95 % fall inside one
}

TEST(BedHeight, IsNotMovedByAFewParticlesThrownHigh) {
  ParticleStore store = level_bed(100, 10, 1e-3);
  for (std::size_t row = 0; row < 10; ++row) store.position[row].z = 5;
  EXPECT_NEAR(expanded_bed_height(store), 0.1, 1.5e-3);  // 1 % of the bed moved: a layer and a half
}

TEST(BedHeight, DoesNotDependOnTheOrderOfRows) {
  ParticleStore store = level_bed(10, 3, 1e-3);
  const double before = expanded_bed_height(store);
  std::vector<std::uint32_t> backwards(store.size());
  for (std::size_t k = 0; k < backwards.size(); ++k)
    backwards[k] = static_cast<std::uint32_t>(backwards.size() - 1 - k);
  store.reorder(backwards);
  EXPECT_EQ(expanded_bed_height(store), before);
}

TEST(BedHeight, OfNothingDoesNotExist) { EXPECT_TRUE(std::isnan(expanded_bed_height(ParticleStore()))); }

// Two particles of 1 mg and 3 mg at a quarter scale: masses by 64, velocities by 2, energies by 64 * 4.
TEST(Monitors, OfSolidsAreTheRealBeds) {
  ParticleStore store(StoreFields{.rotation = true});
  store.add(0, 0, 0.001, 0.005, 0.01, 5e-4, 1e-6);
  store.add(1, 0, 0.003, 0.005, 0.02, 5e-4, 3e-6);
  store.velocity[0].x = 2;
  store.velocity[1].z = -1;
  store.angular_velocity[0] = {0, 4, 0, 1e-10};
  EngineReport engine;
  engine.removed = 5;
  engine.contacts = 9;
  engine.budget.drag_impulse = {0, 0, 3e-6};
  engine.budget.contact_work = -2e-6;
  const Monitors m =
      observe({.time = 0.5, .particles = &store, .engine = &engine, .largest_overlap_ratio = 0.02}, quarter_scale());
  EXPECT_EQ(m.time, 1);
  EXPECT_EQ(m.particles, 2);
  EXPECT_EQ(m.removed_particles, 5);
  EXPECT_EQ(m.contacts, 9);
  EXPECT_DOUBLE_EQ(m.solids_mass, 4e-6 * 64);
  EXPECT_DOUBLE_EQ(m.solids_momentum[0], 2e-6 * 64 * 2);
  EXPECT_DOUBLE_EQ(m.solids_momentum[2], -3e-6 * 64 * 2);
  EXPECT_DOUBLE_EQ(m.kinetic_energy, (0.5 * 1e-6 * 4 + 0.5 * 3e-6) * 64 * 4);
  // 1/2 I w^2 with I by mass and the diameter squared: 64 * 2^2 / 2^2
  EXPECT_DOUBLE_EQ(m.rotational_energy, 0.5 * 1e-10 * 16 * 64);
  EXPECT_DOUBLE_EQ(m.mean_height, 4 * (0.01 + 3 * 0.02) / 4);
  EXPECT_DOUBLE_EQ(m.drag_impulse, 3e-6 * 64 * 2);
  EXPECT_DOUBLE_EQ(m.contact_work, -2e-6 * 64 * 4);
  EXPECT_EQ(m.largest_speed, 4);
  EXPECT_EQ(m.largest_overlap, 2);
  EXPECT_TRUE(std::isnan(m.pressure_drop));
}

TEST(Monitors, OfTheGasAreTheRealBeds) {
  const ModelScene scene = small_bed<ModelBed>(0.25);
  const Grid grid(scene);
  GasFields gas;
  gas.velocity.assign(3 * grid.cell_count(), 0);
  gas.pressure.assign(grid.cell_count(), 0);
  for (std::size_t c = 0; c < 12; ++c)
    gas.pressure[c] = c < 6 ? 90 : 110;  // the lowest layer, mean 100; the outlet holds 3
  for (std::size_t c = 12; c < 24; ++c) gas.pressure[c] = 80;  // falling by 20 per layer: 110 at the bottom face
  Column<double> fraction(grid.cell_count(), 0.75);
  fraction[7] = 0.4;
  similitude_gas_report report{};
  report.iterations = 11;
  report.mass_residual = 1e-9;
  report.inflow = 0.5;
  report.outflow = 0.25;
  report.courant = 0.3;
  report.momentum[2] = 2;
  ParticleStore none;
  const Monitors m = observe({.time = 0,
                              .particles = &none,
                              .engine = nullptr,
                              .grid = &grid,
                              .gas = &gas,
                              .gas_fraction = &fraction,
                              .gas_report = &report,
                              .gas_density = 2.4},
                             quarter_scale());
  EXPECT_DOUBLE_EQ(m.pressure_drop, 107 * 4);
  EXPECT_EQ(m.smallest_gas_fraction, 0.4);
  // real: volume 0.08 * 0.06 * 0.16 m^3, density 2.4 / 2, mean gas fraction (95 * 0.75 + 0.4) / 96
  EXPECT_NEAR(m.gas_mass, 0.08 * 0.06 * 0.16 * 1.2 * (95 * 0.75 + 0.4) / 96, 1e-15);
  EXPECT_EQ(m.gas_momentum[2], 2 * 32 * 2);
  EXPECT_EQ(m.inflow, 0.5 * 16);
  EXPECT_EQ(m.outflow, 0.25 * 16);
  EXPECT_EQ(m.courant, 0.3);
  EXPECT_EQ(m.gas_mass_residual, 1e-9);
  EXPECT_EQ(m.pressure_iterations, 11);
  EXPECT_TRUE(std::isnan(m.bed_height));
}

TEST(Monitors, OfAClosedBedMeasureThePressureAgainstTheHighestCells) {
  ModelScene scene = small_bed<ModelBed>(1);
  scene.patches.clear();
  const Grid grid(scene);
  GasFields gas;
  gas.pressure.assign(grid.cell_count(), 5);
  for (std::size_t c = 0; c < 24; ++c) gas.pressure[c] = 8;
  const Monitors m = observe({.grid = &grid, .gas = &gas, .gas_density = 1.2}, MapBack());
  EXPECT_DOUBLE_EQ(m.pressure_drop, 3);
  EXPECT_NEAR(m.gas_mass, 0.08 * 0.06 * 0.16 * 1.2, 1e-15);  // one-way: eps = 1
}

TEST(MonitorFile, NamesEveryColumnWithItsUnit) {
  const ScratchFolder folder;
  MonitorFile file(OutputDirectory(folder.path(), false));
  Monitors monitors;
  monitors.time = 0.5;
  monitors.outflow = 0.25;
  file.write(monitors);
  const auto lines = lines_of(folder / "monitors.csv");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(
      lines[0],
      "time [s],particles [1],removed_particles [1],solids_mass [kg],solids_momentum_x [kg m/s],"
      "solids_momentum_y [kg m/s],solids_momentum_z [kg m/s],kinetic_energy [J],rotational_energy [J],bed_height [m],"
      "mean_height [m],largest_speed [m/s],largest_overlap [% of d],contacts [1],gas_mass [kg],"
      "gas_momentum_x [kg m/s],gas_momentum_y [kg m/s],gas_momentum_z [kg m/s],pressure_drop [Pa],"
      "smallest_gas_fraction [1],courant [1],gas_mass_residual [1],pressure_iterations [1],inflow [kg/s],outflow "
      "[kg/s],gravity_impulse_z [kg m/s],drag_impulse_z [kg m/s],stress_impulse_z [kg m/s],wall_impulse_z [kg m/s],"
      "gravity_work [J],drag_work [J],stress_work [J],contact_work [J],gas_in [kg],gas_out [kg],momentum_residual [1],"
      "energy_residual [1],gas_balance_residual [1],boundary_impulse_z [kg m/s],pumping_work [J],gas_momentum_residual [1]");
  EXPECT_EQ(lines[1], "0.5,0,0,0,0,0,0,0,,,,0,0,0,,,,,,,,,,,0.25,,,,,,,,,,,,,,,,");
}
