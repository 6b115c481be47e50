#include "similarity/audit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "similarity/groups.h"
#include "similarity/ratios.h"

namespace similitude {
namespace {

// ------------------------------------------------------------------------------------------------------ what is there

/// The narrowest side of an inlet beside which the face goes on.
template <class Bed>
double narrowest_slot(const Scene<Bed>& scene) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (const Patch& patch : scene.patches) {
    if (patch.kind != PatchKind::velocity || patch.rest) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double side = patch.extent[axis].high - patch.extent[axis].low;
      if (axis == static_cast<std::size_t>(patch.face.axis) || side >= scene.size[axis] * (1 - 1e-9)) continue;
      narrowest = std::min(narrowest, side);
    }
  }
  return std::isfinite(narrowest) ? narrowest : 0;
}

/// Between neighbouring upright plates, and between them and the walls.
template <class Bed>
double narrowest_gap(const Scene<Bed>& scene) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (const Axis axis : {Axis::x, Axis::y}) {
    const auto a = static_cast<std::size_t>(axis);
    std::vector<Interval> bodies;
    for (const Baffle& plate : scene.baffles)
      if (plate.normal == axis) bodies.push_back({plate.position - plate.thickness / 2, plate.position + plate.thickness / 2});
    if (bodies.empty()) continue;
    std::sort(bodies.begin(), bodies.end(), [](const Interval& one, const Interval& other) { return one.low < other.low; });
    double free_from = scene.periodic[a] ? bodies.front().low : 0;
    for (const Interval& body : bodies) {
      if (body.low > free_from) narrowest = std::min(narrowest, body.low - free_from);
      free_from = body.high;
    }
    if (!scene.periodic[a]) narrowest = std::min(narrowest, scene.size[a] - free_from);
  }
  return std::isfinite(narrowest) ? narrowest : 0;
}

template <class Bed>
double lowest_entrance(const Scene<Bed>& scene) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Baffle& plate : scene.baffles)
    if (plate.normal != Axis::z) lowest = std::min(lowest, plate.extent[2].low);
  return std::isfinite(lowest) ? lowest : 0;
}

template <class Bed>
double contact_pressure(const Scene<Bed>& scene) {
  for (const ModelParameter& parameter : scene.models.contact.parameters) {
    if (std::isnan(parameter.real) || scene.particles.empty()) continue;
    if (parameter.scales_as == SIMILITUDE_SCALES_AS_STIFFNESS) return parameter.real / scene.particles.front().diameter;
    if (parameter.scales_as == SIMILITUDE_SCALES_AS_MODULUS) return parameter.real;
  }
  return 0;
}

template <class Bed>
AuditedBed audited_bed(const Scene<Bed>& scene, SphereDrag drag) {
  AuditedBed bed;
  bed.bed = describe(scene);
  bed.drag = std::move(drag);
  bed.slot = narrowest_slot(scene);
  bed.plate_gap = narrowest_gap(scene);
  bed.entrance = lowest_entrance(scene);
  bed.depth = scene.periodic[1] ? 0 : scene.size[1];
  bed.cell = *std::min_element(scene.cell.begin(), scene.cell.end());
  bed.contact_pressure = contact_pressure(scene);
  return bed;
}

// ---------------------------------------------------------------------------------------------------------- groups

struct NamedGroup {
  const char* name;
  const char* meaning;
  double Groups::*value;
};

constexpr NamedGroup k_groups[] = {
    {"Fr", "inertia over gravity", &Groups::froude},
    {"Re", "gas inertia over viscosity at a particle", &Groups::reynolds},
    {"Ar", "particle weight over viscosity", &Groups::archimedes},
    {"u0/u_mf", "gas velocity over minimum fluidisation (Ergun)", &Groups::over_minimum},
    {"u0/u_t", "gas velocity over terminal velocity (Schiller-Naumann)", &Groups::over_terminal},
    {"u0/u_t (Newton)", "the same with C_D = 4/9", &Groups::over_terminal_newton},
    {"St", "particle response time over flow time", &Groups::stokes},
    {"rho_p/rho_f", "density ratio", &Groups::density_ratio},
    {"(rho_p-rho_f)/rho_f", "buoyant density ratio", &Groups::buoyant_density_ratio},
    {"L/d", "bed width in particles", &Groups::length_ratio},
    {"J", "jet momentum over bed weight", &Groups::jet},
};

GroupComparison comparison(const char* name, const char* meaning, double exact, double scaled) {
  GroupComparison group{name, meaning, exact, scaled, 1, true};
  if (exact != 0) group.ratio = scaled / exact;
  group.kept = std::abs(group.ratio - 1) <= k_kept_within;
  return group;
}

std::vector<GroupComparison> bed_groups(const similitude_bed& real, const similitude_bed& simulated, double gas_fraction) {
  const Groups exact = groups(real, gas_fraction), scaled = groups(simulated, gas_fraction);
  std::vector<GroupComparison> comparisons;
  for (const NamedGroup& group : k_groups)
    comparisons.push_back(comparison(group.name, group.meaning, exact.*group.value, scaled.*group.value));
  return comparisons;
}

