#include "scene/resolved.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "loader/json_text.h"
#include "scene/case_keys.h"
#include "scene/material_pairs.h"
#include "scene/units.h"

namespace similitude {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array k_axes{Axis::x, Axis::y, Axis::z};
std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }
std::string letter(Axis axis) { return std::string(1, axis_name(axis)); }

std::string in(double si, const char* unit) { return exact_number(si) + " " + unit; }

Json triple(const std::array<double, 3>& values, const char* unit) {
  return {in(values[0], unit), in(values[1], unit), in(values[2], unit)};
}

Json interval(const Interval& ends) { return {in(ends.low, "m"), in(ends.high, "m")}; }

/// The unit in which the SI value stands for itself: the plugin's own, or what it is made of.
std::string si_unit(const std::string& unit) {
  const Unit parsed = parse_unit(unit).value_or(Unit{});
  return parsed.decimal == 0 && parsed.factor == 1 ? unit : base_units(parsed.dimension);
}

Json value(const ModelParameter& parameter, const similitude_parameter& row) {
  const std::string unit = row.unit == nullptr || *row.unit == 0 ? "1" : si_unit(row.unit);
  if (row.type == SIMILITUDE_CHOICE) return parameter.text;
  if (row.type == SIMILITUDE_FLAG) return parameter.real != 0;
  if (row.type == SIMILITUDE_INTEGER) return static_cast<std::int64_t>(parameter.real);
  if (unit == "1") return parameter.real;
  return in(parameter.real, unit.c_str());
}

/// Neither given nor has it a default.
bool is_open(const ModelParameter& parameter, const similitude_parameter& row) {
  return row.type == SIMILITUDE_CHOICE ? parameter.text.empty() : std::isnan(parameter.real);
}

Json model(const ModelChoice& choice, const Catalogue& catalogue) {
  Json result{{"id", choice.id}};
  const PluginEntry* plugin = catalogue.find(choice.kind, choice.id);
  if (plugin == nullptr) return result;
  for (std::size_t i = 0; i < choice.parameters.size(); ++i) {
    const similitude_parameter& row = plugin->descriptor->parameters[i];
    if (!is_open(choice.parameters[i], row)) result[row.name] = value(choice.parameters[i], row);
  }
  return result;
}

/// What each pair says itself; the rest is common, so that --set still reaches it.
Json contact_pairs(const RealScene& scene, const Catalogue& catalogue) {
  Json result = Json::object();
  const std::vector<MaterialPair> pairs = material_pairs(scene.particles.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const ModelChoice& choice = scene.models.contact_pairs[p];
    const PluginEntry* plugin = catalogue.find(choice.kind, choice.id);
    Json& one = result[pair_name(scene.particles, pairs[p])] = Json::object();
    for (std::size_t i = 0; plugin != nullptr && i < choice.parameters.size(); ++i)
      if (choice.parameters[i].given) one[choice.parameters[i].name] = value(choice.parameters[i], plugin->descriptor->parameters[i]);
  }
  return result;
}

Json bed(const BedFill& fill) {
  static const char* const kinds[] = {"settle", "lattice", "file", "none"};
  Json result{{"fill", kinds[static_cast<int>(fill.kind)]}};
  if (!fill.file.empty()) result["file"] = fill.file;
  if (fill.height) result["height"] = in(*fill.height, "m");
  result["seed"] = fill.seed;
  result["cache"] = fill.cache;
  return result;
}

void add(Json& section, const GivenValues& values) {
  for (const GivenValue& given : values) section[given.name] = given.unit == "1" ? Json(given.value) : Json(in(given.value, si_unit(given.unit).c_str()));
}

Json patch(const Patch& one) {
  Json result{{"face", face_name(one.face)}};
  for (const Axis axis : k_axes)
    if (axis != one.face.axis && !one.rest) result[letter(axis)] = interval(one.extent[index(axis)]);
  if (one.rest) result["rest"] = true;
  if (one.kind == PatchKind::pressure) {
    result["pressure"] = in(one.pressure, "Pa");
  } else {
    result["velocity"] = in(one.velocity, "m/s");
    result["ramp"] = in(one.ramp, "s");
  }
  add(result, one.values);
  return result;
}

