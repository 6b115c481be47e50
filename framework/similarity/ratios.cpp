#include "similarity/ratios.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <similitude/sphere.h>
#include <similitude/sphere_in_gas.h>

#include "scene/material_pairs.h"
#include "scene/messages.h"

namespace similitude {
namespace {

constexpr double k_same_volume = 1e-6;   // of the volume: ratios that were written by hand agree so far

double cube(double x) { return x * x * x; }

// ------------------------------------------------------------------------------------------------- what the bed is

double bottom_area(const Patch& patch) {
  return (patch.extent[0].high - patch.extent[0].low) * (patch.extent[1].high - patch.extent[1].low);
}

struct BottomFlow {
  double mean = 0, largest = 0;  // [m/s]
};

template <class Bed>
BottomFlow bottom_flow(const Scene<Bed>& scene) {
  const Face bottom{Axis::z, Side::low};
  const double whole = scene.size[0] * scene.size[1];
  double covered = 0;
  for (const Patch& patch : scene.patches)
    if (patch.face == bottom && !patch.rest) covered += bottom_area(patch);
  BottomFlow flow;
  double volume = 0;  // [m^3/s]
  for (const Patch& patch : scene.patches) {
    if (patch.kind != PatchKind::velocity) continue;
    flow.largest = std::max(flow.largest, std::abs(patch.velocity));
    if (patch.face == bottom) volume += patch.velocity * (patch.rest ? whole - covered : bottom_area(patch));
  }
  flow.mean = volume / whole;
  return flow;
}

/// [1/s], see similitude_bed.
template <class Bed>
double largest_shear_rate(const Scene<Bed>& scene, double mean_flow) {
  double rate = std::abs(mean_flow) / (std::min(scene.size[0], scene.size[1]) / 2);
  for (const Patch& patch : scene.patches) {
    if (patch.kind != PatchKind::velocity || patch.rest) continue;
    double narrower = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == static_cast<std::size_t>(patch.face.axis)) continue;
      narrower = std::min(narrower, patch.extent[axis].high - patch.extent[axis].low);
    }
    rate = std::max(rate, std::abs(patch.velocity) / (narrower / 2));
  }
  return rate;
}

/// How many particles the case gives, or the file of its bed.
template <class Bed>
double particle_count(const Scene<Bed>& scene) {
  double count = 0;
  for (const ParticleClass& species : scene.particles) count += species.known_count();
  return count;
}

template <class Bed>
double solids_volume(const Scene<Bed>& scene) {
  double volume = 0;
  for (const ParticleClass& species : scene.particles) volume += species.spheres_alike() * sphere_volume(species.diameter);
  return volume;
}

template <class Bed>
similitude_bed described(const Scene<Bed>& scene, std::size_t seen_by) {
  similitude_bed bed{};
  bed.struct_size = sizeof bed;
  bed.dimension = 3;
  const auto& g = scene.gravity;
  bed.gravity = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
  bed.gas_density = scene.gas_density;
  bed.gas_viscosity = scene.gas_viscosity;
  bed.bed_width = scene.size[0];
  bed.bed_depth = scene.size[1];
  const BottomFlow flow = bottom_flow(scene);
  bed.superficial_velocity = flow.mean;
  bed.largest_inlet_velocity = flow.largest;
  bed.largest_shear_rate = largest_shear_rate(scene, flow.mean);
  if (scene.particles.empty()) return bed;

  const ParticleClass& one = scene.particles.at(seen_by);
  bed.particle_diameter = one.diameter;
  bed.particle_density = one.density;
  bed.drag_diameter = one.drag_diameter;
  if (scene.bed.kind == FillKind::none) return bed;
  const double area = scene.size[0] * scene.size[1];
  if (scene.bed.height) {
    bed.bed_height = *scene.bed.height;
    bed.particle_count = std::round(bed.bed_height * area * k_settled_packing / sphere_volume(one.diameter));
  } else {
    bed.bed_height = solids_volume(scene) / (k_settled_packing * area);
    bed.particle_count = particle_count(scene);
  }
  return bed;
}

// -------------------------------------------------------------------------------------------------------- scaling

