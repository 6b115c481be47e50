#include "scene/check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <similitude/abi.h>
#include <similitude/sphere.h>

#include "scene/alignment.h"
#include "scene/messages.h"
#include "scene/units.h"

namespace similitude {
namespace {

// Relative to what is compared: only rounding is forgiven.
constexpr double k_rounding = 1e-9;

constexpr double k_most_cells = 1e9;   // [-], each needs some hundred bytes, and its number 32 bits

constexpr std::array k_axes{Axis::x, Axis::y, Axis::z};
std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }
std::string letter(Axis axis) { return std::string(1, axis_name(axis)); }

void check_cells(const RealScene& scene, const Document& document) {
  const std::string path = "scene.domain.size";
  for (const Axis axis : k_axes) {
    const double size = scene.size[index(axis)], cell = scene.cell[index(axis)];
    if (size < cell / 2)
      throw InputError(document.mark("scene.domain.cell"), "scene.domain.cell",
                       "a cell of " + in_mm(cell) + " is larger than the domain, which has " + in_mm(size) + " along " + letter(axis) + ".",
                       "Use cells of " + in_mm(size) + " or less.");
    const Aligned near = align(size, cell);
    if (near.ok) continue;
    throw InputError(document.mark(path + "." + std::to_string(index(axis))), path,
                     letter(axis) + " = " + in_mm(size) + " is not a whole number of cells of " + in_mm(cell) + ".",
                     near.low > 0 ? off_face_fix(size, cell, largest_diameter(scene))
                                  : "Use " + in_mm(near.high) + ", or set scene.domain.cell: " + in_mm(size) + ".");
  }
  double cells = 1;
  for (const Axis axis : k_axes) cells *= scene.size[index(axis)] / scene.cell[index(axis)];
  if (cells <= k_most_cells) return;
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", cells);
  throw InputError(document.mark("scene.domain.cell"), "scene.domain.cell",
                   std::string("these are ") + text + " cells, more than the 1e9 that can be simulated.", "Are the units right? Use larger cells.");
}

void check_particles(const RealScene& scene, const Document& document) {
  for (const ParticleClass& species : scene.particles) {
    const std::string path = "scene.particles." + species.name + ".diameter";
    for (const Axis axis : k_axes)
      if (species.diameter > scene.size[index(axis)])
        throw InputError(document.mark(path), path,
                         "a particle of " + in_mm(species.diameter) + " does not fit into a domain of " +
                             in_mm(scene.size[index(axis)]) + " along " + letter(axis) + ".",
                         "Is the unit right?");
  }
  if (scene.models.scaling.id == "exact") return;
  for (const ParticleClass& species : scene.particles) {
    if (species.density == scene.particles[0].density) continue;
    const std::string path = "scene.particles." + species.name + ".density";
    throw InputError(document.mark(path), path,
                     "the scaling law " + scene.models.scaling.id + " is for one particle density, but " +
                         species.name + " has " + format_quantity(species.density, "kg/m^3") + " and " +
                         scene.particles[0].name + " " + format_quantity(scene.particles[0].density, "kg/m^3") + ".",
                     "Give all classes one density, or use models.scaling: exact.");
  }
}

bool is_stiffness(const ModelParameter& parameter) {
  return parameter.scales_as == SIMILITUDE_SCALES_AS_STIFFNESS && !std::isnan(parameter.real);
}

/// It must have something to replace; and one for all would undo what the pairs of materials say.
void check_simulated_stiffness(const RealScene& scene, const Document& document) {
  const Models& models = scene.models;
  if (!models.simulated_stiffness) return;
  const std::vector<ModelChoice> sets = models.contact_pairs.empty() ? std::vector{models.contact} : models.contact_pairs;
  if (std::ranges::none_of(sets, [](const ModelChoice& set) { return std::ranges::any_of(set.parameters, is_stiffness); })) {
    const std::string path = "models.scaling.stiffness";
    throw InputError(document.mark(path), path, "the contact model " + models.contact.id + " has no spring stiffness that it could replace.",
                     "Remove this key; a softer modulus is given to the contact model itself.");
  }
  for (const ModelChoice& set : models.contact_pairs)
    for (std::size_t k = 0; k < set.parameters.size(); ++k) {
      const ModelParameter &own = set.parameters[k], &first = models.contact_pairs[0].parameters[k];
      const bool alike = own.real == first.real || (std::isnan(own.real) && std::isnan(first.real));
      if (own.scales_as != SIMILITUDE_SCALES_AS_STIFFNESS || alike) continue;
      const std::string path = "models.scaling.stiffness";
      throw InputError(document.mark(path), path,
                       "it would replace the " + own.name + " of every contact, but models.contact.pair gives pairs of materials "
                       "different ones.",
                       "Remove this key, or give all pairs one " + own.name + ".");
    }
}

void check_amount(const RealScene& scene, const Document& document, std::vector<std::string>& warnings) {
  const BedFill& bed = scene.bed;
  if (bed.height && (bed.kind == FillKind::none || bed.kind == FillKind::file))
    throw InputError(document.mark("scene.bed.height"), "scene.bed.height",
                     "only fill: settle and fill: lattice fill to a height.", "Remove this key, or change fill.");
  if (bed.kind == FillKind::none) return;
  if (scene.particles.empty())
    throw InputError(document.mark("scene"), "scene.particles", "the bed is to be filled, but there are no particles.",
                     "Add a class, or write bed: {fill: none}.");
  if (bed.kind == FillKind::file) {
    for (const ParticleClass& species : scene.particles)
      if (species.count)
        throw InputError(document.mark("scene.particles." + species.name + ".count"),
                         "scene.particles." + species.name + ".count",
                         "the file of scene.bed says how many particles there are.", "Remove this count.");
    return;
  }
  if (bed.height) {
    const std::string path = "scene.bed.height";
    if (*bed.height > scene.size[2])
      throw InputError(document.mark(path), path,
                       "a bed of " + in_mm(*bed.height) + " is higher than the domain of " + in_mm(scene.size[2]) + ".",
                       "Lower the bed, or raise the third value of scene.domain.size.");
    for (const ParticleClass& species : scene.particles)
      if (species.count)
        throw InputError(document.mark("scene.particles." + species.name + ".count"),
                         "scene.particles." + species.name + ".count",
                         "the bed has a height as well; one of the two decides how many particles there are.",
                         "Remove this count, or scene.bed.height.");
    if (scene.particles.size() > 1)
      throw InputError(document.mark(path), path, "a height cannot say how many of each of the classes are wanted.",
                       "Give each class a count instead.");
    return;
  }
  double volume = 0;
  std::string largest;
  for (const ParticleClass& species : scene.particles) {
    const std::string path = "scene.particles." + species.name;
    if (!species.count)
      throw InputError(document.mark(path), path, "nothing says how many particles there are.",
                       "Add a count, or scene.bed.height.");
    volume += static_cast<double>(*species.count) * sphere_volume(species.diameter);
    largest = path;
  }
  const double area = scene.size[0] * scene.size[1];
  const double lowest = volume / (k_densest_packing * area), highest = volume / (k_loosest_packing * area);
  const std::string path = scene.particles.size() == 1 ? largest + ".count" : "scene.particles";
  const std::string range = " higher than the domain of " + in_mm(scene.size[2]) + ": " + in_mm(lowest) + " to " +
                            in_mm(highest) + " (solids fraction 0.64 to 0.5).";
  if (lowest > scene.size[2])
    throw InputError(document.mark(path), path, "these particles make a bed" + range,
                     "Fewer particles, or a larger domain.");
  if (highest > scene.size[2])
    warnings.push_back(InputError(document.mark(path), path, "these particles may make a bed" + range).what());
}

bool inside(const Interval& inner, double size) {
  return inner.low >= -k_rounding * size && inner.high <= size * (1 + k_rounding);
}

void check_inside(const RealScene& scene, const std::array<Interval, 3>& extent, const std::array<SourceMark, 3>& marks,
                  const std::string& path, const std::string& what) {
  for (const Axis axis : k_axes) {
    const Interval& interval = extent[index(axis)];
    if (inside(interval, scene.size[index(axis)])) continue;
    throw InputError(marks[index(axis)], path + "." + letter(axis),
                     "[" + in_mm(interval.low) + ", " + in_mm(interval.high) + "] is outside " + what +
                         ", which goes from 0 mm to " + in_mm(scene.size[index(axis)]) + ".",
                     "Use values in that range, or leave the key out for all of it.");
  }
}

bool overlap(const Patch& a, const Patch& b, const RealScene& scene) {
  for (const Axis axis : k_axes) {
    if (axis == a.face.axis) continue;
    const double low = std::max(a.extent[index(axis)].low, b.extent[index(axis)].low);
    const double high = std::min(a.extent[index(axis)].high, b.extent[index(axis)].high);
    if (high - low <= k_rounding * scene.size[index(axis)]) return false;
  }
  return true;
}

void check_pair(const RealScene& scene, const Patch& first, const Patch& second) {
  if (!(first.face == second.face)) return;
  const std::string path = "scene.patches." + second.name, face = face_name(second.face);
  if (first.rest && second.rest)
    throw InputError(second.mark, path, "the rest of the " + face + " face is taken by " + first.name + " already.",
                     "Only one patch of a face can have rest: true.");
  if (!first.rest && !second.rest && overlap(first, second, scene))
    throw InputError(second.mark, path, "it overlaps " + first.name + " on the " + face + " face.",
                     "Make the extents meet at an edge, or write rest: true for the one that takes what is left.");
}

void check_patches(const RealScene& scene) {
  for (std::size_t i = 0; i < scene.patches.size(); ++i) {
    const Patch& patch = scene.patches[i];
    const std::string path = "scene.patches." + patch.name, face = face_name(patch.face);
    if (scene.periodic[index(patch.face.axis)])
      throw InputError(
          patch.mark, path,
          "the domain is periodic along " + letter(patch.face.axis) + ", so its " + face + " face holds no patch.",
          "Take " + letter(patch.face.axis) + " out of scene.periodic, or remove the patch.");
    check_inside(scene, patch.extent, patch.extent_mark, path, "the " + face + " face");
    for (std::size_t j = 0; j < i; ++j) check_pair(scene, scene.patches[j], patch);
  }
}

/// An incompressible gas that is blown in must get out.
void check_outlet(const RealScene& scene, const Document& document) {
  double largest = 0;   // [m^3/s]
  std::map<double, double> flows;   // [m^3/s] by ramp: what opens together must balance by itself, or the way there does not
  for (const Patch& patch : scene.patches) {
    if (patch.kind == PatchKind::pressure) return;
    double area = 1;
    for (const Axis axis : k_axes)
      if (axis != patch.face.axis) area *= patch.extent[index(axis)].high - patch.extent[index(axis)].low;
    for (const Patch& other : scene.patches) {
      if (!patch.rest || other.rest || !(other.face == patch.face)) continue;
      double taken = 1;
      for (const Axis axis : k_axes)
        if (axis != patch.face.axis) taken *= other.extent[index(axis)].high - other.extent[index(axis)].low;
      area -= taken;
    }
    flows[patch.ramp] += patch.velocity * area;
    largest = std::max(largest, std::abs(patch.velocity * area));
  }
  const auto balanced = [&](double volume) { return std::abs(volume) <= k_rounding * largest; };
  double flow = 0;
  for (const auto& [ramp, part] : flows) flow += part;
  if (balanced(flow)) {
    if (std::ranges::all_of(flows, [&](const auto& part) { return balanced(part.second); })) return;
    throw InputError(document.mark("scene.patches"), "scene.patches",
                     "what is blown in is drawn out again, but not while the patches open: their ramps differ.",
                     "Give them one ramp, or add an opening, for example outlet: {face: top, pressure: 0 Pa}.");
  }
  throw InputError(document.mark("scene.patches"), "scene.patches",
                   flow > 0 ? "gas is blown in, but there is no opening to let it out."
                            : "gas is drawn out, but there is no opening to let it in.",
                   "Add for example outlet: {face: top, pressure: 0 Pa}.");
}

void check_baffles(const RealScene& scene) {
  for (const Baffle& baffle : scene.baffles) {
    const std::string group = "scene.baffles." + baffle.name.substr(0, baffle.name.find('.'));
    const double size = scene.size[index(baffle.normal)];
    if (!(baffle.position > 0 && baffle.position < size))
      throw InputError(
          baffle.extent_mark[index(baffle.normal)], group + ".at_" + letter(baffle.normal),
          in_mm(baffle.position) + " is not inside the domain, which goes from 0 mm to " + in_mm(size) + ".",
          "A plate stands between two walls.");
    check_inside(scene, baffle.extent, baffle.extent_mark, group, "the domain");
  }
}

void check_times(const RealScene& scene, const Document& document) {
  const TimeControl& time = scene.time;
  const auto too_long = [&](double step, const char* key) {
    const std::string path = std::string("time.") + key;
    if (step > time.end)
      throw InputError(
          document.mark(path), path,
          format_quantity(step, "s") + " is longer than the run of " + format_quantity(time.end, "s") + ".",
          "Write auto to have it chosen.");
  };
  if (time.dt) too_long(*time.dt, "dt");
  if (time.gas_dt) too_long(*time.gas_dt, "gas_dt");
  if (time.dt && time.gas_dt && *time.dt > *time.gas_dt)
    throw InputError(time.gas_dt_mark, "time.gas_dt",
                     format_quantity(*time.gas_dt, "s") + " is shorter than the particles' sub-step time.dt of " +
                         format_quantity(*time.dt, "s") + ".",
                     "A gas step is a whole number of sub-steps; write auto to have it chosen.");
}

void check_output(const RealScene& scene, const Document& document) {
  const ProfileOutput& profiles = scene.output.profiles;
  for (std::size_t i = 0; i < profiles.z.size(); ++i) {
    if (profiles.z[i] >= 0 && profiles.z[i] <= scene.size[2]) continue;
    throw InputError(
        document.mark("output.profiles.z." + std::to_string(i)), "output.profiles.z",
        in_mm(profiles.z[i]) + " is outside the domain, which goes from 0 mm to " + in_mm(scene.size[2]) + ".");
  }
  for (const Probe& probe : scene.output.probes) {
    const std::string path = "output.probes." + probe.name + ".at";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (probe.place[axis] >= 0 && probe.place[axis] <= scene.size[axis]) continue;
      throw InputError(document.mark(path), path,
                       std::string(1, "xyz"[axis]) + " = " + in_mm(probe.place[axis]) + " is outside the domain, which goes from 0 mm to " +
                           in_mm(scene.size[axis]) + ".");
    }
  }
  if (!profiles.z.empty() && profiles.from >= scene.time.end)
    throw InputError(document.mark("output.profiles.from"), "output.profiles.from",
                     "averaging starts at " + format_quantity(profiles.from, "s") + ", but the run ends at " +
                         format_quantity(scene.time.end, "s") + ".",
                     "Start earlier, or raise time.end.");
}

}  // namespace

void check_case(const RealScene& scene, const Document& document, std::vector<std::string>& warnings) {
  check_cells(scene, document);
  check_particles(scene, document);
  check_simulated_stiffness(scene, document);
  check_amount(scene, document, warnings);
  check_patches(scene);
  check_outlet(scene, document);
  check_baffles(scene);
  check_times(scene, document);
  check_output(scene, document);
}

}  // namespace similitude
