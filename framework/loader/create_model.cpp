#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <limits>

#include "loader/catalogue.h"

namespace similitude {
namespace {

template <class Functions>
constexpr const char* k_kind = nullptr;
template <>
constexpr const char* k_kind<similitude_contact_functions> = "contact";
template <>
constexpr const char* k_kind<similitude_drag_functions> = "drag";
template <>
constexpr const char* k_kind<similitude_fluid_functions> = "fluid";
template <>
constexpr const char* k_kind<similitude_scaling_functions> = "scaling";
template <>
constexpr const char* k_kind<similitude_effect_functions> = "effect";

void print_words_of_plugin(std::int32_t level, const char* text) {
  if (text != nullptr) std::fprintf(stderr, "%s: %s\n", level > 0 ? "warning" : "note", text);
}

constexpr similitude_host k_host{sizeof(similitude_host), SIMILITUDE_ABI_MAJOR, SIMILITUDE_ABI_MINOR,
                                 print_words_of_plugin};

/// The text need not be ended by a zero, nor be there.
std::string words_of(const similitude_status& status) {
  const std::string words(status.text, strnlen(status.text, sizeof status.text));
  return words.empty() ? "it does not say why." : words;
}

/// What a model is told where the case says nothing: a choice left open is its default.
std::vector<similitude_value> without_gaps(const similitude_descriptor& model, std::vector<similitude_value> values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    const similitude_parameter& parameter = model.parameters[k % model.parameter_count];
    if (parameter.type == SIMILITUDE_CHOICE && values[k].text == nullptr) values[k].text = parameter.default_text;
    if (parameter.type == SIMILITUDE_CHOICE && values[k].text == nullptr)
      throw PluginError(
          std::string(model.kind) + " model \"" + model.id + "\" needs the parameter \"" + parameter.name + "\".",
          std::string("Give one of ") + parameter.choices + ".");
  }
  return values;
}

/// A plugin of the C boundary must not throw; one that does is refused instead of taken for a fault of this program.
void* create_instance(const similitude_descriptor& model, const similitude_bed& bed, const std::vector<similitude_value>& values,
                      std::uint32_t sets, similitude_status& status) {
  std::string escaped;
  try {
    return model.create(&k_host, &bed, values.data(), sets, &status);
  } catch (const std::exception& error) {
    escaped = error.what();
  } catch (...) {
    escaped = "no std::exception";
  }
  status.code = 1;
  std::snprintf(status.text, sizeof status.text, "it let an exception out of create(), which its author must catch: %s", escaped.c_str());
  return nullptr;
}

}  // namespace

template <class Functions>
Model<Functions> create_model(const PluginEntry& plugin, const similitude_bed& bed,
                              const std::vector<similitude_value>& values, std::uint32_t sets) {
  const similitude_descriptor& descriptor = *plugin.descriptor;
  if (std::strcmp(descriptor.kind, k_kind<Functions>) != 0)
    throw std::logic_error(std::string("a ") + descriptor.kind + " model is no " + k_kind<Functions> +
                           " model: " + descriptor.id);
  if (sets == 0 || values.size() != std::size_t{sets} * descriptor.parameter_count)
    throw std::logic_error(std::string("the number of values does not fit the parameter table of ") + descriptor.id);

  const std::vector<similitude_value> complete = without_gaps(descriptor, values);
  similitude_bed complete_bed = bed;
  complete_bed.struct_size = sizeof complete_bed;  // whoever filled it knows this program's structure
  similitude_status status{};
  status.row = -1;
  void* instance = create_instance(descriptor, complete_bed, complete, sets, status);
  if (instance == nullptr || status.code != 0) {
    if (instance != nullptr) descriptor.destroy(instance);
    throw PluginError(
        std::string(descriptor.kind) + " model \"" + descriptor.id + "\" cannot be created: " + words_of(status),
        plugin.file.empty() ? "" : "(from " + plugin.file.string() + ", version " + descriptor.version + ")");
  }
  return Model<Functions>(descriptor, instance, sets);
}

similitude_fluid_needs needs_of(const FluidModel& fluid) {
  similitude_fluid_needs needs{};
  needs.struct_size = sizeof needs;
  if (fluid.functions().needs != nullptr) fluid.functions().needs(fluid.instance(), &needs);
  return needs;
}

namespace {

[[noreturn]] void refuse_state(const FluidModel& fluid, const char* what) {
  throw PluginError("fluid model \"" + std::string(fluid.descriptor().id) + "\": " + what,
                    "This is for the plugin's author to mend. If the solver threw, its words stand above.");
}

}  // namespace

std::size_t state_size_of(const FluidModel& fluid) {
  if (fluid.functions().state_size == nullptr) return 0;
  const std::uint64_t size = fluid.functions().state_size(fluid.instance());
  if (size == std::numeric_limits<std::uint64_t>::max()) refuse_state(fluid, "it does not say how many numbers it remembers.");
  return size;
}

void save_state_of(const FluidModel& fluid, std::vector<double>& state) {
  state.resize(state_size_of(fluid));
  if (state.empty()) return;
  fluid.functions().save_state(fluid.instance(), state.data());
  if (std::isnan(state.front())) refuse_state(fluid, "it does not say what it remembers.");
}

template ContactModel create_model(const PluginEntry&, const similitude_bed&, const std::vector<similitude_value>&,
                                   std::uint32_t);
template DragModel create_model(const PluginEntry&, const similitude_bed&, const std::vector<similitude_value>&,
                                std::uint32_t);
template FluidModel create_model(const PluginEntry&, const similitude_bed&, const std::vector<similitude_value>&,
                                 std::uint32_t);
template ScalingModel create_model(const PluginEntry&, const similitude_bed&, const std::vector<similitude_value>&,
                                   std::uint32_t);
template EffectModel create_model(const PluginEntry&, const similitude_bed&, const std::vector<similitude_value>&,
                                  std::uint32_t);

}  // namespace similitude
