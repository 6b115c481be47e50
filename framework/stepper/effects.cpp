#include "stepper/effects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <fmt/format.h>

#include "particles/contact_effects.h"
#include "loader/number_text.h"
#include "scene/messages.h"
#include "similarity/ratios.h"

namespace similitude {
namespace {

constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();

/// The number is the same thing in both models, so it is written once in a case.
void take_from_others(ModelChoice& effect, const Catalogue& catalogue, const Models& models) {
  const PluginEntry* entry = catalogue.find("effect", effect.id);
  if (entry == nullptr) return;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const char* kind = entry->descriptor->parameters[i].taken_from;
    if (kind == nullptr || !std::isnan(effect.parameters[i].real)) continue;
    for (const ModelChoice* other : {&models.contact, &models.drag, &models.fluid}) {
      if (other->kind != kind) continue;
      for (const ModelParameter& parameter : other->parameters) {
        if (parameter.name == effect.parameters[i].name) effect.parameters[i].real = parameter.real;
      }
    }
  }
}

std::vector<similitude_value> values_of(const ModelChoice& choice) {
  std::vector<similitude_value> values;
  for (const ModelParameter& parameter : choice.parameters) {
    values.push_back({parameter.real, parameter.text.empty() ? nullptr : parameter.text.c_str()});
  }
  return values;
}

/// What the case gives of an effect's own quantities, by quantity, and of the inlet that differs most.
struct GivenOf {
  std::vector<double> value, inflow;

