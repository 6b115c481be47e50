#include "stepper/assembly.h"

#include "scene/messages.h"

namespace similitude {
namespace {

std::vector<similitude_value> values_of(const ModelChoice& choice) {
  std::vector<similitude_value> values;
  values.reserve(choice.parameters.size());
  for (const auto& parameter : choice.parameters) {
    values.push_back({parameter.real, parameter.text.empty() ? nullptr : parameter.text.c_str()});
  }
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

similitude_ratios ratios_of(const ScalingModel& scaling, const similitude_bed& real, const SourceMark& mark) {
  similitude_ratios ratios = identity_ratios();
  similitude_status status{};
  scaling.functions().ratios(scaling.instance(), &real, &ratios, &status);
  if (status.code != 0) {
    throw InputError(mark, "models.scaling", std::string(scaling.descriptor().id) + ": " + status.text);
  }
  return ratios;
}

}  // namespace

Assembly assemble(const RealScene& scene, const Catalogue& catalogue) {
  Assembly assembly;
  assembly.real = scene;
  // The real bed's grid is laid only to be checked: its messages speak of the lengths the user wrote.
  const Grid checked(scene);

  const similitude_bed real_bed = describe(scene);
  assembly.scaling =
      create<similitude_scaling_functions>(catalogue, scene.models.scaling, real_bed, assembly.plugins);
  assembly.ratios = ratios_of(assembly.scaling, real_bed, scene.models.scaling.mark);
  assembly.results = result_ratios(scene, assembly.ratios);
  assembly.model = simulated_bed(scene, assembly.ratios);

  const Models& models = assembly.model.models;
  const similitude_bed bed = describe(assembly.model);
  assembly.contact = create<similitude_contact_functions>(catalogue, models.contact, bed, assembly.plugins);
  assembly.drag = create<similitude_drag_functions>(catalogue, models.drag, bed, assembly.plugins);
  assembly.fluid = create<similitude_fluid_functions>(catalogue, models.fluid, bed, assembly.plugins);
  assembly.grid = std::make_unique<Grid>(assembly.model);

  assembly.contact_needs.struct_size = sizeof(similitude_contact_needs);
  assembly.contact.functions().needs(assembly.contact.instance(), &assembly.contact_needs);
  return assembly;
}

ContactModel softened_contact(const Assembly& assembly, double stiffness_factor) {
  ModelChoice choice = assembly.model.models.contact;
  for (auto& parameter : choice.parameters) {
    if (parameter.scales_as == SIMILITUDE_SCALES_AS_STIFFNESS || parameter.scales_as == SIMILITUDE_SCALES_AS_MODULUS) {
      parameter.real *= stiffness_factor;
    }
  }
  const PluginEntry entry{.descriptor = &assembly.contact.descriptor(), .file = {}, .level = {}, .hides = {}};
  return create_model<similitude_contact_functions>(entry, describe(assembly.model), values_of(choice));
}

}  // namespace similitude
