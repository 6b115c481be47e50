// A plugin that was built against the frozen headers of 1.0, in the program that these sources make: today's, or, with
// GROWN_BOUNDARY, one whose structures and tables have grown.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "loader/catalogue.h"

namespace {
using namespace similitude;

const Catalogue& catalogue() {
  static const Catalogue known(std::vector<SearchLevel>{{"test", FROZEN_FOLDER}});
  return known;
}

const PluginEntry& plugin(const char* kind, const char* id) {
  const PluginEntry* found = catalogue().find(kind, id);
  if (found == nullptr) throw std::runtime_error(std::string(id) + " was not taken");
  return *found;
}

similitude_bed bed() {
  similitude_bed b{};
  b.struct_size = sizeof b;
  b.dimension = 3;
  b.gravity = 9.81;
  return b;
}

alignas(64) constexpr std::array<double, 8> k_ones{1, 1, 1, 1, 1, 1, 1, 1};

TEST(PluginOf_1_0, IsTaken) {
  EXPECT_TRUE(catalogue().refused().empty()) << catalogue().refused().front().reason;
  for (const auto& [kind, id] : {std::pair{"drag", "org.example.stokes"},
                                 {"contact", "org.example.spring"},
                                 {"scaling", "org.example.half"},
                                 {"fluid", "org.example.still"},
                                 {"effect", "org.example.pull"}})
    EXPECT_NE(catalogue().find(kind, id), nullptr) << id;
}

TEST(PluginOf_1_0, DragIsWhatItWas) {
  const auto model = create_model<similitude_drag_functions>(plugin("drag", "org.example.stokes"), bed(), {{3, nullptr}}, 1);
  alignas(64) std::array<double, 8> exchange{};
  similitude_drag_block block{};
  block.struct_size = sizeof block;
  block.rows = 8;
  block.diameter = block.gas_fraction = block.slip_speed = block.gas_density = block.gas_viscosity = k_ones.data();
  block.exchange = exchange.data();
  similitude_status status{};
  model.functions().exchange(model.instance(), &block, &status);
  EXPECT_EQ(status.code, 0) << status.text;
  for (const double k : exchange) EXPECT_DOUBLE_EQ(k, 3 * 3 * 3.14159265358979323846);
#ifdef GROWN_BOUNDARY
  EXPECT_EQ(model.functions().heat, nullptr);   // a hook that it has never heard of
#endif
}

TEST(PluginOf_1_0, ContactForceIsWhatItWas) {
  const auto model = create_model<similitude_contact_functions>(plugin("contact", "org.example.spring"), bed(), {{50, nullptr}}, 1);
  alignas(64) std::array<double, 8> force[3]{};
  similitude_contact_block block{};
  block.struct_size = sizeof block;
  block.rows = 8;
  block.dt = 1;
  for (int a = 0; a < 3; ++a) {
    block.normal[a] = block.velocity[a] = k_ones.data();
    block.force[a] = force[a].data();
  }
  block.overlap = block.radius_i = block.radius_j = block.effective_mass = k_ones.data();
  similitude_status status{};
  model.functions().forces(model.instance(), &block, &status);
  EXPECT_EQ(status.code, 0) << status.text;
  for (const auto& column : force)
    for (const double f : column) EXPECT_EQ(f, 50);
}

TEST(PluginOf_1_0, RatiosAreWhatTheyWere) {
  const auto model = create_model<similitude_scaling_functions>(plugin("scaling", "org.example.half"), bed(), {}, 1);
  const similitude_bed real = bed();
  similitude_ratios ratios{};
  ratios.struct_size = sizeof ratios;
  similitude_status status{};
  model.functions().ratios(model.instance(), &real, &ratios, &status);
  EXPECT_EQ(ratios.diameter, 0.5);
  EXPECT_EQ(ratios.time, 9.81);
  EXPECT_EQ(ratios.parcel_weight, 1);
}

TEST(PluginOf_1_0, GasIsWhatItWas) {
  const auto model = create_model<similitude_fluid_functions>(plugin("fluid", "org.example.still"), bed(), {}, 1);
  EXPECT_EQ(needs_of(model).drag_over_gas_fraction, 0);
  similitude_grid grid{};
  grid.struct_size = sizeof grid;
  double pressure = 0;
  similitude_gas_step step{};
  step.struct_size = sizeof step;
  step.pressure = &pressure;
  similitude_gas_report report{};
  report.struct_size = sizeof report;
  similitude_status status{};
  model.functions().initialise(model.instance(), &grid, &step, &status);
  EXPECT_EQ(pressure, 7);
  model.functions().advance(model.instance(), &step, &report, &status);
  EXPECT_EQ(report.courant, 0.25);
}

TEST(PluginOf_1_0, EffectIsWhatItWas) {
  const auto model = create_model<similitude_effect_functions>(plugin("effect", "org.example.pull"), bed(), {}, 1);
  alignas(64) std::array<double, 8> force[3]{}, coefficient{};
  similitude_particle_block block{};
  block.struct_size = sizeof block;
  block.rows = 8;
  block.dt = 0.5;
  block.diameter = block.mass = block.gas_fraction = block.gas_density = block.gas_viscosity = k_ones.data();
  for (int a = 0; a < 3; ++a) {
    block.velocity[a] = block.gas_velocity[a] = k_ones.data();
    block.force[a] = force[a].data();
  }
  block.linear_coefficient = coefficient.data();
  similitude_status status{};
  model.functions().particles(model.instance(), &block, &status);
  EXPECT_EQ(status.code, 0) << status.text;
  for (const double c : coefficient) EXPECT_EQ(c, 2);
}

}  // namespace
