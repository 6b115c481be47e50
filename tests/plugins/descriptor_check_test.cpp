// What a library offers is checked once, at the door. Each test spoils one piece of sound tables.

#include "loader/descriptor_check.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>

namespace similitude {
namespace {

constexpr double k_open = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

void* create(const similitude_host*, const similitude_bed*, const similitude_value*, std::uint32_t,
             similitude_status*) {
  return nullptr;
}
void destroy(void*) {}
void exchange(const void*, const similitude_drag_block*, similitude_status*) {}
void needs(const void*, similitude_contact_needs*) {}
void forces(const void*, const similitude_contact_block*, similitude_status*) {}
double contact_time(const void*, std::uint32_t, double, double, double) { return 1; }
void advance(void*, const similitude_gas_step*, similitude_gas_report*, similitude_status*) {}
void initialise(void*, const similitude_grid*, const similitude_gas_step*, similitude_status*) {}
std::uint64_t state_size(const void*) { return 0; }

/// A library of one drag model with two parameters, all sound.
struct Library {
  std::array<similitude_parameter, 2> parameters{
      similitude_parameter{sizeof(similitude_parameter), SIMILITUDE_REAL, 0, SIMILITUDE_SCALES_NOT, "factor", "1",
                           "multiplies", nullptr, nullptr, nullptr, 0.5, 0, k_open, 0, 0, nullptr},
      similitude_parameter{sizeof(similitude_parameter), SIMILITUDE_CHOICE, 0, SIMILITUDE_SCALES_NOT, "manner", "",
                           "how", nullptr, "one|other", "one", 0, 0, 0, 0, 0, nullptr}};
  similitude_drag_functions drag{sizeof(similitude_drag_functions), 0, nullptr, exchange};
  similitude_contact_functions contact{
      sizeof(similitude_contact_functions), 0, needs, forces, contact_time, contact_time, nullptr};
  similitude_fluid_functions fluid{
      sizeof(similitude_fluid_functions), 1, initialise, advance, nullptr, nullptr, nullptr, nullptr, nullptr};
  similitude_scaling_functions scaling{sizeof(similitude_scaling_functions), 0, nullptr};
  similitude_effect_functions effect = [] {
    similitude_effect_functions none{};
    none.struct_size = sizeof none;
    return none;
  }();
  similitude_descriptor model{sizeof(similitude_descriptor),
                              2,
                              "drag",
                              "law",
                              "1.0.0",
                              "A law",
                              nullptr,
                              nullptr,
                              nullptr,
                              nullptr,
                              create,
                              destroy};
  std::array<const similitude_descriptor*, 2> models{&model, &model};
  similitude_entry entry{sizeof(similitude_entry), 1, nullptr, models.data()};

