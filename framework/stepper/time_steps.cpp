#include "stepper/time_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "particles/impacts.h"
#include "scene/messages.h"

namespace similitude {
namespace {

constexpr double k_steps_per_contact = 20;     // DEM: t_c/20, as Fluent and MFIX advise between 15 and 50
constexpr double k_share_of_stable = 0.5;      // heavily damped contacts: t_c/20 may lie beyond what is stable
constexpr double k_advised_courant = 0.5;      // the TVD advection's own bound
constexpr double k_jet_overshoot = 2;          // interstitial over superficial speed where a jet meets a packed bed
constexpr double k_motion_per_step = 0.1;      // of a diameter per sub-step, of a cell per gas step: lists and K stay valid
constexpr double k_never = std::numeric_limits<double>::infinity();

double smallest_spacing(const ModelScene& scene) { return *std::min_element(scene.cell.begin(), scene.cell.end()); }

/// The speed a particle gains by falling through the domain: what an impact in a bed can reach without the gas.
double free_fall_speed(const ModelScene& scene) {
  const double gravity = std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
  return std::sqrt(2 * gravity * scene.size[2]);
}

double largest_inlet_velocity(const ModelScene& scene) {
  double speed = 0;
  for (const auto& patch : scene.patches) {
    if (patch.kind == PatchKind::velocity) speed = std::max(speed, std::abs(patch.velocity));
  }
  return speed;
}

/// Bernoulli's: what the gas gains between the patches of the highest and of the lowest pressure with nothing in its way.
double speed_between_pressures(const ModelScene& scene) {
  double highest = 0, lowest = 0;   // [Pa]
  bool found = false;
  for (const auto& patch : scene.patches) {
    if (patch.kind != PatchKind::pressure) continue;
    highest = found ? std::max(highest, patch.pressure) : patch.pressure;
    lowest = found ? std::min(lowest, patch.pressure) : patch.pressure;
    found = true;
  }
  return std::sqrt(2 * (highest - lowest) / scene.gas_density);
}

bool has_walls(const ModelScene& scene) {
  return !scene.baffles.empty() || std::ranges::any_of(scene.periodic, [](bool repeats) { return !repeats; });
}

/// Of the lightest particle of each class: a row of a bed's file may be smaller than its class.
std::vector<Impact> impacts_of(const Assembly& assembly) {
  const ModelScene& scene = assembly.model;
  std::vector<Sphere> classes;
  for (const auto& particles : scene.particles) {
    // sphere_mass() but for the last bit: this order of the factors is in every dt, and so in every state that was ever hashed.
    const double mass = particles.density * std::numbers::pi / 6 * particles.diameter * particles.diameter * particles.diameter;
    const FileRows rows = particles.rows.value_or(FileRows{});
    classes.push_back({mass * rows.least_mass, particles.diameter / 2 * rows.diameter_of_lightest});
  }
  std::vector<Impact> impacts = possible_impacts(classes, assembly.contact);
  if (!has_walls(scene)) std::erase_if(impacts, [&](const Impact& impact) { return impact.materials.second == classes.size(); });
  return impacts;
}

TimeStepLimit contact_limit(const Assembly& assembly) {
  TimeStepLimit limit{"contact time", "", StepKind::particles, k_never, k_never, false};
  const double speed = free_fall_speed(assembly.model);
  MaterialPair quickest, least_stable;
  for (const Impact& impact : impacts_of(assembly)) {
    const double advised = impact.contact_time(assembly.contact, speed) / k_steps_per_contact;
    const double hard = impact.largest_stable_step(assembly.contact, speed);
    if (advised < limit.advised) limit.advised = advised, quickest = impact.materials;
    if (hard < limit.hard) limit.hard = hard, least_stable = impact.materials;
  }
  const auto& classes = assembly.model.particles;
  const bool one_pair = classes.size() == 1 && assembly.contact.sets() == 1;
  limit.hard_because = fmt::format("stability of the integrator in a packed bed, (sqrt(1 + 4 zeta^2) - 2 zeta)/omega_0 of {}",
                                   one_pair ? "the lightest pair" : pair_name(classes, least_stable));
  if (limit.advised > k_share_of_stable * limit.hard) {
    limit.advised = k_share_of_stable * limit.hard;
    limit.because = "half of what is stable in a packed bed with contacts damped so heavily";
    return limit;
  }
  if (one_pair) {
    limit.because = fmt::format("{} steps per contact of the lightest pair", k_steps_per_contact);
    return limit;
  }
  limit.because = fmt::format("{} steps per contact of the quickest pair, {}", k_steps_per_contact, pair_name(classes, quickest));
  return limit;
}

/// Of effects whose contact pass is explicit and stiff.
void effect_limits(const Assembly& assembly, std::vector<TimeStepLimit>& limits) {
  constexpr double k_advised_share = 0.5;   // of the hard limit, as for the gas's explicit viscosity
  const double speed = free_fall_speed(assembly.model);
  for (const EffectModel& effect : assembly.effects) {
    if (!effect.functions().contacts) continue;
    double hard = k_never;
    for (const Impact& impact : impacts_of(assembly)) {
      hard = std::min(hard, largest_stable_step_of(effect, {0, impact.effective_mass, impact.effective_radius, speed}));
    }
    if (!std::isfinite(hard)) continue;
    limits.push_back({std::string("effect: ") + effect.descriptor().id, "half of what is stable in its contact pass",
                      StepKind::particles, k_advised_share * hard, hard, false, "stability of its explicit contact pass, as the effect says"});
  }
}

std::vector<TimeStepLimit> all_limits(const Assembly& assembly) {
  const ModelScene& scene = assembly.model;
  std::vector<TimeStepLimit> limits;
  if (!scene.particles.empty()) {
    limits.push_back(contact_limit(assembly));
    effect_limits(assembly, limits);
    double diameter = k_never;
    for (const auto& particles : scene.particles) {
      diameter = std::min(diameter, particles.diameter * particles.rows.value_or(FileRows{}).least_diameter);
    }
    const double speed = free_fall_speed(scene);
    if (speed > 0) {
      limits.push_back({"particle motion", "a tenth of a diameter per sub-step at free-fall speed", StepKind::particles,
                        k_motion_per_step * diameter / speed, k_never, false});
      limits.push_back({"particle motion across cells", "a tenth of a cell per gas step at free-fall speed", StepKind::gas,
                        k_motion_per_step * smallest_spacing(scene) / speed, k_never, false});
    }
  }
  const double inlet = largest_inlet_velocity(scene);
  if (assembly.coupled() && assembly.fluid_needs.any_courant_number == 0 && inlet > 0) {
    limits.push_back({"gas CFL", fmt::format("Courant number {} at {} times the fastest inlet", k_advised_courant, k_jet_overshoot),
                      StepKind::gas, k_advised_courant * smallest_spacing(scene) / (k_jet_overshoot * inlet),
                      smallest_spacing(scene) / inlet, false, "Courant number 1 at the fastest inlet's own speed"});
  }
  const double driven = speed_between_pressures(scene);
  if (assembly.coupled() && assembly.fluid_needs.any_courant_number == 0 && driven > 0) {
    limits.push_back({"gas CFL between pressures", fmt::format("Courant number {} at the speed that the pressures of patches give free gas", k_advised_courant),
                      StepKind::gas, k_advised_courant * smallest_spacing(scene) / driven, k_never, false});
  }
  if (assembly.fluid.functions().largest_stable_step != nullptr) {
    const double stable = assembly.fluid.functions().largest_stable_step(assembly.fluid.instance(), &assembly.grid->table());
    if (std::isnan(stable)) {
      throw PluginError("fluid model \"" + std::string(assembly.fluid.descriptor().id) + "\": its largest stable step is not a number.",
                        "This is for the plugin's author to mend. If the solver threw, its words stand above.");
    }
    if (std::isfinite(stable) && stable > 0) {
      limits.push_back({"gas viscosity", "half of what is stable with an explicit viscous stress", StepKind::gas, stable / 2, stable, false,
                        "stability of the explicit viscous stress"});
    }
  }
  return limits;
}

/// The smallest advised limit that bounds a step of this kind; a gas step is never shorter than a sub-step, so gas limits
/// bound both.
TimeStepLimit* binding_limit(std::vector<TimeStepLimit>& limits, StepKind kind) {
  TimeStepLimit* smallest = nullptr;
  for (auto& limit : limits) {
    if (kind == StepKind::gas && limit.kind != StepKind::gas) continue;
    if (smallest == nullptr || limit.advised < smallest->advised) smallest = &limit;
  }
  return smallest;
}

void check_against_limits(double step, StepKind kind, const SourceMark& mark, const std::string& path,
                          const Assembly& assembly, TimeSteps& steps) {
  const double to_real = 1 / assembly.results.time;
  for (const auto& limit : steps.limits) {
    if (kind == StepKind::gas && limit.kind != StepKind::gas) continue;
    if (step > limit.hard) {
      throw InputError(mark, path,
                       fmt::format("{:.3g} s is beyond the hard limit of {:.3g} s ({}: {})", step * to_real,
                                   limit.hard * to_real, limit.name, limit.hard_because),
                       fmt::format("Set {}: auto, or at most {:.3g} s.", path, limit.advised * to_real));
    }
    if (step > limit.advised * (1 + 1e-9)) {
      steps.warnings.push_back(fmt::format("{}: {:.3g} s is above the advised {:.3g} s ({}: {})", path, step * to_real,
                                           limit.advised * to_real, limit.name, limit.because));
    }
  }
}

/// The gas step follows from the physics alone, so that neither the end nor an output changes a state; a step that is longer
/// than they are passes them by.
void warn_of_what_is_passed_by(const Assembly& assembly, TimeSteps& steps) {
  const ModelScene& scene = assembly.model;
  const double to_real = 1 / assembly.results.time;
  const double gas_dt = steps.gas_dt();
  const std::pair<const char*, double> asked[] = {
      {"time.end", scene.time.end}, {"output.monitors", scene.output.monitor_every}, {"output.vtk", scene.output.vtk_every}};
  std::string passed;
  double shortest = k_never;
  for (const auto& [key, interval] : asked) {
    if (!(interval > 0) || gas_dt <= interval * (1 + 1e-9)) continue;
    passed += fmt::format("{}{} ({:.3g} s)", passed.empty() ? "" : ", ", key, interval * to_real);
    shortest = std::min(shortest, interval);
  }
  if (passed.empty()) return;
  steps.warnings.push_back(fmt::format("time.gas_dt: the gas step of {:.3g} s is longer than {}; nothing is written within it, and the run ends "
                                       "after a whole one.\n  Set time.gas_dt: {:.3g} s.",
                                       gas_dt * to_real, passed, std::max(shortest, steps.dt) * to_real));
}

/// Steps are counted in whole numbers. What wants more of them than a double tells apart was not meant: an inlet of 1e308 m/s.
void refuse_endless(double step, const Assembly& assembly, const TimeSteps& steps) {
  constexpr double k_most = 0x1p53;
  const TimeControl& time = assembly.model.time;
  if (step > 0 && time.end / step < k_most) return;
  const double to_real = 1 / assembly.results.time;
  const auto least = std::ranges::min_element(steps.limits, {}, &TimeStepLimit::advised);
  const std::string reason = time.dt || least == steps.limits.end() ? std::string() : fmt::format(" ({}: {})", least->name, least->because);
  throw InputError(time.dt ? time.dt_mark : time.mark, "time.dt",
                   fmt::format("steps of {:.3g} s never come to the end at {:.6g} s{}", step * to_real, time.end * to_real, reason),
                   "A value of the case is far from what can be meant: is its unit right?");
}

}  // namespace

std::int64_t TimeSteps::gas_steps_until(double end) const {
  constexpr double k_rounding = 1e-12;   // relative
  return static_cast<std::int64_t>(std::ceil(end / gas_dt() * (1 - k_rounding)));
}

TimeSteps choose_time_steps(const Assembly& assembly) {
  TimeSteps steps;
  steps.limits = all_limits(assembly);
  const TimeControl& time = assembly.model.time;
  if (steps.limits.empty() && !time.dt) {
    throw InputError(time.mark, "time.dt", "there is nothing to take a time step from (no particles, inlets or viscosity)",
                     "Give time.dt, e.g. time.dt: 1e-5 s.");
  }

  if (time.dt) {
    steps.dt = *time.dt;
    check_against_limits(steps.dt, StepKind::particles, time.dt_mark, "time.dt", assembly, steps);
  } else {
    TimeStepLimit* binding = binding_limit(steps.limits, StepKind::particles);
    const auto unknown = [](const TimeStepLimit& limit) { return !std::isfinite(limit.advised); };
    if (std::any_of(steps.limits.begin(), steps.limits.end(), unknown)) {
      throw InputError(time.mark, "time.dt",
                       "contact times of this law depend on the impact speed, and without gravity none is known",
                       "Give time.dt, e.g. time.dt: 1e-7 s.");
    }
    binding->binding = true;
    steps.dt = binding->advised;
    if (time.gas_dt) steps.dt = std::min(steps.dt, *time.gas_dt);
  }

  refuse_endless(steps.dt, assembly, steps);

  double gas_dt = steps.dt;
  if (time.gas_dt) {
    gas_dt = *time.gas_dt;
    check_against_limits(gas_dt, StepKind::gas, time.gas_dt_mark, "time.gas_dt", assembly, steps);
  } else if (TimeStepLimit* binding = binding_limit(steps.limits, StepKind::gas)) {
    binding->binding = true;
    gas_dt = binding->advised;
  }
  // Whole number of sub-steps: rounded down, so that the gas step never exceeds what was chosen.
  steps.sub_steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::floor(gas_dt / steps.dt * (1 + 1e-9))));
  warn_of_what_is_passed_by(assembly, steps);
  return steps;
}

}  // namespace similitude
