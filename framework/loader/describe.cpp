#include "loader/describe.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "loader/number_text.h"

namespace similitude {
namespace {

using nlohmann::json;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string indented(const std::string& text, const std::string& by) {
  std::string result = by;
  for (const char c : text) {
    result += c;
    if (c == '\n') result += by;
  }
  return result;
}

json or_null(const char* text) { return text == nullptr ? json() : json(text); }
json or_null(double value) { return std::isfinite(value) ? json(value) : json(); }

std::vector<const PluginEntry*> models_called(const Catalogue& catalogue, const std::string& id) {
  std::vector<const PluginEntry*> models;
  for (const PluginEntry& plugin : catalogue.plugins())
    if (id == plugin.descriptor->id) models.push_back(&plugin);
  if (models.empty()) catalogue.throw_no_such_model("", id);
  return models;
}

const char* type_name(std::int32_t type) {
  switch (type) {
    case SIMILITUDE_INTEGER:
      return "integer";
    case SIMILITUDE_FLAG:
      return "flag";
    case SIMILITUDE_CHOICE:
      return "choice";
    default:
      return "real";
  }
}

const char* scaling_name(std::int32_t scales_as) {
  switch (scales_as) {
    case SIMILITUDE_SCALES_AS_LENGTH:
      return "length";
    case SIMILITUDE_SCALES_AS_DIAMETER:
      return "diameter";
    case SIMILITUDE_SCALES_AS_TIME:
      return "time";
    case SIMILITUDE_SCALES_AS_VELOCITY:
      return "velocity";
    case SIMILITUDE_SCALES_AS_STIFFNESS:
      return "stiffness";
    case SIMILITUDE_SCALES_AS_MODULUS:
      return "modulus";
    case SIMILITUDE_SCALES_AS_RESTITUTION:
      return "restitution";
    case SIMILITUDE_SCALES_AS_FORCE:
      return "force";
    case SIMILITUDE_SCALES_AS_SURFACE_ENERGY:
      return "surface energy";
    case SIMILITUDE_SCALES_AS_ENERGY:
      return "energy";
    case SIMILITUDE_SCALES_AS_DIFFUSIVITY:
      return "diffusivity";
    case SIMILITUDE_SCALES_AS_RATE:
      return "rate";
    default:
      return nullptr;
  }
}

bool has_typical_range(const similitude_parameter& p) { return p.typical_minimum < p.typical_maximum; }

json default_json(const similitude_parameter& p) {
  if (p.required != 0) return {};
  if (p.type == SIMILITUDE_CHOICE) return or_null(p.default_text);
  if (p.type == SIMILITUDE_FLAG && !std::isnan(p.default_value)) return p.default_value != 0;
  return or_null(p.default_value);
}

/// What values are allowed, for people.
std::string allowed_text(const similitude_parameter& p) {
  if (p.type == SIMILITUDE_FLAG) return "true or false";
  if (p.type == SIMILITUDE_CHOICE) {
    std::string words = p.choices;
    for (std::size_t bar; (bar = words.find('|')) != std::string::npos;) words.replace(bar, 1, " or ");
    return words;
  }
  const bool open = std::isinf(p.minimum) && std::isinf(p.maximum);
  std::string text = open ? "any" : range_text(p.minimum, p.maximum);
  if (has_typical_range(p)) text += ", typically " + range_text(p.typical_minimum, p.typical_maximum);
  return text;
}

json parameter_json(const similitude_parameter& p) {
  json choices = json();
  if (p.type == SIMILITUDE_CHOICE) {
    choices = json::array();
    std::istringstream words(p.choices);
    for (std::string word; std::getline(words, word, '|');) choices.push_back(word);
  }
  return {{"name", p.name},
          {"type", type_name(p.type)},
          {"unit", p.unit},
          {"required", p.required != 0},
          {"default", default_json(p)},
          {"minimum", or_null(p.minimum)},
          {"maximum", or_null(p.maximum)},
          {"typical_minimum", has_typical_range(p) ? or_null(p.typical_minimum) : json()},
          {"typical_maximum", has_typical_range(p) ? or_null(p.typical_maximum) : json()},
          {"choices", choices},
          {"scales_as", or_null(scaling_name(p.scales_as))},
          {"doc", p.doc},
          {"reference", or_null(p.reference)}};
}

json plugin_json(const PluginEntry& plugin) {
  const similitude_descriptor& model = *plugin.descriptor;
  return {{"kind", model.kind},
          {"id", model.id},
          {"version", model.version},
          {"title", model.title},
          {"file", plugin.file.string()}};
}

/// Rows of cells, each column as wide as its widest cell; the last is not padded.
std::string table_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k) text += padded(row[k], widths[k] + 2);
    text += row.back() + "\n";
  }
  return text;
}

