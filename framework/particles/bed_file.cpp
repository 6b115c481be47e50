#include "particles/bed_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "particles/particle_file.h"
#include "particles/rounded_mm.h"
#include "particles/sphere_mass.h"
#include "scene/messages.h"

namespace similitude {

namespace {

/// "bed.csv:12", for messages.
std::string source_of(const FileParticle& particle, const std::string& file) {
  std::string place = file;
  if (particle.line > 0) place.append(":").append(std::to_string(particle.line));
  return place;
}

/// The class of a particle from a file: its type where the file has types, else the class nearest in diameter and density.
template <class Bed>
std::uint32_t class_of(const FileParticle& particle, const Scene<Bed>& scene, const FillOptions& options) {
  const std::string place = source_of(particle, scene.bed.file);
  const auto classes = static_cast<int>(scene.particles.size());
  if (classes == 1) return 0;
  if (particle.type) {
    if (*particle.type > classes) {
      throw InputError(place + ": atom type " + std::to_string(*particle.type) + ", but the scene has " + std::to_string(classes) +
                       " classes of particles.");
    }
    return static_cast<std::uint32_t>(*particle.type - 1);
  }
  if (!particle.diameter && !particle.density) {
    throw InputError(place + ": which of the " + std::to_string(classes) + " classes of particles is this?",
                     "Add a column diameter or density to the file.");
  }
  std::uint32_t nearest = 0;
  double least = HUGE_VAL;
  for (std::uint32_t c = 0; c < scene.particles.size(); ++c) {
    const ParticleClass& type = scene.particles[c];
    double distance = 0;   // [-]
    if (particle.diameter) distance += std::abs(std::log(*particle.diameter * options.diameter_ratio / type.diameter));
    if (particle.density) distance += std::abs(std::log(*particle.density * options.density_ratio / type.density));
    if (distance < least) least = distance, nearest = c;
  }
  return nearest;
}

/// Time steps follow the smallest row (FileRows), but smoothing, drag and the audit speak of the class: a particle that is
/// another thing altogether, or was written in another unit, is none of it.
template <class Bed>
void refuse_strangers(const FileParticle& particle, double diameter, double density, const ParticleClass& type, const Scene<Bed>& scene,
                      const FillOptions& options) {
  constexpr double k_farthest = 10;   // [-]
  const auto far = [](double one, double other) { return !(one < k_farthest * other && other < k_farthest * one); };
  const auto refuse = [&](const std::string& what, const std::string& usual) {
    throw InputError(source_of(particle, scene.bed.file) + ": a " + what + " is far from the " + usual + " of its class " + type.name + ".",
                     "Give such particles a class of their own in scene.particles. Files hold metres and kg/m^3 of the real bed.");
  };
  if (far(diameter, type.diameter)) {
    refuse("diameter of " + rounded_mm(diameter / options.diameter_ratio), rounded_mm(type.diameter / options.diameter_ratio));
  }
  const auto in_kg = [&options](double simulated) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g kg/m^3", simulated / options.density_ratio);
    return std::string(text);
  };
  if (far(density, type.density)) refuse("density of " + in_kg(density), in_kg(type.density));
}

/// A row in this bed's lengths and densities.
struct Grain {
  std::uint32_t species;
  double diameter;   // [m]
  double density;    // [kg/m^3]
};

template <class Bed>
Grain grain_of(const FileParticle& particle, const Scene<Bed>& scene, const FillOptions& options) {
  const std::uint32_t species = class_of(particle, scene, options);
  const ParticleClass& type = scene.particles[species];
  const Grain grain{.species = species,
                    .diameter = particle.diameter ? *particle.diameter * options.diameter_ratio : type.diameter,
                    .density = particle.density ? *particle.density * options.density_ratio : type.density};
  refuse_strangers(particle, grain.diameter, grain.density, type, scene, options);
  return grain;
}

}  // namespace

void read_bed_rows(RealScene& scene) {
  const auto is_read = [](const ParticleClass& type) { return type.rows.has_value(); };
  if (scene.bed.kind != FillKind::file || std::ranges::all_of(scene.particles, is_read)) return;
  for (ParticleClass& type : scene.particles) type.rows.emplace();
  for (const FileParticle& particle : read_particle_file(scene.bed.file)) {
    const Grain grain = grain_of(particle, scene, FillOptions{});
    const ParticleClass& type = scene.particles[grain.species];
    FileRows& rows = *scene.particles[grain.species].rows;
    // Ratios, so that a row like its class is exactly 1 and leaves every number of the class as it is.
    const double diameter = grain.diameter / type.diameter;
    const double density = grain.density / type.density;
    const double volume = diameter * diameter * diameter;
    const double mass = density * volume;
    if (rows.count == 0 || mass < rows.least_mass) {
      rows.least_mass = mass;
      rows.diameter_of_lightest = diameter;
    }
    rows.least_diameter = rows.count == 0 ? diameter : std::min(rows.least_diameter, diameter);
    rows.least_density = rows.count == 0 ? density : std::min(rows.least_density, density);
    rows.largest_density = rows.count == 0 ? density : std::max(rows.largest_density, density);
    rows.volume += volume;
    ++rows.count;
  }
}

void fill_from_file(ParticleStore& particles, const ModelScene& scene, const FillOptions& options) {
  const std::vector<FileParticle> read = read_particle_file(scene.bed.file);
  particles.reserve(read.size());
  for (const FileParticle& particle : read) {
    const Grain grain = grain_of(particle, scene, options);
    std::array<double, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at[axis] = particle.position[axis] * options.length_ratio;
      if (at[axis] < 0 || at[axis] > scene.size[axis]) {
        throw InputError(source_of(particle, scene.bed.file) + ": " + std::string(1, "xyz"[axis]) + " = " +
                             rounded_mm(particle.position[axis]) + " is outside the domain, 0 to " +
                             rounded_mm(scene.size[axis] / options.length_ratio) + ".",
                         "Positions are in metres of the real bed.");
      }
    }
    const std::size_t p = particles.add(particles.size(), grain.species, at[0], at[1], at[2], grain.diameter / 2,
                                        sphere_mass(grain.density, grain.diameter));
    particles.velocity[p].x = particle.velocity[0] * options.velocity_ratio;
    particles.velocity[p].y = particle.velocity[1] * options.velocity_ratio;
    particles.velocity[p].z = particle.velocity[2] * options.velocity_ratio;
  }
}

}  // namespace similitude
