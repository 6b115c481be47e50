#include "stepper/assembly.h"

#include <fmt/format.h>

#include "particles/bed_file.h"
#include "particles/contact_effects.h"
#include "scene/material_pairs.h"
#include "scene/messages.h"
#include "stepper/effects.h"

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

/// A file says where every grain lies. A law whose grains are larger over the bed's size simulates fewer, and knows no places
/// for them; and it keeps the groups of one density.
void refuse_file_that_does_not_scale(const Assembly& assembly) {
  const RealScene& real = assembly.real;
  const similitude_ratios& r = assembly.ratios;
  if (real.bed.kind != FillKind::file || real.models.scaling.id == "exact") return;
  double count = 0;
  for (const ParticleClass& type : real.particles) {
    count += type.known_count();
    const FileRows rows = type.rows.value_or(FileRows{});
    if (rows.least_density == rows.largest_density) continue;
    throw InputError(real.bed.mark, "scene.bed.file",
                     fmt::format("its grains of {} have densities from {:.4g} to {:.4g} kg/m^3, but the scaling law {} is for one particle density.",
                                 type.name, type.density * rows.least_density, type.density * rows.largest_density, real.models.scaling.id),
                     "Give all rows one density, or use models.scaling: exact.");
  }
  if (count <= 1 || r.length == r.diameter) return;
  throw InputError(real.bed.mark, "scene.bed.file",
                   fmt::format("{} simulates grains {:.4g} times as large over the bed's size, and so {:.4g} in place of the file's {:.0f}; a file "
                               "says nothing of where they lie.",
                               real.models.scaling.id, r.diameter / r.length, std::max(1.0, std::round(count * std::pow(r.length / r.diameter, 3))),
                               count),
                   "Write bed: {fill: settle} with a count or a height, or use models.scaling: exact.");
}

/// Gas and particle of the real bed exchange heat and mass at their own pace. Nothing is known that scales it together with
/// the motion, so that only beds with the real gas and the real particle in it are left: the exact one, and parcels.
void refuse_scaled_scalars(const Assembly& assembly) {
  const similitude_ratios& r = assembly.ratios;
  if (assembly.scalars.empty()) return;
  for (const double ratio : {r.length, r.drag_diameter, r.particle_density, r.gas_density, r.gas_viscosity, r.velocity, r.time}) {
    if (ratio == 1) continue;
    const std::string id = assembly.scalars.effects.front().effect->descriptor().id;
    throw InputError(assembly.real.models.scaling.mark, "models.scaling",
                     assembly.real.models.scaling.id + " changes the gas, lengths or times, and " + id +
                         " does not keep pace: heat and species would be exchanged at another rate than the bed moves.",
                     "Use exact, parcel, bierwisch or coarse_grain, which leave the gas and the particle in it as they are, or leave " + id +
                         " out of models.effects.");
  }
}

/// What chose itself must not stand in the way of a solver that the case names.
void leave_out_unusable_viscosity(Assembly& assembly) {
  if (!assembly.real.models.effects_auto || assembly.fluid_needs.takes_added_viscosity != 0) return;
  std::erase_if(assembly.effects, [&](const EffectModel& effect) {
    if (effect.functions().cells == nullptr) return false;
    const std::string id = effect.descriptor().id;
    assembly.warnings.push_back("models.effects: this bed calls for " + id + ", but " + assembly.fluid.descriptor().id +
                                " has no viscosity that it could add to.");
    for (Models* models : {&assembly.real.models, &assembly.model.models}) {
      std::erase_if(models->effects, [&](const ModelChoice& choice) { return choice.id == id; });
    }
    std::erase_if(assembly.plugins, [&](const PluginEntry& plugin) { return plugin.descriptor == &effect.descriptor(); });
    return true;
  });
}

