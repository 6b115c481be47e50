// The fluid plugins as a host meets them: through the tables of abi.h.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstring>

#include "boxes.h"

namespace similitude {
namespace {

using test::Box;

struct Plugin {
  explicit Plugin(const char* file) {
    void* library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(library, nullptr) << dlerror();
    const auto* entry = library ? static_cast<const similitude_entry*>(dlsym(library, SIMILITUDE_ENTRY_SYMBOL)) : nullptr;
    if (!entry) return;
    descriptor = entry->descriptors[0];
    functions = static_cast<const similitude_fluid_functions*>(descriptor->functions);
  }

  void* create(const std::vector<similitude_value>& values) const {
    similitude_bed bed{};
    bed.struct_size = sizeof bed;
    bed.gas_density = 1.2;
    bed.gas_viscosity = 1.8e-5;
    similitude_status status{};
    void* model = descriptor->create(nullptr, &bed, values.data(), 1, &status);
    EXPECT_EQ(status.code, 0) << status.text;
    return model;
  }

  const similitude_descriptor* descriptor = nullptr;
  const similitude_fluid_functions* functions = nullptr;
};

/// The defaults of a table, as a host would fill them in.
std::vector<similitude_value> defaults(const similitude_descriptor& descriptor) {
  std::vector<similitude_value> values;
  for (std::uint32_t p = 0; p < descriptor.parameter_count; ++p) {
    values.push_back({descriptor.parameters[p].default_value, descriptor.parameters[p].default_text});
  }
  return values;
}

struct Fields {
  explicit Fields(std::size_t cells)
      : fraction(cells, 1), zero(3 * cells, 0), velocity(3 * cells, 7), pressure(cells, 7), stress(3 * cells, 7) {}
  similitude_gas_step row(double dt) {
    return {sizeof(similitude_gas_step), 0, dt, dt, fraction.data(), fraction.data(), zero.data(), zero.data(),
            zero.data(), velocity.data(), pressure.data(), stress.data(), nullptr, {nullptr, nullptr, nullptr}};
  }
  std::vector<double> fraction, zero, velocity, pressure, stress;
};

TEST(PrescribedPlugin, HoldsAUniformGasThatDoesNotSeeParticles) {
  const Plugin plugin(SIMILITUDE_PRESCRIBED_FILE);
  ASSERT_NE(plugin.descriptor, nullptr);
  EXPECT_STREQ(plugin.descriptor->id, "prescribed");
  EXPECT_EQ(plugin.functions->sees_particles, 0);
  std::vector<similitude_value> values = defaults(*plugin.descriptor);
  ASSERT_EQ(values.size(), 3u);
  EXPECT_EQ(plugin.descriptor->parameters[2].scales_as, SIMILITUDE_SCALES_AS_VELOCITY);
  values[2].real = 1.5;
  void* model = plugin.create(values);
  const Box box({.cells = {3, 2, 4}, .spacing = {0.1, 0.1, 0.1}});
  Fields fields(24);
  const similitude_gas_step step = fields.row(0.01);
  similitude_status status{};
  plugin.functions->initialise(model, &box.table(), &step, &status);
  similitude_gas_report report{};
  report.struct_size = sizeof report;
  plugin.functions->advance(model, &step, &report, &status);
  EXPECT_EQ(status.code, 0);
  for (std::size_t c = 0; c < 24; ++c) {
    EXPECT_EQ(fields.velocity[c], 0);
    EXPECT_EQ(fields.velocity[48 + c], 1.5);
    EXPECT_EQ(fields.pressure[c], 0);
    EXPECT_EQ(fields.stress[c], 0);
  }
  EXPECT_DOUBLE_EQ(report.courant, 0.15);
  plugin.descriptor->destroy(model);
}

TEST(VansPlugin, RunsThroughItsTableAndRefusesInWords) {
  const Plugin plugin(SIMILITUDE_VANS_FILE);
  ASSERT_NE(plugin.descriptor, nullptr);
  EXPECT_STREQ(plugin.descriptor->kind, "fluid");
  EXPECT_STREQ(plugin.descriptor->id, "vans");
  EXPECT_EQ(plugin.functions->sees_particles, 1);
  void* model = plugin.create(defaults(*plugin.descriptor));
  Box box({.cells = {4, 2, 6}, .spacing = {0.01, 0.01, 0.01}});
  box.set_side(2, 0, box.velocity_patch("inlet", {0, 0, 1}));
  Fields fields(48);
  const similitude_gas_step step = fields.row(1e-3);
  similitude_status status{};
  plugin.functions->initialise(model, &box.table(), &step, &status);
  EXPECT_NE(status.code, 0);
  EXPECT_EQ(std::strncmp(status.text, "patch inlet blows into a region without an opening", 50), 0) << status.text;

  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  status = {};
  plugin.functions->initialise(model, &box.table(), &step, &status);
  ASSERT_EQ(status.code, 0) << status.text;
  EXPECT_EQ(fields.velocity[0], 0);
  // rho h^2 / (8 mu) with all three directions equal
  EXPECT_NEAR(plugin.functions->largest_stable_step(model, &box.table()), 1.2 * 1e-4 / (8 * 1.8e-5), 1e-12);
  similitude_gas_report report{};
  report.struct_size = sizeof report;
  plugin.functions->advance(model, &step, &report, &status);
  ASSERT_EQ(status.code, 0) << status.text;
  const double inflow = 1.2 * 1 * 8 * 1e-4;
  EXPECT_NEAR(report.inflow, inflow, 1e-12 * inflow);
  EXPECT_NEAR(report.outflow, inflow, 1e-5 * inflow);
  std::vector<double> state(plugin.functions->state_size(model));
  EXPECT_EQ(state.size(), 5u * 2 * 6 + 4 * 3 * 6 + 4 * 2 * 7);
  plugin.functions->save_state(model, state.data());
  plugin.functions->load_state(model, state.data());
  plugin.descriptor->destroy(model);
}

TEST(VansPlugin, AsksForTheDragOfItsModel) {
  const Plugin plugin(SIMILITUDE_VANS_FILE);
  ASSERT_NE(plugin.descriptor, nullptr);
  ASSERT_STREQ(plugin.descriptor->parameters[0].name, "momentum");
  for (const char* momentum : {"model_a", "model_b", "as_printed"}) {
    std::vector<similitude_value> values = defaults(*plugin.descriptor);
    values[0].text = momentum;
    void* model = plugin.create(values);
    similitude_fluid_needs needs{};
    needs.struct_size = sizeof needs;
    plugin.functions->needs(model, &needs);
    EXPECT_EQ(needs.drag_over_gas_fraction, std::strcmp(momentum, "model_b") == 0 ? 1 : 0);
    EXPECT_EQ(needs.any_courant_number, 0);
    plugin.descriptor->destroy(model);
  }
}

TEST(PorousPlugin, RunsThroughItsTableAndRefusesInWords) {
  const Plugin plugin(SIMILITUDE_POROUS_FILE);
  ASSERT_NE(plugin.descriptor, nullptr);
  EXPECT_STREQ(plugin.descriptor->kind, "fluid");
  EXPECT_STREQ(plugin.descriptor->id, "porous");
  EXPECT_EQ(plugin.functions->sees_particles, 1);
  EXPECT_EQ(plugin.functions->largest_stable_step, nullptr);
  void* model = plugin.create(defaults(*plugin.descriptor));
  similitude_fluid_needs needs{};
  needs.struct_size = sizeof needs;
  plugin.functions->needs(model, &needs);
  EXPECT_EQ(needs.any_courant_number, 1);
  EXPECT_EQ(needs.drag_over_gas_fraction, 0);
  Box box({.cells = {4, 2, 6}, .spacing = {0.01, 0.01, 0.01}});
  box.set_side(2, 0, box.velocity_patch("inlet", {0, 0, 1}));
  Fields fields(48);
  const similitude_gas_step step = fields.row(1e-3);
  similitude_status status{};
  plugin.functions->initialise(model, &box.table(), &step, &status);
  EXPECT_EQ(std::strncmp(status.text, "patch inlet blows into a region without an opening", 50), 0) << status.text;

  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  status = {};
  plugin.functions->initialise(model, &box.table(), &step, &status);
  ASSERT_EQ(status.code, 0) << status.text;
  similitude_gas_report report{};
  report.struct_size = sizeof report;
  plugin.functions->advance(model, &step, &report, &status);   // no particles at all: a potential flow
  ASSERT_EQ(status.code, 0) << status.text;
  const double inflow = 1.2 * 1 * 8 * 1e-4;
  EXPECT_NEAR(report.outflow, inflow, 1e-5 * inflow);
  EXPECT_NEAR(report.courant, 1 * 1e-3 / 0.01, 1e-6);
  std::vector<double> state(plugin.functions->state_size(model));
  EXPECT_EQ(state.size(), 5u * 2 * 6 + 4 * 3 * 6 + 4 * 2 * 7);
  plugin.functions->save_state(model, state.data());
  plugin.functions->load_state(model, state.data());
  plugin.descriptor->destroy(model);
}

}  // namespace
}  // namespace similitude
