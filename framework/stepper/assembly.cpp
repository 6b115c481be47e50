#include "stepper/assembly.h"

#include <fmt/format.h>

#include "scene/material_pairs.h"
#include "scene/messages.h"

namespace similitude {
namespace {

void append_values(std::vector<similitude_value>& values, const ModelChoice& choice) {
  for (const auto& parameter : choice.parameters) {
    values.push_back({parameter.real, parameter.text.empty() ? nullptr : parameter.text.c_str()});
  }
}

std::vector<similitude_value> values_of(const ModelChoice& choice) {
  std::vector<similitude_value> values;
  values.reserve(choice.parameters.size());
  append_values(values, choice);
  return values;
}

const PluginEntry& entry_of(const Catalogue& catalogue, const ModelChoice& choice) {
  const PluginEntry* entry = catalogue.find(choice.kind, choice.id);
  if (entry == nullptr) catalogue.throw_no_such_model(choice.kind, choice.id);
  return *entry;
}

template <class Functions>
Model<Functions> create(const Catalogue& catalogue, const ModelChoice& choice, const similitude_bed& bed,
                        std::vector<PluginEntry>& in_use) {
  const PluginEntry& entry = entry_of(catalogue, choice);
  in_use.push_back(entry);
  return create_model<Functions>(entry, bed, values_of(choice));
}

ContactModel create_contact(const PluginEntry& plugin, const ModelScene& scene) {
  const std::span<const ModelChoice> sets = contact_sets(scene.models);
  std::vector<similitude_value> values;
  for (const ModelChoice& set : sets) append_values(values, set);
  return create_model<similitude_contact_functions>(plugin, describe(scene), values, static_cast<std::uint32_t>(sets.size()));
}

/// Which pair of materials it is, a model cannot say itself.
void throw_if_a_pair_is_refused(const PluginEntry& plugin, const ModelScene& scene) {
  const std::vector<MaterialPair> pairs = material_pairs(scene.particles.size());
  for (std::size_t p = 0; p < scene.models.contact_pairs.size(); ++p) {
    try {
      create_model<similitude_contact_functions>(plugin, describe(scene), values_of(scene.models.contact_pairs[p]));
    } catch (const PluginError& refusal) {
      throw PluginError("models.contact.pair." + pair_name(scene.particles, pairs[p]) + ": " + refusal.what());
    }
  }
}

ContactModel create_contact_of_case(const Catalogue& catalogue, const ModelScene& scene, std::vector<PluginEntry>& in_use) {
  const PluginEntry& entry = entry_of(catalogue, scene.models.contact);
  in_use.push_back(entry);
  try {
    return create_contact(entry, scene);
  } catch (const PluginError&) {
    throw_if_a_pair_is_refused(entry, scene);
    throw;
  }
}

similitude_ratios ratios_of(const ScalingModel& scaling, const similitude_bed& real, const SourceMark& mark) {
  similitude_ratios ratios = identity_ratios();
  similitude_status status{};
  scaling.functions().ratios(scaling.instance(), &real, &ratios, &status);
  if (status.code != 0) {
    throw InputError(mark, "models.scaling", std::string(scaling.descriptor().id) + ": " + status.text);
  }
  return ratios;
}

/// An effect with all parameters at their defaults.
ModelChoice with_defaults(const PluginEntry& effect) {
  ModelChoice choice{.kind = "effect", .id = effect.descriptor->id, .parameters = {}, .mark = {}};
  for (std::uint32_t i = 0; i < effect.descriptor->parameter_count; ++i) {
    const similitude_parameter& row = effect.descriptor->parameters[i];
    choice.parameters.push_back({.name = row.name,
                                 .real = row.default_value,
                                 .text = row.default_text != nullptr ? row.default_text : "",
                                 .scales_as = row.scales_as,
                                 .given = false});
  }
  return choice;
}

/// `effects: auto` becomes the list of those the real bed calls for.
void choose_effects(RealScene& scene, const Catalogue& catalogue) {
  if (!scene.models.effects_auto) return;
  const similitude_bed bed = describe(scene);
  for (const std::string& id : catalogue.ids("effect")) {
    const PluginEntry& effect = *catalogue.find("effect", id);
    if (relevance_of(effect, bed).verdict == 1) scene.models.effects.push_back(with_defaults(effect));
  }
}

}  // namespace

similitude_relevance relevance_of(const PluginEntry& effect, const similitude_bed& bed) {
  const EffectModel model = create_model<similitude_effect_functions>(effect, bed, values_of(with_defaults(effect)));
  similitude_relevance relevance{};
  relevance.struct_size = sizeof(relevance);
  relevance.verdict = -1;
  if (model.functions().relevance != nullptr) model.functions().relevance(model.instance(), &bed, &relevance);
  return relevance;
}

/// The stress of the gas reaches the particles one gas step late (docs/decisions/0006): where the gas that they push aside weighs
/// more than they do, each step throws them back farther than the one before.
void refuse_light_particles(const Assembly& assembly) {
  if (!assembly.coupled()) return;
  const ModelScene& bed = assembly.model;
  for (const ParticleClass& type : bed.particles) {
    if (type.density >= bed.gas_density) continue;
    throw InputError(bed.models.fluid.mark, "models.fluid",
                     fmt::format("the simulated particles {}, of {:.4g} kg/m^3, are lighter than the gas of {:.4g} kg/m^3: its resistance "
                                 "to being pushed aside, known one gas step late, would throw them about.",
                                 type.name, type.density, bed.gas_density),
                     "Use particles heavier than the gas, or fluid: prescribed, which feels nothing of them.");
  }
}

Assembly assemble(const RealScene& scene, const Catalogue& catalogue) {
  Assembly assembly;
  assembly.real = scene;
  choose_effects(assembly.real, catalogue);
  // The real bed's grid is laid only to be checked: its messages speak of the lengths the user wrote.
  const Grid checked(scene);

  const similitude_bed real_bed = describe(scene);
  assembly.scaling =
      create<similitude_scaling_functions>(catalogue, scene.models.scaling, real_bed, assembly.plugins);
  assembly.ratios = ratios_of(assembly.scaling, real_bed, scene.models.scaling.mark);
  assembly.results = result_ratios(scene, assembly.ratios);
  assembly.model = simulated_bed(assembly.real, assembly.ratios);
  assembly.warnings = scaling_warnings(assembly.real, assembly.ratios);

  const Models& models = assembly.model.models;
  const similitude_bed bed = describe(assembly.model);
  assembly.contact = create_contact_of_case(catalogue, assembly.model, assembly.plugins);
  assembly.drag = create<similitude_drag_functions>(catalogue, models.drag, bed, assembly.plugins);
  assembly.fluid = create<similitude_fluid_functions>(catalogue, models.fluid, bed, assembly.plugins);
  for (const ModelChoice& choice : models.effects) {
    EffectModel effect = create<similitude_effect_functions>(catalogue, choice, bed, assembly.plugins);
    if (effect.functions().particles != nullptr) assembly.effects.push_back(std::move(effect));
  }
  assembly.grid = std::make_unique<Grid>(assembly.model);

  assembly.contact_needs.struct_size = sizeof(similitude_contact_needs);
  assembly.contact.functions().needs(assembly.contact.instance(), &assembly.contact_needs);
  assembly.fluid_needs = needs_of(assembly.fluid);
  refuse_light_particles(assembly);
  return assembly;
}

MapBack map_back(const Assembly& assembly) {
  MapBack map = map_back(assembly.real, assembly.ratios);
  map.scaling_law = assembly.scaling.descriptor().id;
  return map;
}

ContactModel softened_contact(const Assembly& assembly, double stiffness_factor) {
  ModelScene scene = assembly.model;
  const auto soften = [stiffness_factor](ModelChoice& set) {
    for (auto& parameter : set.parameters) {
      if (parameter.scales_as == SIMILITUDE_SCALES_AS_STIFFNESS || parameter.scales_as == SIMILITUDE_SCALES_AS_MODULUS) {
        parameter.real *= stiffness_factor;
      }
    }
  };
  soften(scene.models.contact);
  for (ModelChoice& set : scene.models.contact_pairs) soften(set);
  const PluginEntry entry{.descriptor = &assembly.contact.descriptor(), .file = {}, .level = {}, .hides = {}};
  return create_contact(entry, scene);
}

}  // namespace similitude