void check_ratios(const RealScene& real, const similitude_ratios& ratios) {
  const std::pair<const char*, double> all[] = {{"length", ratios.length},
                                                {"diameter", ratios.diameter},
                                                {"drag_diameter", ratios.drag_diameter},
                                                {"particle_density", ratios.particle_density},
                                                {"gas_density", ratios.gas_density},
                                                {"gas_viscosity", ratios.gas_viscosity},
                                                {"velocity", ratios.velocity},
                                                {"time", ratios.time},
                                                {"stiffness", ratios.stiffness},
                                                {"modulus", ratios.modulus},
                                                {"energy_loss", ratios.energy_loss},
                                                {"parcel_weight", ratios.parcel_weight}};
  const ModelChoice& law = real.models.scaling;
  for (const auto& [name, value] : all)
    if (!(value > 0) || !std::isfinite(value))
      throw InputError(
          law.mark, "models.scaling",
          law.id + " gives the ratio of " + name + " as " + std::to_string(value) + ", which is not above zero.",
          "Check its parameters against the bed.");
}

/// Mass times acceleration of what touches: with it a contact force keeps its ratio to the grain's weight and inertia.
double force_on_a_grain(const similitude_ratios& ratios) {
  return ratios.particle_density * cube(ratios.diameter) * ratios.velocity / ratios.time;
}

double ratio_of(int scales_as, const similitude_ratios& ratios) {
  switch (scales_as) {
    case SIMILITUDE_SCALES_AS_LENGTH:
      return ratios.length;
    case SIMILITUDE_SCALES_AS_DIAMETER:
      return ratios.diameter;
    case SIMILITUDE_SCALES_AS_TIME:
      return ratios.time;
    case SIMILITUDE_SCALES_AS_VELOCITY:
      return ratios.velocity;
    case SIMILITUDE_SCALES_AS_STIFFNESS:
      return ratios.stiffness;
    case SIMILITUDE_SCALES_AS_MODULUS:
      return ratios.modulus;
    case SIMILITUDE_SCALES_AS_FORCE:
      return force_on_a_grain(ratios);
    case SIMILITUDE_SCALES_AS_SURFACE_ENERGY:
      return force_on_a_grain(ratios) / ratios.diameter;
    case SIMILITUDE_SCALES_AS_ENERGY:
      return force_on_a_grain(ratios) * ratios.diameter;
    case SIMILITUDE_SCALES_AS_DIFFUSIVITY:
      return ratios.drag_diameter * ratios.drag_diameter / ratios.time;   // the gas meets the particle, not what touches
    case SIMILITUDE_SCALES_AS_RATE:
      return 1 / ratios.time;
    default:
      return 1;
  }
}

/// 1 - e_c^2 = l (1 - e^2) with l the ratio of energy_loss; NaN where a grain would have to lose more than it has.
double scaled_restitution(double restitution, double energy_loss) {
  if (energy_loss == 1) return restitution;   // to the last bit
  const double left = 1 - energy_loss * (1 - restitution * restitution);
  return left > 0 ? std::sqrt(left) : std::numeric_limits<double>::quiet_NaN();
}

bool is_restitution(const ModelParameter& parameter) {
  return parameter.scales_as == SIMILITUDE_SCALES_AS_RESTITUTION && !std::isnan(parameter.real);
}

/// A law may change what a collision loses; the contact model must have a restitution, and it must be able to lose so much.
void check_energy_loss(const RealScene& real, const similitude_ratios& ratios) {
  if (ratios.energy_loss == 1) return;
  const ModelChoice& law = real.models.scaling;
  bool found = false;
  for (const ModelChoice& contact : contact_sets(real.models)) {
    for (const ModelParameter& parameter : contact.parameters) {
      if (!is_restitution(parameter)) continue;
      found = true;
      if (!std::isnan(scaled_restitution(parameter.real, ratios.energy_loss))) continue;
      const double limit = 1 / (1 - parameter.real * parameter.real);
      throw InputError(law.mark, "models.scaling",
                       fmt::format("{} wants grains to lose {:.4g} times as much energy per collision, but with {}: {:.4g} nothing "
                                   "is left beyond {:.4g} times.",
                                   law.id, ratios.energy_loss, parameter.name, parameter.real, limit),
                       fmt::format("Choose grains of less than {:.4g} diameters, or leave the restitution as it is.", limit));
    }
  }
  if (!found)
    throw InputError(law.mark, "models.scaling",
                     law.id + " wants 1 - e^2 of the restitution e changed, but the contact model " + real.models.contact.id +
                         " declares none.",
                     "Choose a contact model that scales a parameter as_restitution, or parameters of " + law.id +
                         " that leave restitution alone.");
}

