#include "scene/model_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "scene/messages.h"
#include "scene/section.h"
#include "scene/units.h"

namespace similitude {
namespace {

using Row = similitude_parameter;

std::string text_of(const char* text) { return text != nullptr ? text : ""; }

/// A parameter's one sentence without its full stop, to stand inside another.
std::string doc_of(const Row& row) {
  std::string doc = text_of(row.doc);
  if (doc.ends_with('.')) doc.pop_back();
  return doc;
}

/// Flags and integers may leave the unit out of their row.
std::string unit_of(const Row& row) {
  const std::string unit = text_of(row.unit);
  return unit.empty() ? "1" : unit;
}

std::span<const Row> rows_of(const similitude_descriptor& model) { return {model.parameters, model.parameter_count}; }

std::vector<std::string> names_of(const similitude_descriptor& model, const std::vector<std::string>& framework_keys) {
  std::vector<std::string> names;
  for (const Row& row : rows_of(model)) names.emplace_back(row.name);
  names.insert(names.end(), framework_keys.begin(), framework_keys.end());
  return names;
}

std::string range_text(double low, double high, const std::string& unit) {
  if (!std::isfinite(low)) return "at most " + format_quantity(high, unit);
  if (!std::isfinite(high)) return "at least " + format_quantity(low, unit);
  return "from " + format_quantity(low, unit) + " to " + format_quantity(high, unit);
}

std::string position(const SourceMark& mark, const std::string& path) { return InputError(mark, path, "").what(); }

void check_range(const Row& row, const std::string& model, const DocumentNode& node, const std::string& path,
                 double value, std::vector<std::string>& warnings) {
  const std::string name = row.name;
  if (value < row.minimum || value > row.maximum)
    throw InputError(node.mark, path,
                     node.text + " is out of range: " + model + " takes " + name + " " +
                         range_text(row.minimum, row.maximum, unit_of(row)) + ".",
                     name + ": " + doc_of(row) + ".");
  if (row.typical_minimum < row.typical_maximum && (value < row.typical_minimum || value > row.typical_maximum))
    warnings.push_back(position(node.mark, path) + node.text + " is unusual: " + name + " of " + model + " is mostly " +
                       range_text(row.typical_minimum, row.typical_maximum, unit_of(row)) + ".");
}

ModelParameter read_parameter(const Row& row, const std::string& model, const DocumentNode& node,
                              const std::string& path, std::vector<std::string>& warnings) {
  ModelParameter parameter{row.name, 0, "", row.scales_as, true};
  switch (row.type) {
    case SIMILITUDE_FLAG:
      parameter.real = read_flag(node, path) ? 1 : 0;
      break;
    case SIMILITUDE_CHOICE:
      parameter.text = read_choice(node, path, split_choices(text_of(row.choices)));
      break;
    case SIMILITUDE_INTEGER:
      parameter.real = static_cast<double>(read_integer(node, path, Sign::any));
      check_range(row, model, node, path, parameter.real, warnings);
      break;
    default:
      parameter.real = read_quantity(node, path, unit_of(row), Sign::any);
      check_range(row, model, node, path, parameter.real, warnings);
  }
  return parameter;
}

ModelParameter default_of(const Row& row) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  if (row.required != 0) return {row.name, nothing, "", row.scales_as, false};
  if (row.type == SIMILITUDE_CHOICE) return {row.name, 0, text_of(row.default_text), row.scales_as, false};
  return {row.name, row.default_value, "", row.scales_as, false};
}

/// A unit that nobody can type makes a parameter that nobody can give; the loader does not know units.
void check_units(const PluginEntry& plugin, const DocumentNode& id, const std::string& path) {
  for (const Row& row : rows_of(*plugin.descriptor)) {
    if (parse_unit(unit_of(row))) continue;
    throw PluginError(position(id.mark, path) + plugin.descriptor->id + " declares its parameter " + row.name + " in \"" + row.unit +
                          "\", which is no unit.",
                      "This is for the plugin's author to mend: SI units as in a case file, \"1\" for a pure number.\n(from " +
                          plugin.file.string() + ", version " + plugin.descriptor->version + ")");
  }
}

const PluginEntry& find_model(const std::string& kind, const DocumentNode& id, const std::string& path,
                              const Catalogue& catalogue) {
  const PluginEntry* found = catalogue.find(kind, id.text);
  if (found != nullptr) {
    check_units(*found, id, path);
    return *found;
  }
  try {
    catalogue.throw_no_such_model(kind, id.text);
  } catch (const PluginError& error) {
    throw PluginError(position(id.mark, path) + error.what());
  }
}

void check_names(const std::string& model, const std::vector<DocumentNode::Key>& keys, const std::string& path,
                 const std::vector<std::string>& known) {
  for (const DocumentNode::Key& key : keys) {
    if (std::find(known.begin(), known.end(), key.name) != known.end()) continue;
    throw InputError(key.mark, path + "." + key.name, model + " has no such parameter.",
                     did_you_mean(key.name, known) +
                         (known.empty() ? "It has none." : "Parameters of " + model + ": " + listed(known) + "."));
  }
}

/// As read_parameters, the names checked already.
std::vector<ModelParameter> parameters_in(const similitude_descriptor& model, const DocumentNode& node,
                                          const std::string& path, std::vector<std::string>& warnings) {
  std::vector<ModelParameter> parameters;
  for (const Row& row : rows_of(model)) {
    const DocumentNode* given = node.find(row.name);
    const bool there = given != nullptr && given->kind != DocumentNode::Kind::nothing;
    parameters.push_back(there ? read_parameter(row, model.id, *given, path + "." + row.name, warnings) : default_of(row));
  }
  return parameters;
}

/// 1, 2 or 5 times a power of ten, the nearest by ratio.
double round_number(double value) {
  constexpr double k_nearer = 1 - 1e-9;   // of two as near the smaller, whatever the rounding
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  double nearest = decade;
  for (const double step : {2.0, 5.0, 10.0})
    if (std::abs(std::log(value / (step * decade))) < k_nearer * std::abs(std::log(value / nearest))) nearest = step * decade;
  return nearest;
}

/// From the middle of what is typical, so that it means something: the end of a range of ratios is often the identity.
double example_value(const Row& row) {
  constexpr double k_usual_spring = 500, k_usual_modulus = 1e7;   // [N/m], [Pa]: as in the shipped cases
  const double low = row.typical_minimum, high = row.typical_maximum;
  if (low < high && std::isfinite(high - low)) {
    const double round = round_number(low > 0 ? std::sqrt(low * high) : std::max(std::abs(low), std::abs(high)) / 2);
    return round >= low && round <= high ? round : low;
  }
  if (row.scales_as == SIMILITUDE_SCALES_AS_STIFFNESS && unit_of(row) == "N/m") return k_usual_spring;
  if (row.scales_as == SIMILITUDE_SCALES_AS_MODULUS && unit_of(row) == "Pa") return k_usual_modulus;
  return 1;
}

}  // namespace

