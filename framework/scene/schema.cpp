#include "scene/schema.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/case_keys.h"
#include "scene/quantities.h"
#include "scene/section.h"
#include "scene/units.h"

namespace similitude {
namespace {

using Json = nlohmann::json;

const std::string k_number = "([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?";
const std::string k_any_unit = "[ \\t]*(1/|/|[A-Za-z\u00b5\u03bc%(]).*";

std::string sign_pattern(Sign sign) { return sign == Sign::any ? "[-+]?" : "[+]?"; }

/// A number and a unit; an editor cannot check the dimension, the program does.
Json quantity(std::string_view unit, Sign sign, const std::string& before = "") {
  if (unit == "1" || unit.empty())
    return {
        {"anyOf", Json::array({{{"type", "number"}},
                               {{"type", "string"}, {"pattern", "^" + before + sign_pattern(sign) + k_number + "$"}},
                               {{"type", "string"}, {"pattern", "^" + sign_pattern(sign) + k_number + "[ \\t]*%$"}}})}};
  return {{"type", "string"}, {"pattern", "^" + before + sign_pattern(sign) + k_number + k_any_unit + "$"}};
}

Json list_of(const Json& item, int at_least, int at_most) {
  Json list{{"type", "array"}, {"items", item}};
  if (at_least > 0) list["minItems"] = at_least;
  if (at_most > 0) list["maxItems"] = at_most;
  return list;
}

Json either(const Json& a, const Json& b) { return {{"anyOf", Json::array({a, b})}}; }

Json with_doc(Json schema, std::string doc, const std::string& default_text) {
  if (!default_text.empty()) doc += (doc.empty() ? "" : ". ") + ("Default: " + default_text);
  if (!doc.empty()) schema["description"] = doc;
  return schema;
}

Json parameter_schema(const similitude_parameter& row) {
  const std::string unit = row.unit != nullptr && *row.unit != 0 ? row.unit : "1";
  Json schema, fallback;   // what an editor fills in
  std::string default_text;
  switch (row.type) {
    case SIMILITUDE_FLAG:
      schema = {{"type", "boolean"}};
      default_text = row.default_value != 0 ? "true" : "false";
      fallback = row.default_value != 0;
      break;
    case SIMILITUDE_CHOICE:
      schema = {{"enum", split_choices(row.choices != nullptr ? row.choices : "")}};
      default_text = row.default_text != nullptr ? row.default_text : "";
      fallback = default_text;
      break;
    default: {
      const bool integer = row.type == SIMILITUDE_INTEGER;
      schema = integer ? Json{{"type", "integer"}} : quantity(unit, row.minimum >= 0 ? Sign::not_negative : Sign::any);
      if (integer || unit == "1") {
        Json& number = integer ? schema : schema["anyOf"][0];
        if (std::isfinite(row.minimum)) number["minimum"] = row.minimum;
        if (std::isfinite(row.maximum)) number["maximum"] = row.maximum;
      }
      if (std::isnan(row.default_value)) break;
      default_text = format_quantity(row.default_value, unit);
      fallback = integer ? Json(std::llround(row.default_value)) : unit == "1" ? Json(row.default_value) : Json(default_text);
    }
  }
  if (row.required == 0 && !fallback.is_null()) schema["default"] = fallback;
  std::string doc = row.doc != nullptr ? row.doc : "";
  if (unit != "1") doc += " [" + unit + "]";
  if (row.typical_minimum < row.typical_maximum)
    doc += (doc.empty() || doc.ends_with('.') ? " Mostly " : ". Mostly ") + format_quantity(row.typical_minimum, unit) + " to " +
           format_quantity(row.typical_maximum, unit);
  if (doc.ends_with('.')) doc.pop_back();   // the default follows
  return with_doc(schema, doc, row.required != 0 ? "" : default_text);
}

/// Some or all of a contact model's parameters for each pair of materials.
Json pair_schema(const Json& parameters) {
  const Json one{{"type", Json::array({"object", "null"})}, {"properties", parameters}, {"additionalProperties", false}};
  const Json pairs{{"type", "object"}, {"propertyNames", {{"pattern", "^[^. \\t]+-[^. \\t]+$"}}}, {"additionalProperties", one}};
  return with_doc(pairs, std::string(contact_pair_key().doc), "");
}

std::string description_of(const similitude_descriptor& model) {
  std::string text = model.title != nullptr ? model.title : model.id;
  if (model.reference != nullptr) text += std::string(". ") + model.reference;
  return text;
}

/// A model of one kind: its id alone if nothing is required, or a map with its own parameters.
Json model_schema(const std::string& kind, const Catalogue& catalogue) {
  Json choices = Json::array(), short_forms = Json::array();
  for (const PluginEntry& plugin : catalogue.plugins()) {
    const similitude_descriptor& model = *plugin.descriptor;
    if (model.kind != kind) continue;
    Json properties = Json::object();
    Json required = Json::array({"id"});
    for (std::uint32_t i = 0; i < model.parameter_count; ++i) {
      const similitude_parameter& row = model.parameters[i];
      properties[row.name] = parameter_schema(row);
      if (row.required != 0) required.push_back(row.name);
    }
    const Json pairs = pair_schema(properties);
    properties["id"] = {{"const", model.id}};
    if (kind == "contact") properties[std::string(contact_pair_key().name)] = pairs;
    if (kind == "scaling") {
      const CaseKey& key = simulated_stiffness_key();
      const std::string name(key.name);
      if (!properties.contains(name)) properties[name] = with_doc(quantity(key.unit, key.sign), std::string(key.doc), "");
    }
    if (required.size() == 1) short_forms.push_back(model.id);
    Json one{{"type", "object"},
             {"title", model.title != nullptr ? model.title : model.id},
             {"description", description_of(model)},
             {"properties", properties},
             {"additionalProperties", false}};
    if (kind == "contact") {  // a parameter may be each pair's own
      one["required"] = Json::array({"id"});
      one["anyOf"] = Json::array({{{"required", required}}, {{"required", {contact_pair_key().name}}}});
    } else {
      one["required"] = required;
    }
    choices.push_back(one);
  }
  if (!short_forms.empty()) choices.insert(choices.begin(), Json{{"enum", short_forms}});
  if (choices.empty()) return false;  // no such plugin: nothing is valid
  return {{"anyOf", choices}};
}

Json table_schema(KeyTable table, const Catalogue& catalogue);

Json form_schema(const CaseKey& key, const Catalogue& catalogue) {
  const Json one = quantity(key.unit, key.sign);
  const Json every = quantity(key.unit, key.sign, "every ");
  switch (key.form) {
    case Form::text:
      return {{"type", Json::array({"string", "number"})}};
    case Form::integer: {
      Json integer{{"type", "integer"}};
      if (key.sign != Sign::any) integer["minimum"] = key.sign == Sign::positive ? 1 : 0;
      return integer;
    }
    case Form::flag:
      return {{"type", "boolean"}};
    case Form::choice:
      return {{"enum", split_choices(key.choices)}};
    case Form::quantity:
      return one;
    case Form::quantity_or_auto:
      return either({{"const", "auto"}}, one);
    case Form::interval:
      return list_of(one, 2, 2);
    case Form::box:
      return list_of(one, 3, 3);
    case Form::box_or_cube:
    case Form::gravity:
      return either(one, list_of(one, 3, 3));
    case Form::positions:
      return either(one, list_of(one, 1, 0));
    case Form::every:
      return every;
    case Form::every_or_none:
      return either({{"const", "none"}}, every);
    case Form::axes:
      return list_of({{"enum", {"x", "y", "z"}}}, 0, 0);
    case Form::texts:
      return list_of({{"type", "string"}}, 0, 0);
    case Form::section:
      return table_schema(key.table(), catalogue);
    case Form::named_sections:
      return {{"type", "object"},
              {"propertyNames", {{"pattern", "^[^. \\t]+$"}}},
              {"additionalProperties", table_schema(key.table(), catalogue)}};
    case Form::model:
      return model_schema(std::string(key.choices), catalogue);
    case Form::effects:
      return either({{"const", "auto"}}, list_of(model_schema(std::string(key.choices), catalogue), 0, 0));
  }
  return true;
}

Json table_schema(KeyTable table, const Catalogue& catalogue) {
  Json properties = Json::object(), required = Json::array();
  for (const CaseKey& key : table) {
    const std::string name(key.name);
    properties[name] = form_schema(key, catalogue);
    if (properties[name].is_object())
      properties[name] = with_doc(properties[name], std::string(key.doc), std::string(key.default_text));
    if (key.required) required.push_back(name);
  }
  Json schema{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  return schema;
}

/// Keys that effects bring, in the sections where they may stand.
void add_quantities(Json& scene, const Catalogue& catalogue) {
  const auto add = [](Json& section, const similitude_quantity& row, const std::string& who) {
    if (section["properties"].contains(row.name)) return;
    std::string doc = row.doc;
    if (doc.ends_with('.')) doc.pop_back();
    section["properties"][row.name] = with_doc(quantity(row.unit, row.minimum >= 0 ? Sign::not_negative : Sign::any), doc + " (" + who + ")",
                                               std::isnan(row.default_value) ? "" : format_quantity(row.default_value, row.unit));
  };
  Json& sections = scene["properties"];
  for (const std::string& id : catalogue.ids("effect")) {
    for (const similitude_quantity& row : quantities_of(*catalogue.find("effect", id))) {
      const bool of_particles = row.kind == SIMILITUDE_PARTICLE_SCALAR || row.kind == SIMILITUDE_PARTICLE_PROPERTY;
      add(of_particles ? sections["particles"]["additionalProperties"] : row.kind == SIMILITUDE_WALL_PROPERTY ? sections["walls"] : sections["gas"],
          row, id);
      if (row.kind == SIMILITUDE_GAS_SCALAR) add(sections["patches"]["additionalProperties"], row, id);
    }
  }
}

}  // namespace

nlohmann::json case_schema(const Catalogue& catalogue) {
  Json schema = table_schema(case_keys(), catalogue);
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Similitude case";
  schema["properties"]["similitude"] = {{"const", k_case_version}, {"description", "version of the case format"}};
  Json& patch = schema["properties"]["scene"]["properties"]["patches"]["additionalProperties"];
  patch["oneOf"] = Json::array({{{"required", {"velocity"}}}, {{"required", {"pressure"}}}});
  Json& plates = schema["properties"]["scene"]["properties"]["baffles"]["additionalProperties"];
  plates["oneOf"] = Json::array({{{"required", {"at_x"}}}, {{"required", {"at_y"}}}, {{"required", {"at_z"}}}});
  add_quantities(schema["properties"]["scene"], catalogue);
  return schema;
}

}  // namespace similitude