/// The solver must do what effects ask of it.
void check_gas_for_effects(const Assembly& assembly) {
  const std::string fluid = assembly.fluid.descriptor().id;
  if (assembly.coupled() && !assembly.scalars.gas.empty() && assembly.fluid_needs.gives_flux == 0) {
    throw InputError(assembly.real.models.fluid.mark, "models.fluid",
                     fluid + " does not tell the flux of the gas, which carries its " + assembly.scalars.gas.front().name + ".",
                     "Use vans or porous.");
  }
  for (const EffectModel& effect : assembly.effects) {
    if (effect.functions().cells == nullptr || assembly.fluid_needs.takes_added_viscosity != 0) continue;
    throw InputError(assembly.real.models.fluid.mark, "models.fluid",
                     fluid + " has no viscosity that " + effect.descriptor().id + " could add to.",
                     "Use vans, or leave " + std::string(effect.descriptor().id) + " out of models.effects.");
  }
}

/// The stress of the gas reaches the particles one gas step late (docs/decisions/0008): where the gas that they push aside weighs
/// more than they do, each step throws them back farther than the one before.
void refuse_light_particles(const Assembly& assembly) {
  if (!assembly.coupled() || assembly.added_mass()) return;
  const ModelScene& bed = assembly.model;
  for (const ParticleClass& type : bed.particles) {
    const double density = type.density * type.rows.value_or(FileRows{}).least_density;
    if (density >= bed.gas_density) continue;
    throw InputError(bed.models.fluid.mark, "models.fluid",
                     fmt::format("the simulated particles {}, of {:.4g} kg/m^3, are lighter than the gas of {:.4g} kg/m^3: its resistance "
                                 "to being pushed aside, known one gas step late, would throw them about.",
                                 type.name, density, bed.gas_density),
                     "Give the particles the inertia of the gas around them, models.effects: [virtual_mass], or use fluid: prescribed, which "
                     "feels nothing of them.");
  }
}

}  // namespace

Assembly assemble(const RealScene& scene, const Catalogue& catalogue) {
  Assembly assembly;
  assembly.real = scene;
  read_bed_rows(assembly.real);
  choose_effects(assembly.real, catalogue);
  // The real bed's grid is laid only to be checked: its messages speak of the lengths the user wrote.
  const Grid checked(scene);

  const similitude_bed real_bed = describe(assembly.real);
  assembly.scaling =
      create<similitude_scaling_functions>(catalogue, scene.models.scaling, real_bed, assembly.plugins);
  assembly.ratios = ratios_of(assembly.scaling, real_bed, scene.models.scaling.mark);
  refuse_file_that_does_not_scale(assembly);
  assembly.results = result_ratios(scene, assembly.ratios);
  assembly.model = simulated_bed(assembly.real, assembly.ratios);
  assembly.warnings = scaling_warnings(assembly.real, assembly.ratios);

  const Models& models = assembly.model.models;
  const similitude_bed bed = describe(assembly.model);
  assembly.contact = create_contact_of_case(catalogue, assembly.model, assembly.plugins);
  assembly.drag = create<similitude_drag_functions>(catalogue, models.drag, bed, assembly.plugins);
  assembly.fluid = create<similitude_fluid_functions>(catalogue, models.fluid, bed, assembly.plugins);
  for (const ModelChoice& choice : models.effects) {
    assembly.effects.push_back(create<similitude_effect_functions>(catalogue, choice, bed, assembly.plugins));
  }
  check_partners(assembly.real, assembly.effects);
  assembly.grid = std::make_unique<Grid>(assembly.model);

  assembly.contact_needs.struct_size = sizeof(similitude_contact_needs);
  assembly.contact.functions().needs(assembly.contact.instance(), &assembly.contact_needs);
  assembly.fluid_needs = needs_of(assembly.fluid);
  leave_out_unusable_viscosity(assembly);
  for (const EffectModel& effect : assembly.effects) {
    const similitude_effect_needs needs = needs_of(effect);
    assembly.effect_reads |= needs.reads;
    assembly.effect_adds |= needs.adds;
  }
  refuse_light_particles(assembly);
  assembly.scalars = plan_scalars(assembly.model, assembly.effects);
  refuse_scaled_scalars(assembly);
  check_gas_for_effects(assembly);
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