std::string refused_count_text(const Catalogue& catalogue) {
  const std::size_t count = catalogue.refused().size();
  if (count == 0) return {};
  return std::to_string(count) + (count == 1 ? " file was" : " files were") +
         " refused: `similitude plugins failures` says why.\n";
}

}  // namespace

std::string default_text(const similitude_parameter& p) {
  if (p.required != 0) return "required";
  if (p.type == SIMILITUDE_CHOICE) return p.default_text;
  if (std::isnan(p.default_value)) return "left out";
  if (p.type == SIMILITUDE_FLAG) return p.default_value != 0 ? "true" : "false";
  char six_digits[32];  // people need no more; scripts read the JSON
  std::snprintf(six_digits, sizeof six_digits, "%.6g", p.default_value);
  return six_digits;
}

std::string plugins_text(const Catalogue& catalogue) {
  std::vector<std::vector<std::string>> rows{{"kind", "id", "version", "title", "file"}};
  std::string hidden;
  for (const PluginEntry& plugin : catalogue.plugins()) {
    const similitude_descriptor& model = *plugin.descriptor;
    rows.push_back({model.kind, model.id, model.version, model.title, plugin.file.string()});
    if (!plugin.hides.empty())
      hidden += "The " + std::string(model.kind) + " model \"" + model.id + "\" of " + plugin.level + " hides " +
                plugin.hides + ".\n";
  }
  return table_text(rows) + hidden + refused_count_text(catalogue);
}

json plugins_json(const Catalogue& catalogue) {
  json plugins = json::array();
  for (const PluginEntry& plugin : catalogue.plugins()) plugins.push_back(plugin_json(plugin));
  return {{"plugins", plugins}};
}

std::string plugin_info_text(const Catalogue& catalogue, const std::string& id) {
  std::string text;
  for (const PluginEntry* plugin : models_called(catalogue, id)) {
    const similitude_descriptor& model = *plugin->descriptor;
    if (!text.empty()) text += "\n";
    text += std::string(model.id) + " " + model.version + " (" + model.kind + ")\n  " + model.title + "\n";
    if (model.authors != nullptr) text += "  authors:   " + std::string(model.authors) + "\n";
    if (model.reference != nullptr) text += "  reference: " + std::string(model.reference) + "\n";
    text += "  file:      " + plugin->file.string() + " (" + plugin->level + ")\n";
    if (!plugin->hides.empty()) text += "  hides:     " + plugin->hides + "\n";
    if (model.parameter_count == 0) {
      text += "  no parameters\n";
      continue;
    }
    std::vector<std::vector<std::string>> rows{{"parameter", "unit", "default", "range", "meaning"}};
    for (std::uint32_t k = 0; k < model.parameter_count; ++k) {
      const similitude_parameter& p = model.parameters[k];
      std::string meaning = p.doc;
      if (p.reference != nullptr) meaning += std::string(" [") + p.reference + "]";
      rows.push_back({p.name, *p.unit == '\0' ? "-" : p.unit, default_text(p), allowed_text(p), meaning});
    }
    std::istringstream lines(table_text(rows));
    for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  }
  return text;
}

json plugin_info_json(const Catalogue& catalogue, const std::string& id) {
  json plugins = json::array();
  for (const PluginEntry* plugin : models_called(catalogue, id)) {
    json one = plugin_json(*plugin);
    one["authors"] = or_null(plugin->descriptor->authors);
    one["reference"] = or_null(plugin->descriptor->reference);
    one["level"] = plugin->level;
    one["hides"] = plugin->hides.empty() ? json() : json(plugin->hides);
    one["parameters"] = json::array();
    for (std::uint32_t k = 0; k < plugin->descriptor->parameter_count; ++k)
      one["parameters"].push_back(parameter_json(plugin->descriptor->parameters[k]));
    plugins.push_back(one);
  }
  return {{"plugins", plugins}};
}

std::string failures_text(const Catalogue& catalogue) {
  if (catalogue.refused().empty()) return "No file was refused.\n";
  std::string text;
  for (const RefusedFile& file : catalogue.refused())
    text += file.file.string() + ": refused: " + file.reason + "\n" + indented(file.fix, "  ") + "\n";
  return text;
}

json failures_json(const Catalogue& catalogue) {
  json failures = json::array();
  for (const RefusedFile& file : catalogue.refused())
    failures.push_back({{"file", file.file.string()}, {"reason", file.reason}, {"fix", file.fix}});
  return {{"failures", failures}};
}

}  // namespace similitude
