#include "particles/fill.h"

#include <algorithm>
#include <cmath>

#include <similitude/sphere.h>

#include "particles/bed_cache.h"
#include "particles/bed_file.h"
#include "particles/lattice.h"
#include "particles/rounded_mm.h"
#include "particles/settle.h"
#include "particles/sphere_mass.h"
#include "scene/messages.h"

namespace similitude {

namespace {

constexpr double k_densest_bed = 0.64;   // [-], random close packing: more particles than this never settle below a height

std::size_t add_particle(ParticleStore& particles, const ModelScene& scene, std::uint32_t species, const std::array<double, 3>& at) {
  const ParticleClass& type = scene.particles[species];
  return particles.add(particles.size(), species, at[0], at[1], at[2], type.diameter / 2, sphere_mass(type.density, type.diameter));
}

/// How many of each class, or, for a bed filled to a height, certainly enough.
std::vector<std::int64_t> counts(const ModelScene& scene) {
  std::vector<std::int64_t> out;
  for (const ParticleClass& type : scene.particles) {
    if (scene.bed.height) {
      const double d = type.diameter, height = *scene.bed.height + 2 * d;
      const double each = sphere_volume(d) * static_cast<double>(scene.particles.size());
      out.push_back(static_cast<std::int64_t>(std::ceil(k_densest_bed * scene.size[0] * scene.size[1] * height / each)));
    } else {
      out.push_back(type.count.value_or(0));
    }
  }
  return out;
}

void refuse_if_too_many(const ModelScene& scene, double needed) {
  if (needed <= scene.size[2]) return;
  throw InputError(scene.bed.mark, "scene.bed",
                   "the particles do not fit: they need a height of about " + rounded_mm(needed) + ", the simulated domain has " +
                       rounded_mm(scene.size[2]) + ".",
                   "Fewer particles, or a higher domain.");
}

void refuse_if_too_large(const ModelScene& scene) {
  for (const ParticleClass& type : scene.particles) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (scene.size[axis] >= type.diameter) continue;
      throw InputError(scene.bed.mark, "scene.bed",
                       "particles " + type.name + " of " + rounded_mm(type.diameter) + " do not fit into a domain that is " +
                           rounded_mm(scene.size[axis]) + " wide along " + "xyz"[axis] + " (simulated bed).",
                       "Smaller particles, a milder scaling, or a larger domain.");
    }
  }
}

/// The rows by id, without those that reach above `height`.
std::vector<CachedParticle> below(const ParticleStore& settled, double height) {
  std::vector<std::uint32_t> row_of(settled.size());
  for (std::size_t row = 0; row < settled.size(); ++row) row_of[settled.id[row]] = static_cast<std::uint32_t>(row);
  std::vector<CachedParticle> bed;
  for (const std::uint32_t row : row_of) {
    const Row& at = settled.position[row];
    if (at.z + at.w <= height) bed.push_back({{at.x, at.y, at.z}, settled.species[row]});
  }
  return bed;
}

std::vector<CachedParticle> settled_bed(const ModelScene& scene, const ContactModel& law, const FillOptions& options, bool rotation,
                                        FilledBed& report) {
  const std::vector<std::uint32_t> classes = mixed_classes(counts(scene), scene.bed.seed);
  if (classes.empty()) return {};
  if (!(scene.gravity[2] < 0)) {
    throw InputError(scene.bed.mark, "scene.bed", "a bed settles under gravity, but gravity does not point down.",
                     "Write bed: {fill: lattice}, or give scene.gravity a negative third value.");
  }
  refuse_if_too_large(scene);
  const Places places = crowded_places(scene, classes);
  double top = 0;
  ParticleStore particles(StoreFields{.rotation = rotation, .coupling = false});
  particles.reserve(places.size());
  for (std::size_t id = 0; id < places.size(); ++id) {
    add_particle(particles, scene, classes[id], places[id]);
    top = std::max(top, places[id][2] + scene.particles[classes[id]].diameter / 2);
  }
  refuse_if_too_many(scene, top);
  report.sub_steps = settle(particles, scene, law, options);
  return below(particles, scene.bed.height.value_or(HUGE_VAL));
}

void fill_settled(ParticleStore& particles, const ModelScene& scene, const ContactModel& law, const FillOptions& options,
                  FilledBed& report) {
  const std::string folder = options.cache_folder.empty() ? cache_folder_of_beds() : options.cache_folder;
  const std::string key = bed_key(scene, law, options);
  const std::string file = scene.bed.cache && !folder.empty() ? bed_cache_file(folder, key) : "";
  std::optional<std::vector<CachedParticle>> bed;
  if (!file.empty()) bed = read_bed(file, key);
  report.from_cache = bed.has_value();
  if (!bed) {
    bed = settled_bed(scene, law, options, particles.fields.rotation, report);
    if (!file.empty() && write_bed(file, key, *bed)) report.cache_file = file;
  } else {
    report.cache_file = file;
  }
  particles.reserve(bed->size());
  for (const CachedParticle& particle : *bed) add_particle(particles, scene, particle.species, particle.position);
}

void fill_lattice(ParticleStore& particles, const ModelScene& scene) {
  std::vector<std::uint32_t> classes = mixed_classes(counts(scene), scene.bed.seed);
  const Places places = lattice_places(scene, classes);
  const double height = scene.bed.height.value_or(HUGE_VAL);
  if (places.size() < classes.size() && !scene.bed.height) {
    throw InputError(scene.bed.mark, "scene.bed",
                     "the lattice of the simulated domain has " + std::to_string(places.size()) + " places for " +
                         std::to_string(classes.size()) + " particles.",
                     "Fewer particles, a higher domain, or bed: {fill: settle}, which packs more densely.");
  }
  particles.reserve(places.size());
  for (std::size_t n = 0; n < places.size(); ++n) {
    if (places[n][2] + scene.particles[classes[n]].diameter / 2 <= height) add_particle(particles, scene, classes[n], places[n]);
  }
}

}  // namespace

FilledBed fill_bed(ParticleStore& particles, const ModelScene& scene, const ContactModel& law, const FillOptions& options) {
  FilledBed report;
  switch (scene.bed.kind) {
    case FillKind::settle: fill_settled(particles, scene, law, options, report); break;
    case FillKind::lattice: fill_lattice(particles, scene); break;
    case FillKind::file: fill_from_file(particles, scene, options); break;
    case FillKind::none: return report;
  }
  if (particles.size() == 0) return report;
  report.height = bed_height(particles, scene);
  double largest = 0;
  for (const Row& p : particles.position) largest = std::max(largest, 2 * p.w);
  report.solids_fraction = solids_fraction_below(particles, scene, report.height - 2 * largest);
  return report;
}

}  // namespace similitude
