#include "stepper/inspection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "particles/contact_effects.h"
#include "particles/contact_lists.h"
#include "particles/engine.h"
#include "scene/material_pairs.h"
#include "scene/units.h"
#include "stepper/bed.h"
#include "stepper/bed_numbers.h"
#include "stepper/checkpoints.h"
#include "stepper/effect_price.h"
#include "stepper/simulation.h"

namespace similitude {
namespace {

// Of a settled bed, measured (tests/performance/dem_bench, docs/performance.md).
constexpr double k_candidates_per_particle = 3.75;   // pairs listed with their skin, walls included
constexpr double k_crossings_per_particle = 0.25;    // those of them between two bricks
constexpr double k_contacts_per_particle = 2.2;      // that touch

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

std::size_t whole(double bytes) { return static_cast<std::size_t>(std::llround(bytes)); }

/// Lists, the memory of contacts, and what holds both while lists are built: as engines take it.
void add_pair_fields(const Assembly& assembly, std::size_t particles, std::vector<FieldUse>& fields) {
  const auto items = [&](double per_particle) { return whole(per_particle * static_cast<double>(particles)); };
  const std::size_t candidates = items(k_candidates_per_particle);
  const std::string contact = std::string("contact.") + assembly.contact.descriptor().id;
  std::uint32_t values = 0;
  std::vector<FieldUse> history;
  const auto remember = [&](const auto& needs, const std::string& because) {
    for (std::uint32_t slot = 0; slot < needs.history_count; ++slot, ++values) {
      history.push_back({std::string("pair.") + needs.history_name[slot], whole(ContactLists::k_room * sizeof(double)), candidates, because});
    }
  };
  remember(assembly.contact_needs, contact);
  for (const EffectModel& effect : assembly.effects) remember(needs_of(effect), std::string("effect.") + effect.descriptor().id);

  const bool periodic = std::ranges::any_of(assembly.model.periodic, [](bool repeats) { return repeats; });
  const EngineMemory memory = engine_memory(values, assembly.rotation(), periodic);
  fields.push_back({"particle.listed_position_order", whole(memory.lists_per_particle), particles, "neighbours"});
  fields.push_back({"pair.list", whole(memory.lists_per_candidate), candidates, "neighbours"});
  fields.push_back({"pair.share_across_bricks", whole(memory.lists_per_crossing), items(k_crossings_per_particle), contact});
  const double unused = memory.history_per_candidate - ContactLists::k_room * sizeof(double) * values;
  fields.insert(fields.end(), history.begin(), history.end());
  if (unused > 0) fields.push_back({"pair.history_filled_up", whole(unused), candidates, "rows of four values"});
  if (values > 0) fields.push_back({"contact.carried_history", whole(memory.history_per_contact), items(k_contacts_per_particle), "rebuilt neighbours"});
}

/// Is it made anew in every gas step, and so in no copy of the state?
bool made_anew(const FieldUse& cells) {
  return cells.name.ends_with("_exchange") || cells.name == "cell.vorticity" || cells.name == "cell.acceleration" ||
         cells.name == "cell.velocity_before";
}

/// The two copies of the state that a run keeps; what a solver remembers beyond its fields is in none of these rows.
void add_snapshots(const Assembly& assembly, std::size_t particles, std::size_t cells, std::vector<FieldUse>& fields) {
  ParticleStore one(store_fields(assembly));
  one.fields.added_mass = false;
  one.add(0, 0, 0, 0, 0, 1, 1);
  std::size_t in_contacts = 0, in_cells = 0;
  for (const FieldUse& field : fields) {
    if (field.name.starts_with("cell.") && !made_anew(field)) in_cells += field.bytes_per_item;
    if (field.name == "contact.carried_history") in_contacts = field.bytes_per_item + 2 * sizeof(std::uint32_t);   // place and owner
  }
  const std::size_t scalars = assembly.scalars.particles.size() * sizeof(double);
  const char* because = "to go back to, and for checkpoints";
  fields.push_back({"particle.snapshots", Snapshots::k_copies * (one.bytes_per_particle() + scalars + sizeof(Row)), particles, because});
  if (in_contacts > 0) {
    fields.push_back({"contact.snapshots", Snapshots::k_copies * in_contacts, whole(k_contacts_per_particle * static_cast<double>(particles)), because});
  }
  fields.push_back({"cell.snapshots", Snapshots::k_copies * in_cells, cells, because});
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
  };
  if (assembly.rotation()) {
    const std::string turns = assembly.contact_needs.rotation != 0 ? contact + " needs rotation" : reader(assembly, SIMILITUDE_READS_ANGULAR_VELOCITY);
    fields.push_back({"particle.angular_velocity_inertia", sizeof(Row), particles, turns});
    fields.push_back({"particle.torque", sizeof(Row), particles, turns});
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
  add_pair_fields(assembly, particles, fields);
  add_snapshots(assembly, particles, cells, fields);
  return fields;
}

std::vector<std::string> warnings_of(const Assembly& assembly, const TimeSteps& steps, const Catalogue& catalogue) {
  std::vector<std::string> all;
  for (const std::vector<std::string>& some :
       {assembly.warnings, steps.warnings, bed_warnings(assembly), idle_value_warnings(assembly.real, catalogue)}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

double bytes_per_particle(const std::vector<FieldUse>& fields, const Assembly& assembly) {
  double bytes = 0;
  for (const FieldUse& field : fields) {
    if (!field.name.starts_with("cell.")) bytes += static_cast<double>(field.bytes_per_item) * static_cast<double>(field.items);
  }
  return bytes / static_cast<double>(std::max<std::int64_t>(expected_particles(assembly.model), 1));
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
