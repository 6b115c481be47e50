#include "stepper/inspection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "particles/contact_effects.h"
#include "scene/material_pairs.h"
#include "scene/units.h"
#include "stepper/bed.h"
#include "stepper/effect_price.h"
#include "stepper/simulation.h"

namespace similitude {
namespace {

constexpr double k_pairs_per_particle = 4;           // listed in a half list with its skin, settled bed (measured 3.5 ... 4)

/// "effect.magnus_lift": the effects that want something, for the reason of a field.
template <class Wants>
std::string effects_that(const Assembly& assembly, Wants&& wants) {
  std::string names;
  for (const EffectModel& effect : assembly.effects) {
    if (wants(needs_of(effect))) names += (names.empty() ? "effect." : ", effect.") + std::string(effect.descriptor().id);
  }
  return names;
}
std::string reader(const Assembly& assembly, unsigned what) {
  return effects_that(assembly, [what](const similitude_effect_needs& needs) { return (needs.reads & what) != 0; });
}
std::string adder(const Assembly& assembly, unsigned what) {
  return effects_that(assembly, [what](const similitude_effect_needs& needs) { return (needs.adds & what) != 0; });
}

/// A contact parameter's value as a case would give it; empty if it is not given.
std::string written(const Assembly& assembly, const ModelChoice& set, std::size_t place) {
  const similitude_parameter& row = assembly.contact.descriptor().parameters[place];
  const ModelParameter& parameter = set.parameters[place];
  if (row.type == SIMILITUDE_CHOICE) return parameter.text;
  if (row.type == SIMILITUDE_FLAG) return parameter.real != 0 ? "true" : "false";
  if (std::isnan(parameter.real)) return "";
  return format_quantity(parameter.real, row.unit != nullptr && *row.unit != 0 ? row.unit : "1");
}

/// Fields of what effects carry, as allocated in every run that carries it.
void add_scalar_fields(const Assembly& assembly, std::size_t particles, std::vector<FieldUse>& fields) {
  const std::size_t cells = assembly.grid->cell_count();
  const auto who = [&](bool gas, std::size_t slot) {
    std::string names;
    for (const EffectQuantities& effect : assembly.scalars.effects) {
      for (std::size_t q = 0; q < effect.kind.size(); ++q) {
        if (effect.slot[q] != static_cast<int>(slot) || (effect.kind[q] == SIMILITUDE_GAS_SCALAR) != gas) continue;
        names += (names.empty() ? "effect." : ", effect.") + std::string(effect.effect->descriptor().id);
      }
    }
    return names;
  };
  for (std::size_t s = 0; s < assembly.scalars.particles.size(); ++s) {
    fields.push_back({"particle." + assembly.scalars.particles[s].name, sizeof(double), particles, who(false, s)});
  }
  for (std::size_t s = 0; s < assembly.scalars.gas.size(); ++s) {
    fields.push_back({"cell." + assembly.scalars.gas[s].name, sizeof(double), cells, who(true, s)});
    fields.push_back({"cell." + assembly.scalars.gas[s].name + "_exchange", 3 * sizeof(double), cells, who(true, s)});
    fields.push_back({"particle." + assembly.scalars.gas[s].name + "_exchange", 2 * sizeof(double), particles, who(true, s)});
  }
  if (!assembly.scalars.gas.empty()) fields.push_back({"cell.flux", 3 * sizeof(double), cells, "what the gas carries"});
  for (const EffectModel& effect : assembly.effects) {
    if (effect.functions().cells == nullptr) continue;
    fields.push_back({"cell.added_viscosity", sizeof(double), cells, std::string("effect.") + effect.descriptor().id});
    break;
  }
}

}  // namespace

std::int64_t expected_particles(const ModelScene& scene) {
  return static_cast<std::int64_t>(std::llround(describe(scene).particle_count));
}

std::vector<std::string> pipeline_words(const Assembly& assembly, const TimeSteps& steps) {
  return Simulation(assembly, steps, ParticleStore(store_fields(assembly)), [](const std::string&) {}).pipeline();
}

std::vector<FieldUse> field_uses(const Assembly& assembly) {
  const auto particles = static_cast<std::size_t>(expected_particles(assembly.model));
  const std::size_t cells = assembly.grid->cell_count();
  const auto pairs = static_cast<std::size_t>(k_pairs_per_particle * static_cast<double>(particles));
  const std::string contact = std::string("contact.") + assembly.contact.descriptor().id;
  const std::string fluid = std::string("fluid.") + assembly.fluid.descriptor().id;
  std::vector<FieldUse> fields{
      {"particle.position_radius", sizeof(Row), particles, "particles"},
      {"particle.velocity_mass", sizeof(Row), particles, "particles"},
      {"particle.force", sizeof(Row), particles, contact},
      {"particle.id_species", sizeof(std::uint64_t) + sizeof(std::uint32_t), particles, "particles"},
      {"particle.gas_velocity_exchange", sizeof(Row), particles, std::string("drag.") + assembly.drag.descriptor().id},
      {"particle.stress_force", sizeof(Row), particles, fluid},
      {"particle.drag_impulse", sizeof(Row), particles, "exchange of momentum with the gas"},
      {"pair.list", sizeof(std::uint32_t), pairs, "neighbours"},
  };
  if (assembly.rotation()) {
    const std::string turns = assembly.contact_needs.rotation != 0 ? contact + " needs rotation" : reader(assembly, SIMILITUDE_READS_ANGULAR_VELOCITY);
    fields.push_back({"particle.angular_velocity_inertia", sizeof(Row), particles, turns});
    fields.push_back({"particle.torque", sizeof(Row), particles, turns});
  }
  for (std::uint32_t slot = 0; slot < assembly.contact_needs.history_count; ++slot) {
    fields.push_back({std::string("pair.") + assembly.contact_needs.history_name[slot], sizeof(double), pairs, contact});
  }
  for (const EffectModel& effect : assembly.effects) {
    const std::string name = std::string("effect.") + effect.descriptor().id;
    const similitude_effect_needs needs = needs_of(effect);
    for (std::uint32_t slot = 0; slot < needs.history_count; ++slot) {
      fields.push_back({std::string("pair.") + needs.history_name[slot], sizeof(double), pairs, name});
    }
  }
  if (assembly.added_mass()) fields.push_back({"particle.added_mass", sizeof(double), particles, adder(assembly, SIMILITUDE_ADDS_ADDED_MASS)});
  if ((assembly.effect_reads & SIMILITUDE_READS_GAS_VORTICITY) != 0) {
    fields.push_back({"cell.vorticity", sizeof(Row), cells, reader(assembly, SIMILITUDE_READS_GAS_VORTICITY)});
  }
  if ((assembly.effect_reads & SIMILITUDE_READS_GAS_ACCELERATION) != 0) {
    const std::string name = reader(assembly, SIMILITUDE_READS_GAS_ACCELERATION);
    fields.push_back({"cell.acceleration", sizeof(Row), cells, name});
    fields.push_back({"cell.velocity_before", 3 * sizeof(double), cells, name});
  }
  fields.push_back({"cell.velocity", 3 * sizeof(double), cells, fluid});
  fields.push_back({"cell.pressure", sizeof(double), cells, fluid});
  fields.push_back({"cell.stress_force", 3 * sizeof(double), cells, fluid});
  if (assembly.coupled()) {
    fields.push_back({"cell.gas_fraction", 2 * sizeof(double), cells, "both ends of a gas step"});
    fields.push_back({"cell.exchange", 4 * sizeof(double), cells, "implicit drag"});
    fields.push_back({"cell.remainder", 3 * sizeof(double), cells, "exchange of momentum with the gas"});
  }
  add_scalar_fields(assembly, particles, fields);
  return fields;
}

std::vector<PairUse> pair_uses(const Assembly& assembly) {
  const RealScene& scene = assembly.real;
  const std::vector<ModelChoice>& sets = scene.models.contact_pairs;
  const std::vector<MaterialPair> pairs = material_pairs(scene.particles.size());
  std::vector<PairUse> uses;
  for (std::size_t p = 0; p < sets.size(); ++p) {
    uses.push_back({.pair = pair_name(scene.particles, pairs[p]), .parameters = {}});
    for (std::size_t k = 0; k < sets[p].parameters.size(); ++k) {
      const auto differs = [&](const ModelChoice& set) { return written(assembly, set, k) != written(assembly, sets[0], k); };
      if (std::ranges::any_of(sets, differs)) uses.back().parameters.emplace_back(sets[p].parameters[k].name, written(assembly, sets[p], k));
    }
  }
  return uses;
}

std::vector<EffectVerdict> effect_verdicts(const RealScene& scene, const Assembly& assembly, const TimeSteps& steps,
                                           const Catalogue& catalogue) {
  std::vector<EffectVerdict> verdicts = judge_effects(scene, catalogue, nullptr);
  for (EffectVerdict& verdict : verdicts) {
    verdict.chosen = std::ranges::any_of(assembly.effects, [&](const EffectModel& effect) { return effect.descriptor().id == verdict.id; });
    verdict.predicted_wall_s = std::numeric_limits<double>::quiet_NaN();
    if (assembly.model.particles.empty()) continue;
    try {
      verdict.predicted_wall_s = effect_price(scene, steps, catalogue, verdict.id);
    } catch (const std::exception&) {   // it cannot be used in this case as it stands, and then it has no price
    }
  }
  return verdicts;
}

}  // namespace similitude