std::string doc_of_parameter(const similitude_parameter& row) { return doc_of(row); }

std::string example_of_parameter(const similitude_parameter& row) {
  if (row.type == SIMILITUDE_FLAG) return "true";
  if (row.type == SIMILITUDE_CHOICE) return listed(split_choices(text_of(row.choices)));
  return format_quantity(std::clamp(example_value(row), row.minimum, row.maximum), unit_of(row));
}

std::vector<ModelParameter> read_parameters(const similitude_descriptor& model, const DocumentNode& node,
                                            const std::string& path, std::vector<std::string>& warnings) {
  check_names(model.id, node.keys, path, names_of(model, {}));
  return parameters_in(model, node, path, warnings);
}

ModelChoice read_common_parameters(const std::string& kind, const DocumentNode& node, const std::string& path,
                                   const Catalogue& catalogue, const std::vector<std::string>& framework_keys,
                                   std::vector<std::string>& warnings) {
  const DocumentNode* id = node.is_scalar() ? &node : node.find("id");
  if (id == nullptr || !id->is_scalar())
    throw InputError(node.mark, path, "the id of a " + kind + " model is missing.",
                     "Write its id, or {id: …, parameter: value}. Models found: " + listed(catalogue.ids(kind)) + ".");
  const similitude_descriptor& model = *find_model(kind, *id, path, catalogue).descriptor;
  std::vector<DocumentNode::Key> parameters = node.keys;
  std::erase_if(parameters, [](const DocumentNode::Key& key) { return key.name == "id"; });
  check_names(id->text, parameters, path, names_of(model, framework_keys));
  return {kind, id->text, parameters_in(model, node, path, warnings), node.mark};
}

ModelChoice read_model(const std::string& kind, const DocumentNode& node, const std::string& path,
                       const Catalogue& catalogue, const std::vector<std::string>& framework_keys,
                       std::vector<std::string>& warnings) {
  const ModelChoice choice = read_common_parameters(kind, node, path, catalogue, framework_keys, warnings);
  const similitude_descriptor& model = *catalogue.find(kind, choice.id)->descriptor;
  for (std::size_t i = 0; i < choice.parameters.size(); ++i) {
    const Row& row = model.parameters[i];
    if (row.required == 0 || choice.parameters[i].given) continue;
    std::string missing;   // all of them, so that the advice is enough
    for (std::size_t k = i; k < choice.parameters.size(); ++k) {
      const Row& other = model.parameters[k];
      if (other.required == 0 || choice.parameters[k].given) continue;
      missing += (missing.empty() ? "" : ", ") + std::string(other.name) + ": " + example_of_parameter(other);
    }
    throw InputError(node.mark, path, choice.id + " needs the parameter " + row.name + " (" + doc_of(row) + ").",
                     node.is_scalar() ? "Write for example {id: " + choice.id + ", " + missing + "}."
                                      : "Add for example " + missing + ".");
  }
  return choice;
}

}  // namespace similitude
