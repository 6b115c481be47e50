#include "output/manifest.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "loader/json_text.h"
#include "output/sha256.h"
#include "output/whole_file.h"

namespace similitude {
namespace {

using json = nlohmann::ordered_json;

json ratios_json(const similitude_ratios& s) {
  return {{"length", s.length},
          {"diameter", s.diameter},
          {"drag_diameter", s.drag_diameter},
          {"particle_density", s.particle_density},
          {"gas_density", s.gas_density},
          {"gas_viscosity", s.gas_viscosity},
          {"velocity", s.velocity},
          {"time", s.time},
          {"stiffness", s.stiffness},
          {"modulus", s.modulus},
          {"energy_loss", s.energy_loss},
          {"parcel_weight", s.parcel_weight}};
}

/// What the values of each file were divided by, in terms of the ratios beside.
json divided_by_json() {
  return {{"particles: points, diameter [m]", "length"},
          {"particles: material_diameter [m]", "diameter"},
          {"particles: velocity, speed [m/s]", "velocity"},
          {"particles: angular_velocity [rad/s]", "angular_velocity"},
          {"fluid: origin, spacing", "length"},
          {"fluid: gas_velocity, gas_speed [m/s]", "velocity"},
          {"fluid: pressure [Pa]", "pressure"},
          {"monitors: time [s]", "time"},
          {"monitors: bed_height, mean_height [m]", "length"},
          {"monitors: largest_speed [m/s]", "velocity"},
          {"monitors: solids_mass [kg]", "mass"},
          {"monitors: solids_momentum [kg m/s]", "mass velocity"},
          {"monitors: kinetic_energy, …_work [J]", "mass velocity^2"},
          {"monitors: …_impulse_z [kg m/s]", "mass velocity"},
          {"monitors: rotational_energy [J]", "mass (diameter angular_velocity)^2"},
          {"monitors: gas_mass, gas_in, gas_out [kg]", "gas_density length^3"},
          {"monitors: gas_momentum [kg m/s]", "gas_density length^3 velocity"},
          {"monitors: inflow, outflow [kg/s]", "gas_density length^2 velocity"},
          {"monitors: pressure_drop [Pa]", "pressure"},
          {"probes: time [s]", "time"},
          {"probes: x, y, z [m]", "length"},
          {"probes: pressure [Pa]", "pressure"},
          {"probes: gas_velocity [m/s]", "velocity"},
          {"profiles: x, y, z [m]", "length"},
          {"profiles: vertical_velocity [m/s]", "velocity"},
          {"timing: simulated_s", "time"},
          {"counts, fractions, ratios [1], [% of d]", "1"}};
}

json map_back_json(const MapBack& map) {
  return {{"length", map.ratios.length},
          {"diameter", map.ratios.diameter},
          {"time", map.ratios.time},
          {"velocity", map.ratios.velocity},
          {"angular_velocity", map.ratios.angular_velocity},
          {"pressure", map.ratios.pressure},
          {"force", map.ratios.force},
          {"mass", map.ratios.mass},
          {"gas_density", map.gas_density},
          {"jet_ratio", map.jet_ratio},
          {"divided_by", divided_by_json()},
          {"note", map_back_note(map)}};
}

json plugins_json(const std::vector<ManifestPlugin>& plugins) {
  json list = json::array();
  for (const ManifestPlugin& p : plugins)
    list.push_back({{"kind", p.kind}, {"id", p.id}, {"version", p.version}, {"file", p.file}, {"sha256", p.sha256}});
  return list;
}

std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name"))
      if (const std::size_t colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown";
}

}  // namespace

ManifestPlugin manifest_plugin(const PluginEntry& plugin) {
  return {plugin.descriptor->kind, plugin.descriptor->id, plugin.descriptor->version, plugin.file.string(),
          sha256_of_file(plugin.file)};
}

Machine this_machine() {
  Machine machine;
  machine.processor = processor_name();
  machine.cores = static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN));
  utsname names{};
  if (::uname(&names) == 0) machine.kernel = std::string(names.sysname) + " " + names.release + " " + names.machine;
  return machine;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

void write_manifest(const OutputDirectory& directory, const Manifest& m, const CaseIdentity& identity) {
  json out;
  out["program"] = {{"name", "similitude"}, {"version", m.program_version}};
  out["abi"] = {{"major", SIMILITUDE_ABI_MAJOR}, {"minor", SIMILITUDE_ABI_MINOR}};
  out["command"] = m.command;
  out["case_file"] = m.case_file;
  out["status"] = m.status;
  out["exit_status"] = m.exit_status >= 0 ? json(m.exit_status) : json(nullptr);
  out["exit_reason"] = m.exit_reason;
  out["started"] = m.started;
  out["resumed"] = json::array();
  for (const Resumption& r : m.resumed)
    out["resumed"].push_back({{"checkpoint", r.checkpoint},
                              {"simulated_s", r.simulated_s},
                              {"started", r.started},
                              {"command", r.command},
                              {"threads", r.threads}});
  out["ended"] = m.ended.empty() ? json(nullptr) : json(m.ended);
  out["simulated_s"] = m.simulated_s;
  out["particles"] = m.particles;
  out["state_hash"] = m.state_hash.empty() ? json(nullptr) : json(m.state_hash);
  out["machine"] = {{"processor", m.machine.processor}, {"cores", m.machine.cores}, {"kernel", m.machine.kernel}};
  out["threads"] = m.threads;
  out["scaling"] = {{"law", m.map_back.scaling_law}, {"ratios", ratios_json(m.scaling)}};
  out["map_back"] = map_back_json(m.map_back);
  out["plugins"] = plugins_json(m.plugins);
  out["bed_sha256"] = identity.bed_sha256.empty() ? json(nullptr) : json(identity.bed_sha256);
  out["case"] = json::parse(identity.resolved_case);
  write_whole_file(directory.file("manifest.json"), json_text(out) + "\n");
}

}  // namespace similitude