/// Overlap over diameter under the bed's own weight, inverted: K / (rho_p g L d) or E / (rho_p g L).
double hardness(const AuditedBed& bed) {
  return bed.contact_pressure / (bed.bed.particle_density * bed.bed.gravity * bed.bed.bed_width);
}

// -------------------------------------------------------------------------------------------------------- warnings

constexpr double k_rounding = 1e-9;       // a count that was meant to lie on a threshold does not lie below it
constexpr double k_bridging = 8 * (1 - k_rounding);   // diameters; silos jam for good below five
constexpr double k_jamming = 5 * (1 - k_rounding);
constexpr double k_shallow = 5 * (1 - k_rounding);    // diameters between front and back
constexpr double k_strong_jet = 1.5;      // times the real jet's momentum over bed weight
constexpr double k_noticeable = 0.02;     // of u0/u_mf and u0/u_t: what drag laws differ by among themselves is more
constexpr double k_other_hardness = 2;    // times harder or softer

const GroupComparison* find(const std::vector<GroupComparison>& groups, const std::string& name) {
  for (const GroupComparison& group : groups)
    if (group.name == name) return &group;
  return nullptr;
}

void warn_of_opening(const char* what, double real, double simulated, std::vector<std::string>& warnings) {
  if (!(simulated > 0) || simulated >= k_bridging || real < k_bridging) return;
  warnings.push_back(fmt::format(
      "{} is {:.1f} particles wide (really {:.1f}): below {:.0f} they bridge it now and then (a rule of thumb){}.", what, simulated,
      real, k_bridging,
      simulated < k_jamming ? ", below 5 they may block it, as silos (Zuriguel et al. 2005, Phys. Rev. E 71, 051303)" : ""));
}

void warn_of_lost_velocity(const GroupComparison* group, const char* meaning, std::vector<std::string>& warnings) {
  if (group == nullptr || std::abs(group->ratio - 1) <= k_noticeable) return;
  warnings.push_back(fmt::format("{} is {:.3g} times the real bed's: {}.", group->name, group->ratio, meaning));
}

}  // namespace

AuditedBed audited(const RealScene& scene, SphereDrag drag) { return audited_bed(scene, std::move(drag)); }
AuditedBed audited(const ModelScene& scene, SphereDrag drag) { return audited_bed(scene, std::move(drag)); }

std::optional<double> given_gas_fraction_at_minimum(const RealScene& scene) {
  std::optional<double> from_velocity;
  for (const ModelChoice* model : {&scene.models.scaling, &scene.models.drag}) {
    for (const ModelParameter& parameter : model->parameters) {
      if (!parameter.given) continue;
      if (parameter.name == "gas_fraction_at_minimum_fluidization") return parameter.real;
      if (parameter.name == "minimum_fluidization_velocity" && !from_velocity)
        from_velocity = gas_fraction_ergun(sphere_in_gas(describe(scene)), parameter.real);
    }
  }
  return from_velocity;
}

double gas_fraction_at_minimum(const RealScene& scene) {
  return given_gas_fraction_at_minimum(scene).value_or(k_gas_fraction_at_minimum);
}

std::vector<GroupComparison> compare_groups(const similitude_bed& real, const similitude_bed& simulated) {
  return bed_groups(real, simulated, k_gas_fraction_at_minimum);
}

std::vector<GroupComparison> compare_groups(const AuditedBed& real, const AuditedBed& simulated, double gas_fraction) {
  std::vector<GroupComparison> all = bed_groups(real.bed, simulated.bed, gas_fraction);
  const auto add = [&all](const char* name, const char* meaning, double exact, double scaled) {
    if (exact != 0 || scaled != 0) all.push_back(comparison(name, meaning, exact, scaled));
  };
  if (real.drag && simulated.drag && real.bed.superficial_velocity > 0) {
    const SphereInGas exact = sphere_in_gas(real.bed), scaled = sphere_in_gas(simulated.bed);
    const double u = real.bed.superficial_velocity, v = simulated.bed.superficial_velocity;
    add("u0/u_mf (drag law)", "by the case's own drag law", u / minimum_fluidisation(exact, real.drag, gas_fraction),
        v / minimum_fluidisation(scaled, simulated.drag, gas_fraction));
    add("u0/u_t (drag law)", "by the case's own drag law", u / terminal_velocity(exact, real.drag),
        v / terminal_velocity(scaled, simulated.drag));
  }
  const double d = real.bed.particle_diameter, e = simulated.bed.particle_diameter;
  add("softness", "contact stiffness over bed weight", hardness(real), hardness(simulated));
  add("depth/d", "between front and back, in particles", real.depth / d, simulated.depth / e);
  add("slot/d", "narrowest inlet, in particles", real.slot / d, simulated.slot / e);
  add("gap/d", "narrowest gap beside a plate, in particles", real.plate_gap / d, simulated.plate_gap / e);
  add("entrance/d", "below the plates, in particles", real.entrance / d, simulated.entrance / e);
  add("cell/d", "gas cell, in particles", real.cell / d, simulated.cell / e);
  return all;
}