  Library() {
    model.parameters = parameters.data();
    model.functions = &drag;
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

std::string fault_after(const std::function<void(Library&)>& spoil) {
  Library library;
  spoil(library);
  const auto refusal = check_entry(library.entry);
  return refusal ? refusal->reason : "fine";
}

#define EXPECT_FAULT(spoil, text) EXPECT_EQ(fault_after([]([[maybe_unused]] Library& l) { spoil; }), text)

TEST(DescriptorCheck, SoundTablesPass) {
  EXPECT_FAULT(, "fine");
  EXPECT_FAULT(l.model.id = "org.example.my-lab.law_2", "fine");
  EXPECT_FAULT(l.model.version = "1.0.0-rc.1", "fine");
  EXPECT_FAULT(l.parameters[0].default_value = k_nan, "fine");
  EXPECT_FAULT((l.parameters[0].required = 1, l.parameters[0].default_value = -7), "fine");
  EXPECT_FAULT((l.model.kind = "contact", l.model.functions = &l.contact), "fine");
  EXPECT_FAULT((l.model.kind = "fluid", l.model.functions = &l.fluid), "fine");
  EXPECT_FAULT((l.model.parameter_count = 0, l.model.parameters = nullptr), "fine");
}

TEST(DescriptorCheck, AnEntryOffersAtLeastOneModel) {
  EXPECT_FAULT(l.entry.struct_size = 8, "its entry is incomplete.");
  EXPECT_FAULT(l.entry.descriptors = nullptr, "its entry is incomplete.");
  EXPECT_FAULT(l.entry.descriptor_count = 0, "it offers no model.");
  EXPECT_FAULT(l.models[0] = nullptr, "model 1 has no descriptor.");
  EXPECT_FAULT(l.entry.descriptor_count = 2, "it offers the drag model \"law\" twice.");
  EXPECT_FAULT(l.model.struct_size = 40, "model 1: its descriptor has 40 bytes, this program reads 88.");
}

TEST(DescriptorCheck, AModelIsNamedAsTheUserWillTypeIt) {
  EXPECT_FAULT(l.model.kind = "Drag",
               "model 1: there is no kind \"Drag\"; kinds are drag, contact, fluid, scaling and effect.");
  EXPECT_FAULT(l.model.kind = nullptr,
               "model 1: there is no kind \"\"; kinds are drag, contact, fluid, scaling and effect.");
  EXPECT_FAULT(l.model.id = "My Law",
               "model 1: \"My Law\" is no id; write my_law, or org.example.my_law for a third party's.");
  EXPECT_FAULT(l.model.id = nullptr,
               "model 1: \"\" is no id; write my_law, or org.example.my_law for a third party's.");
  EXPECT_FAULT(l.model.id = "2nd",
               "model 1: \"2nd\" is no id; write my_law, or org.example.my_law for a third party's.");
  EXPECT_FAULT(l.model.id = "org.",
               "model 1: \"org.\" is no id; write my_law, or org.example.my_law for a third party's.");
  EXPECT_FAULT(l.model.id = "org..law",
               "model 1: \"org..law\" is no id; write my_law, or org.example.my_law for a third party's.");
  EXPECT_FAULT(l.model.version = "1.0", "drag model \"law\": its version \"1.0\" is not of the form 1.0.0.");
  EXPECT_FAULT(l.model.version = "1.0.0.0", "drag model \"law\": its version \"1.0.0.0\" is not of the form 1.0.0.");
  EXPECT_FAULT(l.model.version = "v1.0.0", "drag model \"law\": its version \"v1.0.0\" is not of the form 1.0.0.");
  EXPECT_FAULT(l.model.version = nullptr, "drag model \"law\": its version \"\" is not of the form 1.0.0.");
  EXPECT_FAULT(l.model.title = nullptr, "drag model \"law\": it has no title.");
}

TEST(DescriptorCheck, WhatAKindCannotDoWithoutIsThere) {
  EXPECT_FAULT(l.model.create = nullptr, "drag model \"law\": its function create is missing.");
  EXPECT_FAULT(l.model.destroy = nullptr, "drag model \"law\": its function destroy is missing.");
  EXPECT_FAULT(l.model.functions = nullptr, "drag model \"law\": it has no function table.");
  EXPECT_FAULT(l.drag.struct_size = 8, "drag model \"law\": its function table has 8 bytes, this program reads 24.");
  EXPECT_FAULT(l.drag.exchange = nullptr, "drag model \"law\": its function exchange is missing.");
  EXPECT_FAULT((l.model.kind = "contact", l.model.functions = &l.contact, l.contact.needs = nullptr),
               "contact model \"law\": its function needs is missing.");
  EXPECT_FAULT((l.model.kind = "contact", l.model.functions = &l.contact, l.contact.forces = nullptr),
               "contact model \"law\": its function forces is missing.");
  EXPECT_FAULT((l.model.kind = "contact", l.model.functions = &l.contact, l.contact.contact_time = nullptr),
               "contact model \"law\": its function contact_time is missing.");
  EXPECT_FAULT((l.model.kind = "contact", l.model.functions = &l.contact, l.contact.largest_stable_step = nullptr),
               "contact model \"law\": its function largest_stable_step is missing.");
  EXPECT_FAULT((l.model.kind = "fluid", l.model.functions = &l.fluid,
                l.fluid.struct_size = offsetof(similitude_fluid_functions, needs)),
               "fluid model \"law\": its function table has 56 bytes, this program reads 64.");
  EXPECT_FAULT((l.model.kind = "fluid", l.model.functions = &l.fluid, l.fluid.initialise = nullptr),
               "fluid model \"law\": its function initialise is missing.");
  EXPECT_FAULT((l.model.kind = "fluid", l.model.functions = &l.fluid, l.fluid.advance = nullptr),
               "fluid model \"law\": its function advance is missing.");
  EXPECT_FAULT((l.model.kind = "fluid", l.model.functions = &l.fluid, l.fluid.state_size = state_size),
               "fluid model \"law\": it has some but not all of state_size, save_state and load_state.");
  EXPECT_FAULT((l.model.kind = "scaling", l.model.functions = &l.scaling),
               "scaling model \"law\": its function ratios is missing.");
  EXPECT_FAULT((l.model.kind = "effect", l.model.functions = &l.effect),
               "effect model \"law\": its function relevance is missing.");
}

#define EXPECT_FACTOR_FAULT(spoil, text) \
  EXPECT_FAULT(spoil, std::string("drag model \"law\": parameter \"factor\": ") + text)

TEST(DescriptorCheck, AParameterSaysWhatItIs) {
  EXPECT_FAULT(l.model.parameters = nullptr, "drag model \"law\": its parameter table is missing.");
  EXPECT_FAULT(l.parameters[0].name = nullptr, "drag model \"law\": parameter 1: it has no name.");
  EXPECT_FAULT(l.parameters[0].name = "Factor",
               "drag model \"law\": parameter \"Factor\": the name is not lower_snake.");
  EXPECT_FAULT(l.parameters[1].name = "factor", "drag model \"law\": parameter \"factor\" is declared twice.");
  EXPECT_FACTOR_FAULT(l.parameters[0].struct_size = 100, "its row has 100 bytes, this program reads 112.");
  EXPECT_FACTOR_FAULT(l.parameters[0].type = 4, "there is no type 4.");
  EXPECT_FACTOR_FAULT(l.parameters[0].scales_as = 14, "there is no way of scaling 14.");
  EXPECT_FACTOR_FAULT(l.parameters[0].unit = nullptr, "it has no unit.");
  EXPECT_FACTOR_FAULT(l.parameters[0].unit = "", "it has no unit; write \"1\" for a pure number.");
  EXPECT_FACTOR_FAULT(l.parameters[0].doc = nullptr, "it has no text that says what it is.");
}

TEST(DescriptorCheck, ADefaultLiesInsideItsRange) {
  EXPECT_FACTOR_FAULT(l.parameters[0].default_value = -0.1, "default -0.1 is outside its range [0, ...].");
  EXPECT_FACTOR_FAULT(l.parameters[0].maximum = -1, "its range [0, -1] is empty.");
  EXPECT_FACTOR_FAULT(l.parameters[0].minimum = k_nan, "its range [nan, ...] is empty.");
  EXPECT_FACTOR_FAULT((l.parameters[0].typical_minimum = 2, l.parameters[0].typical_maximum = 1),
                      "its typical range [2, 1] is empty.");
  EXPECT_FACTOR_FAULT(l.parameters[0].type = SIMILITUDE_INTEGER, "default 0.5 is not a whole number.");
  EXPECT_FAULT(l.parameters[1].default_text = "third",
               "drag model \"law\": parameter \"manner\": default \"third\" is not one of one|other.");
  EXPECT_FAULT(l.parameters[1].default_text = nullptr,
               "drag model \"law\": parameter \"manner\": it is neither required nor has it a default.");
  EXPECT_FAULT(l.parameters[1].choices = nullptr,
               "drag model \"law\": parameter \"manner\": it is a choice without choices.");
}

}  // namespace
}  // namespace similitude
