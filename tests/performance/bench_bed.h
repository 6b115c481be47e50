#pragma once
/// The bed that other codes were measured on, for measurements of our own: 1 mm spheres of 1040 kg/m^3 in a box 145 x 20 mm,
/// k = 1000 N/m, e = 0.74, friction 0.3 with tangential history, dt = 2.5e-6 s (a collision takes 21 of them).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include <similitude/abi.h>

#include "particles/engine.h"

extern "C" {
extern const similitude_entry similitude_plugin;   // the contact law compiled into the program
}

namespace similitude::bench {

inline constexpr double k_diameter = 1e-3;    // [m]
inline constexpr double k_density = 1040;     // [kg/m^3]
inline constexpr double k_mass = k_density * 3.14159265358979323846 / 6 * k_diameter * k_diameter * k_diameter;
inline constexpr double k_stiffness = 1000;   // [N/m]
inline constexpr double k_restitution = 0.74;
inline constexpr double k_friction = 0.3;
inline constexpr double k_dt = 2.5e-6;        // [s]
inline constexpr double k_wide = 0.145, k_deep = 0.02;   // [m]
inline constexpr double k_gravity = 9.81;     // [m/s^2]

/// Open space above the bed as other codes are given it: their cells fill the whole box.
inline ModelScene box_around(const ParticleStore& bed) {
  double top = 0;
  for (const Row& p : bed.position) top = std::max(top, p.z);
  ModelScene scene;
  scene.size = {k_wide, k_deep, 1.15 * top + 12 * k_diameter};
  return scene;
}

/// A model of a plugin that is compiled in, with values by name and defaults for the rest.
template <class Functions>
Model<Functions> model_of(const similitude_entry& entry, const std::map<std::string, double>& given) {
  const similitude_descriptor& plugin = *entry.descriptors[0];
  std::vector<similitude_value> values;
  for (std::uint32_t p = 0; p < plugin.parameter_count; ++p) {
    const auto it = given.find(plugin.parameters[p].name);
    values.push_back({it == given.end() ? plugin.parameters[p].default_value : it->second, nullptr});
  }
  similitude_host host{};
  host.struct_size = sizeof host;
  similitude_bed bed{};
  bed.struct_size = sizeof bed;
  similitude_status status{};
  void* instance = plugin.create(&host, &bed, values.data(), 1, &status);
  if (!instance) {
    std::fprintf(stderr, "%s\n", status.text);
    std::exit(2);
  }
  return Model<Functions>(plugin, instance);
}

inline ContactModel contact_law(double stiffness, double restitution, double friction) {
  return model_of<similitude_contact_functions>(
      similitude_plugin, {{"stiffness", stiffness}, {"restitution", restitution}, {"friction", friction}, {"attraction", 1}});
}

inline EngineOptions options(double dt, double damping = 0, double skin = 0) {
  EngineOptions out;
  out.dt = dt;
  out.gravity = {0, 0, -k_gravity};
  out.velocity_damping = damping;
  out.skin = skin;
  return out;
}

/// A reproducible number in [-1, 1).
inline double scatter() {
  static std::uint64_t state = 12345;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) / 4503599627370496.0 - 1;
}

inline ParticleStore empty_bed(bool coupling = false) { return ParticleStore({.rotation = true, .coupling = coupling}); }

/// A cubic lattice from the floor up, as many columns as stand in the box.
inline ParticleStore lattice(std::size_t count, double pitch, double jitter, ParticleStore bed = empty_bed()) {
  const auto nx = static_cast<std::size_t>((k_wide - 0.1 * k_diameter) / pitch);
  const auto ny = static_cast<std::size_t>((k_deep - 0.1 * k_diameter) / pitch);
  for (std::size_t n = 0; n < count; ++n) {
    const auto column = static_cast<double>(n % nx), line = static_cast<double>(n / nx % ny);
    const auto layer = static_cast<double>(n / (nx * ny));
    bed.add(n, 0, (column + 0.5) * pitch + jitter * scatter(), (line + 0.5) * pitch + jitter * scatter(),
            (layer + 0.5) * pitch + jitter * scatter(), 0.5 * k_diameter, k_mass);
  }
  return bed;
}

/// As many contacts as in a settled bed (4.3 per particle) without settling one: overlaps of some 1e-4 diameters, so that
/// nothing moves far in the short time of a measurement.
inline ParticleStore resting_lattice(std::size_t count, bool coupling = false) {
  return lattice(count, (1 - 0.5e-4) * k_diameter, 1e-4 * k_diameter, empty_bed(coupling));
}

}  // namespace similitude::bench