void scale_model(ModelChoice& model, const similitude_ratios& ratios,
                 const std::optional<double>& simulated_stiffness) {
  for (ModelParameter& parameter : model.parameters) {
    if (parameter.scales_as == SIMILITUDE_SCALES_AS_RESTITUTION) {
      parameter.real = scaled_restitution(parameter.real, ratios.energy_loss);
      continue;
    }
    if (parameter.scales_as == SIMILITUDE_SCALES_AS_STIFFNESS && simulated_stiffness && !std::isnan(parameter.real)) {
      parameter.real = *simulated_stiffness;
    } else {
      parameter.real *= ratio_of(parameter.scales_as, ratios);  // what was not given is NaN and stays so
    }
  }
}

void scale(Interval& interval, double ratio) {
  interval.low *= ratio;
  interval.high *= ratio;
}

template <class T>
void scale(std::optional<T>& value, double ratio) {
  if (value) *value *= ratio;
}

void scale_particles(ParticleClass& species, const similitude_ratios& ratios) {
  species.diameter *= ratios.diameter;
  species.drag_diameter *= ratios.drag_diameter;
  species.material_diameter *= ratios.length;  // so that results divided by r show the real particle
  species.density *= ratios.particle_density;
  species.weight *= ratios.parcel_weight;
  if (species.count) {
    // The same bed shape at the same packing: N* = (r/n)^3.
    const double wanted = static_cast<double>(*species.count) * cube(ratios.length / ratios.diameter);
    species.count = std::max<std::int64_t>(1, std::llround(wanted));
  }
}

bool is_identity(const similitude_ratios& r) {
  for (const double ratio : {r.length, r.diameter, r.drag_diameter, r.particle_density, r.gas_density, r.gas_viscosity, r.velocity, r.time,
                             r.stiffness, r.modulus, r.energy_loss, r.parcel_weight})
    if (ratio != 1) return false;
  return true;
}

/// An effect may know no way to scale; then a scaled run with it would be neither bed.
void check_effects_scale(const RealScene& real, const similitude_ratios& ratios) {
  if (is_identity(ratios)) return;
  for (const ModelChoice& effect : real.models.effects) {
    for (const ModelParameter& parameter : effect.parameters) {
      if (parameter.scales_as != SIMILITUDE_SCALES_REFUSED) continue;
      throw InputError(effect.mark, "models.effects",
                       fmt::format("{} does not say how its {} scales, and models.scaling is {}.", effect.id, parameter.name,
                                   real.models.scaling.id),
                       fmt::format("Set models.scaling: exact, or leave {} out of models.effects.", effect.id));
    }
  }
}

template <class From, class To>
Scene<To> retyped(const Scene<From>& scene) {
  Scene<To> other;
  other.title = scene.title;
  other.name = scene.name;
  other.folder = scene.folder;
  other.size = scene.size;
  other.cell = scene.cell;
  other.periodic = scene.periodic;
  other.gravity = scene.gravity;
  other.walls = scene.walls;
  other.gas_density = scene.gas_density;
  other.gas_viscosity = scene.gas_viscosity;
  other.gas_values = scene.gas_values;
  other.wall_values = scene.wall_values;
  other.particles = scene.particles;
  other.bed = scene.bed;
  other.patches = scene.patches;
  other.baffles = scene.baffles;
  other.smoothing_length = scene.smoothing_length;
  other.models = scene.models;
  other.time = scene.time;
  other.output = scene.output;
  return other;
}

}  // namespace

similitude_ratios identity_ratios() {
  similitude_ratios ratios{};
  ratios.struct_size = sizeof ratios;
  ratios.length = ratios.diameter = ratios.drag_diameter = 1;
  ratios.particle_density = ratios.gas_density = ratios.gas_viscosity = 1;
  ratios.velocity = ratios.time = 1;
  ratios.stiffness = ratios.modulus = ratios.energy_loss = 1;
  ratios.parcel_weight = 1;
  return ratios;
}

