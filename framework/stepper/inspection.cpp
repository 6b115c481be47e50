#include "stepper/inspection.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/material_pairs.h"
#include "scene/units.h"
#include "stepper/bed.h"
#include "stepper/simulation.h"

namespace similitude {
namespace {

constexpr double k_pairs_per_particle = 4;           // listed in a half list with its skin, settled bed (measured 3.5 ... 4)

/// A contact parameter's value as a case would give it; empty if it is not given.
std::string written(const Assembly& assembly, const ModelChoice& set, std::size_t place) {
  const similitude_parameter& row = assembly.contact.descriptor().parameters[place];
  const ModelParameter& parameter = set.parameters[place];
  if (row.type == SIMILITUDE_CHOICE) return parameter.text;
  if (row.type == SIMILITUDE_FLAG) return parameter.real != 0 ? "true" : "false";
  if (std::isnan(parameter.real)) return "";
  return format_quantity(parameter.real, row.unit != nullptr && *row.unit != 0 ? row.unit : "1");
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
  if (assembly.contact_needs.rotation != 0) {
    fields.push_back({"particle.angular_velocity_inertia", sizeof(Row), particles, contact + " needs rotation"});
    fields.push_back({"particle.torque", sizeof(Row), particles, contact + " needs rotation"});
  }
  for (std::uint32_t slot = 0; slot < assembly.contact_needs.history_count; ++slot) {
    fields.push_back({std::string("pair.") + assembly.contact_needs.history_name[slot], sizeof(double), pairs, contact});
  }
  fields.push_back({"cell.velocity", 3 * sizeof(double), cells, fluid});
  fields.push_back({"cell.pressure", sizeof(double), cells, fluid});
  fields.push_back({"cell.stress_force", 3 * sizeof(double), cells, fluid});
  if (assembly.coupled()) {
    fields.push_back({"cell.gas_fraction", 2 * sizeof(double), cells, "both ends of a gas step"});
    fields.push_back({"cell.exchange", 4 * sizeof(double), cells, "implicit drag"});
    fields.push_back({"cell.remainder", 3 * sizeof(double), cells, "exchange of momentum with the gas"});
  }
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

std::vector<EffectVerdict> effect_verdicts(const Assembly& assembly, const Catalogue& catalogue) {
  std::vector<EffectVerdict> verdicts;
  const similitude_bed bed = describe(assembly.real);
  for (const std::string& id : catalogue.ids("effect")) {
    const PluginEntry& entry = *catalogue.find("effect", id);
    const similitude_relevance relevance = relevance_of(entry, bed);
    const std::string group = relevance.group != nullptr ? relevance.group : "";
    verdicts.push_back({.id = id,
                        .group = group,
                        .source = relevance.source != nullptr ? relevance.source : "",
                        .because = fmt::format("{} = {:.2g}, threshold {:.2g}", group, relevance.value, relevance.threshold),
                        .value = relevance.value,
                        .threshold = relevance.threshold,
                        .verdict = relevance.verdict});
  }
  return verdicts;
}

}  // namespace similitude
