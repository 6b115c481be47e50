#include "output/resolved_case.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace similitude {
namespace {

using json = nlohmann::ordered_json;

json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

template <class T>
json value_or_null(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

json extent_json(const std::array<Interval, 3>& extent) {
  json out;
  for (std::size_t a = 0; a < 3; ++a) out[std::string(1, "xyz"[a]) + " [m]"] = {extent[a].low, extent[a].high};
  return out;
}

json particles_json(const RealScene& s) {
  json out;
  for (const ParticleClass& p : s.particles)
    out[p.name] = {{"diameter [m]", p.diameter}, {"density [kg/m^3]", p.density}, {"count", value_or_null(p.count)}};
  return out;
}

json patches_json(const RealScene& s) {
  json out = json::object();
  for (const Patch& p : s.patches) {
    json patch = {{"face", face_name(p.face)}, {"rest", p.rest}, {"extent", extent_json(p.extent)}};
    if (p.kind == PatchKind::velocity) {
      patch["velocity [m/s]"] = p.velocity;
      patch["ramp [s]"] = p.ramp;
    } else {
      patch["pressure [Pa]"] = p.pressure;
    }
    out[p.name] = patch;
  }
  return out;
}

json baffles_json(const RealScene& s) {
  json out = json::array();
  for (const Baffle& b : s.baffles)
    out.push_back({{"name", b.name},
                   {"normal", std::string(1, "xyz"[static_cast<int>(b.normal)])},
                   {"position [m]", b.position},
                   {"thickness [m]", b.thickness},
                   {"extent", extent_json(b.extent)}});
  return out;
}

json fill_json(const BedFill& fill) {
  constexpr const char* names[] = {"settle", "lattice", "file", "none"};
  return {{"fill", names[static_cast<int>(fill.kind)]},
          {"file", fill.file.empty() ? json(nullptr) : json(fill.file)},
          {"height [m]", value_or_null(fill.height)},
          {"seed", fill.seed},
          {"cache", fill.cache}};
}

json walls_json(const RealScene& s) {
  json out;
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    for (const Side side : {Side::low, Side::high}) {
      const WallKind wall = s.walls[static_cast<std::size_t>(axis)][static_cast<std::size_t>(side)];
      out[face_name({axis, side})] = s.periodic[static_cast<std::size_t>(axis)] ? "periodic"
                                     : wall == WallKind::slip                   ? "slip"
                                                                                : "no_slip";
    }
  return out;
}

json model_json(const ModelChoice& model) {
  json parameters = json::object();
  for (const ModelParameter& p : model.parameters)
    parameters[p.name] = p.text.empty() ? number_or_null(p.real) : json(p.text);
  return {{"id", model.id}, {"parameters", parameters}};
}

json models_json(const Models& models) {
  json effects = json::array();
  for (const ModelChoice& effect : models.effects) effects.push_back(model_json(effect));
  return {{"drag", model_json(models.drag)},
          {"contact", model_json(models.contact)},
          {"fluid", model_json(models.fluid)},
          {"scaling", model_json(models.scaling)},
          {"effects", effects},
          {"effects_auto", models.effects_auto}};
}

}  // namespace

std::string resolved_case_json(const RealScene& s) {
  json scene;
  scene["domain"] = {{"size [m]", s.size}, {"cell [m]", s.cell}};
  scene["gravity [m/s^2]"] = s.gravity;
  scene["walls"] = walls_json(s);
  scene["gas"] = {{"density [kg/m^3]", s.gas_density}, {"viscosity [Pa s]", s.gas_viscosity}};
  scene["particles"] = particles_json(s);
  scene["bed"] = fill_json(s.bed);
  scene["patches"] = patches_json(s);
  scene["baffles"] = baffles_json(s);
  scene["smoothing_length [m]"] = value_or_null(s.smoothing_length);

  json out;
  out["title"] = s.title;
  out["name"] = s.name;
  out["scene"] = scene;
  out["models"] = models_json(s.models);
  out["time"] = {
      {"end [s]", s.time.end}, {"dt [s]", value_or_null(s.time.dt)}, {"gas_dt [s]", value_or_null(s.time.gas_dt)}};
  out["output"] = {{"vtk_every [s]", s.output.vtk_every},
                   {"monitor_every [s]", s.output.monitor_every},
                   {"profiles", {{"z [m]", s.output.profiles.z}, {"from [s]", s.output.profiles.from}}}};
  return out.dump(2, ' ', false, json::error_handler_t::replace);
}

}  // namespace similitude