/// Plates written as one list come together again under one name.
Json baffles(const std::vector<Baffle>& plates) {
  Json result = Json::object();
  for (const Baffle& plate : plates) {
    const std::size_t dot = plate.name.find('.');
    Json& group = result[plate.name.substr(0, dot)];
    const std::string at = "at_" + letter(plate.normal);
    if (dot == std::string::npos) {
      group[at] = in(plate.position, "m");
    } else {
      group[at].push_back(in(plate.position, "m"));
    }
    for (const Axis axis : k_axes)
      if (axis != plate.normal) group[letter(axis)] = interval(plate.extent[index(axis)]);
    group["thickness"] = in(plate.thickness, "m");
  }
  return result;
}

Json bed_scene(const RealScene& scene) {
  Json result;
  result["domain"] = {{"size", triple(scene.size, "m")}, {"cell", triple(scene.cell, "m")}};
  result["gas"] = {{"density", in(scene.gas_density, "kg/m^3")}, {"viscosity", in(scene.gas_viscosity, "Pa s")}};
  add(result["gas"], scene.gas_values);
  for (const ParticleClass& species : scene.particles) {
    Json& one = result["particles"][species.name];
    one = {{"diameter", in(species.diameter, "m")}, {"density", in(species.density, "kg/m^3")}};
    if (species.count) one["count"] = *species.count;
    add(one, species.values);
  }
  result["bed"] = bed(scene.bed);
  for (const Patch& one : scene.patches) result["patches"][one.name] = patch(one);
  if (!scene.baffles.empty()) result["baffles"] = baffles(scene.baffles);
  Json periodic = Json::array();
  for (const Axis axis : k_axes) {
    if (scene.periodic[index(axis)]) {
      periodic.push_back(letter(axis));
      continue;
    }
    for (const Side side : {Side::low, Side::high})
      result["walls"][face_name({axis, side})] =
          scene.walls[index(axis)][static_cast<std::size_t>(side)] == WallKind::slip ? "slip" : "no_slip";
  }
  if (!scene.wall_values.empty()) add(result["walls"], scene.wall_values);
  result["periodic"] = periodic;
  result["gravity"] = triple(scene.gravity, "m/s^2");
  return result;
}

Json or_auto(const std::optional<double>& step) { return step ? Json(in(*step, "s")) : Json("auto"); }

}  // namespace

std::string resolved_case(const RealScene& scene, const std::vector<std::filesystem::path>& plugin_paths,
                          const Catalogue& catalogue) {
  Json root;
  root["similitude"] = k_case_version;
  root["title"] = scene.title;
  root["plugin_paths"] = Json::array();
  for (const std::filesystem::path& folder : plugin_paths) root["plugin_paths"].push_back(folder.string());
  root["scene"] = bed_scene(scene);

  const Models& models = scene.models;
  Json& chosen = root["models"];
  chosen["drag"] = model(models.drag, catalogue);
  chosen["contact"] = model(models.contact, catalogue);
  if (!models.contact_pairs.empty())
    chosen["contact"][std::string(contact_pair_key().name)] = contact_pairs(scene, catalogue);
  chosen["fluid"] = model(models.fluid, catalogue);
  chosen["scaling"] = model(models.scaling, catalogue);
  if (models.simulated_stiffness) chosen["scaling"]["stiffness"] = in(*models.simulated_stiffness, "N/m");
  if (models.effects_auto) {
    chosen["effects"] = "auto";
  } else {
    chosen["effects"] = Json::array();
    for (const ModelChoice& effect : models.effects) chosen["effects"].push_back(model(effect, catalogue));
  }

  if (scene.smoothing_length) root["coupling"]["smoothing"] = in(*scene.smoothing_length, "m");
  root["time"] = {
      {"end", in(scene.time.end, "s")}, {"dt", or_auto(scene.time.dt)}, {"gas_dt", or_auto(scene.time.gas_dt)}};
  const Output& output = scene.output;
  root["output"]["vtk"] = output.vtk_every > 0 ? "every " + in(output.vtk_every, "s") : "none";
  root["output"]["monitors"] = "every " + in(output.monitor_every, "s");
  root["output"]["checkpoint"] = output.checkpoint_every > 0 ? "every " + in(output.checkpoint_every, "s") : "none";
  if (!output.profiles.z.empty()) {
    Json& profiles = root["output"]["profiles"];
    profiles["z"] = Json::array();
    for (const double z : output.profiles.z) profiles["z"].push_back(in(z, "m"));
    profiles["from"] = in(output.profiles.from, "s");
  }
  for (const Probe& probe : output.probes) {
    Json& place = root["output"]["probes"][probe.name]["at"] = Json::array();
    for (const double x : probe.place) place.push_back(in(x, "m"));
  }
  return json_text(root);
}

}  // namespace similitude