  GivenOf(const EffectModel& model, const RealScene& scene)
      : value(model.functions().quantity_count, k_unknown), inflow(model.functions().quantity_count, k_unknown) {
    for (std::size_t q = 0; q < value.size(); ++q) {
      const similitude_quantity& quantity = model.functions().quantities[q];
      const bool of_particles = quantity.kind == SIMILITUDE_PARTICLE_SCALAR || quantity.kind == SIMILITUDE_PARTICLE_PROPERTY;
      if (of_particles) {
        if (!scene.particles.empty()) value[q] = value_of(scene.particles.front().values, quantity.name);
      } else {
        value[q] = value_of(quantity.kind == SIMILITUDE_WALL_PROPERTY ? scene.wall_values : scene.gas_values, quantity.name);
      }
      if (std::isnan(value[q])) value[q] = quantity.default_value;
      if (quantity.kind != SIMILITUDE_GAS_SCALAR) continue;
      for (const Patch& patch : scene.patches) {
        const double flows_in = value_of(patch.values, quantity.name);
        if (patch.kind != PatchKind::velocity || std::isnan(flows_in)) continue;
        if (std::isnan(inflow[q]) || std::abs(flows_in - value[q]) > std::abs(inflow[q] - value[q])) inflow[q] = flows_in;
      }
    }
  }
};

similitude_relevance relevance_of(const EffectModel& model, const RealScene& scene, const similitude_bed& bed,
                                  const similitude_occurred* occurred) {
  const GivenOf given(model, scene);
  const similitude_evidence evidence{.struct_size = sizeof evidence,
                                     .reserved = 0,
                                     .bed = &bed,
                                     .value = given.value.data(),
                                     .inflow_value = given.inflow.data(),
                                     .occurred = occurred};
  similitude_relevance relevance{};
  relevance.struct_size = sizeof relevance;
  relevance.verdict = -1;
  model.functions().relevance(model.instance(), &evidence, &relevance);
  return relevance;
}

std::string text_of(const char* text) { return text != nullptr ? text : ""; }

std::string words(const EffectVerdict& verdict, const similitude_relevance& relevance) {
  const auto number = [](double value) { return std::isnan(value) ? std::string("unknown") : two_digits(value); };
  std::string value = number(verdict.value);
  if (verdict.lowest < verdict.highest) value = number(verdict.lowest) + " ... " + number(verdict.highest);
  std::string line = fmt::format("{} = {}, needed {} {}", verdict.group, value, relevance.needed_below != 0 ? "below" : "above",
                                 number(verdict.threshold));
  if (!verdict.source.empty()) line += " (" + verdict.source + ")";
  if (verdict.verdict == -1 && relevance.missing != nullptr) line += fmt::format("; give {} to tell", relevance.missing);
  return line;
}

bool listed(const std::vector<ModelChoice>& effects, const std::string& id) {
  return std::ranges::any_of(effects, [&](const ModelChoice& effect) { return effect.id == id; });
}

bool is_there(const Models& models, const std::string& id) {
  return models.contact.id == id || models.drag.id == id || models.fluid.id == id || models.scaling.id == id || listed(models.effects, id);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

std::string either(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return text;
}

}  // namespace

ModelChoice effect_with_defaults(const PluginEntry& effect) {
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

void choose_effects(RealScene& scene, const Catalogue& catalogue) {
  if (scene.models.effects_auto) {
    for (const EffectVerdict& verdict : judge_effects(scene, catalogue, nullptr)) {
      if (verdict.verdict == 1) scene.models.effects.push_back(effect_with_defaults(*catalogue.find("effect", verdict.id)));
    }
  }
  for (ModelChoice& effect : scene.models.effects) take_from_others(effect, catalogue, scene.models);
}

void check_partners(const RealScene& scene, std::span<const EffectModel> effects) {
  const Models& models = scene.models;
  for (const EffectModel& effect : effects) {
    const std::string id = effect.descriptor().id;
    SourceMark mark;
    for (const ModelChoice& choice : models.effects)
      if (choice.id == id) mark = choice.mark;
    const similitude_effect_needs needs = needs_of(effect);
    for (const std::string& group : split(text_of(needs.partners), ' ')) {
      const std::vector<std::string> any = split(group, '|');
      if (std::ranges::any_of(any, [&](const std::string& one) { return is_there(models, one); })) continue;
      throw InputError(mark, "models.effects", id + " works only together with " + either(any) + ", which this case does not use.",
                       "Choose " + either(any) + ", or leave " + id + " out of models.effects.");
    }
    for (const std::string& other : split(text_of(needs.conflicts), ' ')) {
      if (!is_there(models, other)) continue;
      throw InputError(mark, "models.effects", id + " and " + other + " are in each other's way: both would count the same thing.",
                       "Leave one of the two out.");
    }
  }
}

std::vector<EffectVerdict> judge_effects(const RealScene& scene, const Catalogue& catalogue, const similitude_occurred* occurred) {
  std::vector<EffectVerdict> verdicts;
  const similitude_bed bed = describe(scene);
  for (const std::string& id : catalogue.ids("effect")) {
    const PluginEntry& entry = *catalogue.find("effect", id);
    ModelChoice choice = effect_with_defaults(entry);
    EffectVerdict verdict;
    for (const ModelChoice& given : scene.models.effects) {
      if (given.id != id) continue;
      choice = given;
      verdict.chosen = true;
    }
    take_from_others(choice, catalogue, scene.models);
    verdict.id = id;
    try {
      const EffectModel model = create_model<similitude_effect_functions>(entry, bed, values_of(choice));
      const similitude_relevance relevance = relevance_of(model, scene, bed, occurred);
      verdict.group = text_of(relevance.group);
      verdict.source = text_of(relevance.source);
      verdict.value = relevance.value;
      verdict.threshold = relevance.threshold;
      verdict.lowest = relevance.lowest;
      verdict.highest = relevance.highest;
      verdict.verdict = relevance.verdict;
      verdict.because = words(verdict, relevance);
    } catch (const PluginError& refusal) {   // it cannot do without a parameter that has no default
      verdict.value = verdict.threshold = verdict.lowest = verdict.highest = k_unknown;
      verdict.because = refusal.what();
    }
    verdicts.push_back(verdict);
  }
  return verdicts;
}

}  // namespace similitude