std::vector<std::string> group_legend(const AuditedBed& real, const std::vector<GroupComparison>& groups, double gas_fraction) {
  const similitude_bed& bed = real.bed;
  const SphereInGas sphere = sphere_in_gas(bed);
  std::vector<std::string> lines{
      fmt::format("u0 = {:.4g} m/s, mean superficial velocity; u_mf = {:.3g} m/s by Ergun; u_t = {:.3g} m/s by Schiller-Naumann, {:.3g} m/s by "
                  "Newton (C_D = 4/9)",
                  bed.superficial_velocity, minimum_fluidisation_ergun(sphere, gas_fraction), terminal_velocity(sphere, schiller_naumann),
                  terminal_velocity_newton(sphere)),
      fmt::format("L = {:.4g} mm, width; d = {:.4g} mm, particle", 1e3 * bed.bed_width, 1e3 * bed.particle_diameter)};
  const auto length = [&](const char* name, const char* meaning, double value) {
    if (value > 0) lines.back() += fmt::format("; {} = {:.4g} mm, {}", name, 1e3 * value, meaning);
  };
  length("depth", "from front to back", real.depth);
  length("slot", "narrowest side of an inlet", real.slot);
  length("gap", "narrowest, between plates or a plate and a wall", real.plate_gap);
  length("entrance", "below the lowest plate", real.entrance);
  length("cell", "smallest of the gas", real.cell);
  const auto define = [&](const char* name, const std::string& text) {
    if (find(groups, name) != nullptr) lines.push_back(std::string(name) + " = " + text);
  };
  define("Fr", "u0^2/(g L); Re = rho_f u0 d/mu; Ar = g rho_f (rho_p - rho_f) d^3/mu^2; St = rho_p d^2 u0/(18 mu L)");
  define("J", fmt::format("rho_f u_jet^2/((rho_p - rho_f) g L), jet momentum over bed weight; u_jet = {:.4g} m/s, the fastest inlet",
                          bed.largest_inlet_velocity));
  define("softness", "K/(rho_p g L d) of a spring K, or E/(rho_p g L) of a modulus E: contact stiffness over bed weight");
  return lines;
}

std::vector<std::string> audit_warnings(const AuditedBed& real, const AuditedBed& simulated,
                                        const std::vector<GroupComparison>& groups) {
  std::vector<std::string> warnings;
  const double d = real.bed.particle_diameter, e = simulated.bed.particle_diameter;
  warn_of_opening("the inlet", real.slot / d, simulated.slot / e, warnings);
  warn_of_opening("the gap beside a plate", real.plate_gap / d, simulated.plate_gap / e, warnings);
  warn_of_opening("the entrance below the plates", real.entrance / d, simulated.entrance / e, warnings);
  if (simulated.plate_gap > 0 && simulated.plate_gap / e < k_jamming && real.plate_gap / d >= k_jamming)
    warnings.push_back("a particle is larger than a fifth of the gap beside a plate.");
  if (simulated.depth > 0 && simulated.depth / e < k_shallow && real.depth / d >= k_shallow)
    warnings.push_back(fmt::format("the bed is {:.1f} particles deep (really {:.1f}): front and back wall carry part of it, and wall "
                                   "friction is not scaled (a rule of thumb asks for {:.0f}).",
                                   simulated.depth / e, real.depth / d, k_shallow));
  if (simulated.cell > 0 && simulated.cell < e && real.cell >= d)
    warnings.push_back(fmt::format("a particle of {:.2f} cells: the solids fraction rests on smoothing alone (volume averaging wants "
                                   "cells of some particles).",
                                   e / simulated.cell));
  const GroupComparison* jet = find(groups, "J");
  const bool blown_through_a_slot = real.bed.largest_inlet_velocity > 2 * real.bed.superficial_velocity;
  if (jet != nullptr && blown_through_a_slot && (jet->ratio > k_strong_jet || jet->ratio < 1 / k_strong_jet))
    warnings.push_back(fmt::format("the jet has {:.3g} times its momentum against the bed's weight: spout and fountain come out too {} "
                                   "(1.5 is a rule of thumb).",
                                   jet->ratio, jet->ratio > 1 ? "strong" : "weak"));
  warn_of_lost_velocity(find(groups, "u0/u_mf (drag law)"), "the bed is fluidized more or less than the real one", warnings);
  warn_of_lost_velocity(find(groups, "u0/u_t (drag law)"), "single particles, as in a fountain, fly otherwise than real ones",
                        warnings);
  const GroupComparison* softness = find(groups, "softness");
  if (softness != nullptr && (softness->ratio > k_other_hardness || softness->ratio < 1 / k_other_hardness))
    warnings.push_back(fmt::format("contacts are {:.3g} times as hard against the bed's weight as in the real bed.", softness->ratio));
  if (simulated.bed.particle_count > 1.001 * real.bed.particle_count)
    warnings.push_back(fmt::format("{:.3g} particles for {:.3g} real ones: more work, not less.", simulated.bed.particle_count,
                                   real.bed.particle_count));
  return warnings;
}

}  // namespace similitude
