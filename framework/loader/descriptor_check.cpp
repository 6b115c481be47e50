#include "loader/descriptor_check.h"

#include <similitude/known_here.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "loader/parameter_check.h"
#include "loader/spelling.h"

namespace similitude {
namespace {

/// What is wrong, in words without file and model; empty if nothing is.
using Fault = std::string;

bool blank(const char* text) { return text == nullptr || *text == '\0'; }

Fault missing(const char* function) { return std::string("its function ") + function + " is missing"; }

Fault check(const similitude_contact_functions& table) {
  if (table.needs == nullptr) return missing("needs");
  if (table.forces == nullptr) return missing("forces");
  if (table.contact_time == nullptr) return missing("contact_time");
  if (table.largest_stable_step == nullptr) return missing("largest_stable_step");
  return {};
}

Fault check(const similitude_drag_functions& table) { return table.exchange == nullptr ? missing("exchange") : ""; }

Fault check(const similitude_scaling_functions& table) { return table.ratios == nullptr ? missing("ratios") : ""; }

Fault check(const similitude_effect_functions& table) { return table.relevance == nullptr ? missing("relevance") : ""; }

Fault check(const similitude_fluid_functions& table) {
  if (table.initialise == nullptr) return missing("initialise");
  if (table.advance == nullptr) return missing("advance");
  const int state_functions =
      (table.state_size != nullptr) + (table.save_state != nullptr) + (table.load_state != nullptr);
  if (state_functions != 0 && state_functions != 3)
    return "it has some but not all of state_size, save_state and load_state";
  return {};
}

template <class Functions>
Fault check_functions(const void* functions) {
  const auto* table = static_cast<const Functions*>(functions);
  if (table->struct_size < k_first_size<Functions>)
    return "its function table has " + std::to_string(table->struct_size) + " bytes, this program reads " +
           std::to_string(k_first_size<Functions>);
  return check(as_known_here(table));
}

Fault check_functions(const std::string& kind, const void* functions) {
  if (functions == nullptr) return "it has no function table";
  if (kind == "contact") return check_functions<similitude_contact_functions>(functions);
  if (kind == "drag") return check_functions<similitude_drag_functions>(functions);
  if (kind == "fluid") return check_functions<similitude_fluid_functions>(functions);
  if (kind == "scaling") return check_functions<similitude_scaling_functions>(functions);
  return check_functions<similitude_effect_functions>(functions);
}

Fault check_parameters(const similitude_descriptor& model) {
  if (model.parameter_count != 0 && model.parameters == nullptr) return "its parameter table is missing";
  std::set<std::string> names;
  for (std::uint32_t k = 0; k < model.parameter_count; ++k) {
    const similitude_parameter& parameter = model.parameters[k];
    Fault fault = check_parameter(parameter);
    if (!fault.empty())
      return (blank(parameter.name) ? "parameter " + std::to_string(k + 1)
                                    : "parameter \"" + std::string(parameter.name) + "\"") +
             ": " + fault;
    if (!names.insert(parameter.name).second)
      return "parameter \"" + std::string(parameter.name) + "\" is declared twice";
  }
  return {};
}

Fault check_model(const similitude_descriptor& model) {
  if (!is_version(blank(model.version) ? "" : model.version))
    return "its version \"" + std::string(blank(model.version) ? "" : model.version) + "\" is not of the form 1.0.0";
  if (blank(model.title)) return "it has no title";
  if (model.create == nullptr) return missing("create");
  if (model.destroy == nullptr) return missing("destroy");
  Fault fault = check_functions(model.kind, model.functions);
  return fault.empty() ? check_parameters(model) : fault;
}

Refusal ask_the_author(const std::string& reason) {
  return {reason + ".", "This is for the plugin's author to mend. The macros of the SDK's headers fill these tables."};
}

}  // namespace

std::optional<Refusal> check_entry(const similitude_entry& entry) {
  if (entry.struct_size < k_first_size<similitude_entry> || entry.descriptors == nullptr)
    return ask_the_author("its entry is incomplete");
  if (entry.descriptor_count == 0) return ask_the_author("it offers no model");

  std::set<std::string> models;
  for (std::uint32_t k = 0; k < entry.descriptor_count; ++k) {
    const std::string number = "model " + std::to_string(k + 1);
    if (entry.descriptors[k] == nullptr) return ask_the_author(number + " has no descriptor");
    const similitude_descriptor& model = *entry.descriptors[k];
    if (model.struct_size < k_first_size<similitude_descriptor>)
      return ask_the_author(number + ": its descriptor has " + std::to_string(model.struct_size) +
                            " bytes, this program reads " + std::to_string(k_first_size<similitude_descriptor>));
    static const std::set<std::string> kinds{"drag", "contact", "fluid", "scaling", "effect"};
    const std::string kind = blank(model.kind) ? "" : model.kind;
    if (!kinds.contains(kind))
      return ask_the_author(number + ": there is no kind \"" + kind +
                            "\"; kinds are drag, contact, fluid, scaling and effect");
    const std::string id = blank(model.id) ? "" : model.id;
    if (!is_model_id(id))
      return ask_the_author(number + ": \"" + id +
                            "\" is no id; write my_law, or org.example.my_law for a third party's");
    const std::string name = kind + " model \"" + id + "\"";
    if (!models.insert(name).second) return ask_the_author("it offers the " + name + " twice");
    const Fault fault = check_model(model);
    if (!fault.empty()) return ask_the_author(name + ": " + fault);
  }
  return std::nullopt;
}

}  // namespace similitude