std::vector<std::string> scaling_warnings(const RealScene& real, const similitude_ratios& ratios) {
  std::vector<std::string> warnings;
  const double seen = ratios.parcel_weight * cube(ratios.drag_diameter / ratios.diameter);
  if (std::abs(seen - 1) > k_same_volume)
    warnings.push_back(fmt::format("models.scaling: with {} the gas sees {:.4g} times the volume of particles that moves (parcel_weight "
                                   "drag_diameter^3 / diameter^3).",
                                   real.models.scaling.id, seen));
  if (ratios.energy_loss == 1) return warnings;
  for (const ModelParameter& parameter : real.models.contact.parameters) {
    if (!is_restitution(parameter)) continue;
    const double lost = ratios.energy_loss * (1 - parameter.real * parameter.real);
    if (lost <= k_energy_loss_near_limit) continue;
    warnings.push_back(fmt::format("models.scaling: {} takes {} from {:.4g} to {:.4g}: {:.0f} % of a collision's energy is lost, and "
                                   "beyond {:.4g} times the real loss nothing would be left.",
                                   real.models.scaling.id, parameter.name, parameter.real,
                                   scaled_restitution(parameter.real, ratios.energy_loss), 100 * lost,
                                   1 / (1 - parameter.real * parameter.real)));
  }
  return warnings;
}

similitude_bed describe(const RealScene& scene, std::size_t species) { return described(scene, species); }
similitude_bed describe(const ModelScene& scene) { return described(scene, 0); }

ModelScene simulated_bed(const RealScene& real, const similitude_ratios& ratios) {
  check_ratios(real, ratios);
  check_energy_loss(real, ratios);
  check_effects_scale(real, ratios);
  const ResultRatios results = result_ratios(real, ratios);
  ModelScene bed = retyped<RealBed, ModelBed>(real);
  for (double& size : bed.size) size *= ratios.length;
  for (double& cell : bed.cell) cell *= ratios.length;
  bed.gas_density *= ratios.gas_density;
  bed.gas_viscosity *= ratios.gas_viscosity;
  for (ParticleClass& species : bed.particles) scale_particles(species, ratios);
  const auto scale_values = [&](GivenValues& values) {
    for (GivenValue& given : values) given.value *= ratio_of(given.scales_as, ratios);
  };
  scale_values(bed.gas_values);
  scale_values(bed.wall_values);
  for (ParticleClass& species : bed.particles) scale_values(species.values);
  for (Patch& patch : bed.patches) scale_values(patch.values);
  scale(bed.bed.height, ratios.length);
  for (Patch& patch : bed.patches) {
    for (Interval& extent : patch.extent) scale(extent, ratios.length);
    patch.velocity *= ratios.velocity;
    patch.ramp *= ratios.time;
    patch.pressure *= results.pressure;
  }
  for (Baffle& baffle : bed.baffles) {
    baffle.position *= ratios.length;
    for (Interval& extent : baffle.extent) scale(extent, ratios.length);
    baffle.thickness *= ratios.length;
  }
  scale(bed.smoothing_length, ratios.length);

  const std::optional<double>& stiffness = bed.models.simulated_stiffness;
  for (ModelChoice* model : {&bed.models.drag, &bed.models.contact, &bed.models.fluid})
    scale_model(*model, ratios, stiffness);
  for (ModelChoice& pair : bed.models.contact_pairs) scale_model(pair, ratios, stiffness);
  for (ModelChoice& effect : bed.models.effects) scale_model(effect, ratios, stiffness);

  bed.time.end *= ratios.time;
  scale(bed.time.dt, ratios.time);
  scale(bed.time.gas_dt, ratios.time);
  bed.output.vtk_every *= ratios.time;
  bed.output.monitor_every *= ratios.time;
  bed.output.profiles.from *= ratios.time;
  for (double& z : bed.output.profiles.z) z *= ratios.length;
  for (Probe& probe : bed.output.probes) {
    for (double& x : probe.place) x *= ratios.length;
  }
  return bed;
}

ResultRatios result_ratios(const RealScene& real, const similitude_ratios& ratios) {
  ResultRatios results;
  results.length = ratios.length;
  results.time = ratios.time;
  results.velocity = ratios.velocity;
  results.angular_velocity = 1 / ratios.time;
  results.diameter = ratios.diameter;
  results.mass = ratios.particle_density * cube(ratios.length);
  if (real.particles.empty()) {
    results.pressure = ratios.gas_density * (ratios.velocity * ratios.velocity);
    results.force = results.pressure * (ratios.length * ratios.length);
    return results;
  }
  const double solid = real.particles.front().density, gas = real.gas_density;
  const double weight =
      (ratios.particle_density * solid - ratios.gas_density * gas) / (solid - gas);  // (rho_p - rho_f)*
  results.pressure = weight * ratios.length;
  results.force = weight * cube(ratios.diameter) / ratios.parcel_weight;
  return results;
}

}  // namespace similitude
