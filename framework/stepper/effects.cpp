#include "stepper/effects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <fmt/format.h>

#include "loader/describe.h"
#include "loader/number_text.h"
#include "particles/contact_effects.h"
#include "scene/material_pairs.h"
#include "scene/messages.h"
#include "scene/quantities.h"
#include "scene/units.h"
#include "similarity/ratios.h"

namespace similitude {
namespace {

constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();

/// The different values that models of a kind hold of a parameter, over all pairs of materials and both partners: `partner_X` is X of
/// the second partner, where it is of another material.
std::vector<double> values_held(const Models& models, const std::string& kind, const std::string& name) {
  std::vector<double> found;
  const auto see = [&](const ModelChoice& model) {
    if (model.kind != kind) return;
    for (const ModelParameter& parameter : model.parameters) {
      if ((parameter.name != name && parameter.name != "partner_" + name) || std::isnan(parameter.real)) continue;
      if (std::ranges::find(found, parameter.real) == found.end()) found.push_back(parameter.real);
    }
  };
  for (const ModelChoice& set : contact_sets(models)) see(set);
  for (const ModelChoice* other : {&models.drag, &models.fluid}) see(*other);
  return found;
}

/// The number is the same thing in both models, so it is written once in a case. Where it has several values it stays open.
void take_from_others(ModelChoice& effect, const Catalogue& catalogue, const Models& models) {
  const PluginEntry* entry = catalogue.find("effect", effect.id);
  if (entry == nullptr) return;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const char* kind = entry->descriptor->parameters[i].taken_from;
    if (kind == nullptr || !std::isnan(effect.parameters[i].real)) continue;
    const std::vector<double> held = values_held(models, kind, effect.parameters[i].name);
    if (held.size() == 1) effect.parameters[i].real = held.front();
  }
}

std::vector<similitude_value> values_of(const ModelChoice& choice) {
  std::vector<similitude_value> values;
  for (const ModelParameter& parameter : choice.parameters) {
    values.push_back({parameter.real, parameter.text.empty() ? nullptr : parameter.text.c_str()});
  }
  return values;
}

/// What the case gives of an effect's own quantities to one class of particles, by quantity, and to the inlet or the other class
/// that differs most.
struct GivenOf {
  std::vector<double> value, inflow;

  GivenOf(const EffectModel& model, const RealScene& scene, std::size_t species)
      : value(model.functions().quantity_count, k_unknown), inflow(model.functions().quantity_count, k_unknown) {
    for (std::size_t q = 0; q < value.size(); ++q) {
      const similitude_quantity& quantity = model.functions().quantities[q];
      const bool of_particles = quantity.kind == SIMILITUDE_PARTICLE_SCALAR || quantity.kind == SIMILITUDE_PARTICLE_PROPERTY;
      if (of_particles) {
        if (!scene.particles.empty()) value[q] = value_of(scene.particles[species].values, quantity.name);
      } else {
        value[q] = value_of(quantity.kind == SIMILITUDE_WALL_PROPERTY ? scene.wall_values : scene.gas_values, quantity.name);
      }
      if (std::isnan(value[q])) value[q] = quantity.default_value;
      const auto elsewhere = [&](double other) {
        if (std::isnan(other)) return;
        if (std::isnan(inflow[q]) || std::abs(other - value[q]) > std::abs(inflow[q] - value[q])) inflow[q] = other;
      };
      if (quantity.kind == SIMILITUDE_GAS_SCALAR) {
        for (const Patch& patch : scene.patches)
          if (patch.kind == PatchKind::velocity) elsewhere(value_of(patch.values, quantity.name));
      } else if (quantity.kind == SIMILITUDE_PARTICLE_SCALAR) {
        for (std::size_t other = 0; other < scene.particles.size(); ++other)
          if (other != species) elsewhere(value_of(scene.particles[other].values, quantity.name));
      }
    }
  }
};

similitude_relevance relevance_of(const EffectModel& model, const RealScene& scene, const similitude_bed& bed, std::size_t species,
                                  const similitude_occurred* occurred) {
  const GivenOf given(model, scene, species);
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

/// Does one class need the effect less than the other? What cannot be told stands between negligible and needed.
bool less_in_need(const similitude_relevance& one, const similitude_relevance& other) {
  const auto need = [](const similitude_relevance& r) { return r.verdict == 1 ? 2 : r.verdict == 0 ? 0 : 1; };
  if (need(one) != need(other)) return need(one) < need(other);
  return one.needed_below != 0 ? one.value > other.value : one.value < other.value;
}

bool say_the_same(const similitude_relevance& one, const similitude_relevance& other) {
  return one.verdict == other.verdict && (one.value == other.value || (std::isnan(one.value) && std::isnan(other.value)));
}

std::string text_of(const char* text) { return text != nullptr ? text : ""; }

std::string words(const EffectVerdict& verdict, const similitude_relevance& relevance) {
  const auto number = [](double value) { return std::isnan(value) ? std::string("unknown") : two_digits(value); };
  std::string value = number(verdict.value);
  if (verdict.lowest < verdict.highest) value = number(verdict.lowest) + " ... " + number(verdict.highest);
  if (!verdict.species.empty()) value += " for " + verdict.species;
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

std::string joined(const std::vector<std::string>& names, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : i + 1 == names.size() ? last : ", ") + names[i];
  return text;
}
std::string either(const std::vector<std::string>& names) { return joined(names, " or "); }

/// An effect has one value of what it takes from the contact law. It may not need it; if it does, partners must be alike.
void refuse_unlike_partners(const ModelChoice& effect, const Catalogue& catalogue, const RealScene& scene) {
  const PluginEntry* entry = catalogue.find("effect", effect.id);
  if (entry == nullptr) return;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const similitude_parameter& row = entry->descriptor->parameters[i];
    if (row.taken_from == nullptr || !std::isnan(effect.parameters[i].real)) continue;
    const std::vector<double> held = values_held(scene.models, row.taken_from, row.name);
    if (held.size() < 2) continue;
    try {
      create_model<similitude_effect_functions>(*entry, describe(scene), values_of(effect));
      return;   // it does without
    } catch (const PluginError&) {
      std::vector<std::string> values;
      for (const double value : held) values.push_back(format_quantity(value, row.unit));
      throw InputError(effect.mark, "models.effects",
                       fmt::format("{} works with one {}, but the partners in models.{} have {}.", effect.id, row.name, row.taken_from,
                                   joined(values, " and ")),
                       fmt::format("Give all pairs and partners of models.{} the same {}, or leave {} out of models.effects.",
                                   row.taken_from, row.name, effect.id));
    }
  }
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
  for (ModelChoice& effect : scene.models.effects) {
    take_from_others(effect, catalogue, scene.models);
    refuse_unlike_partners(effect, catalogue, scene);
  }
}

std::string written_list(const std::vector<std::string>& ids) { return "models.effects: [" + joined(ids, ", ") + "]"; }

std::vector<std::string> idle_value_warnings(const RealScene& scene, const Catalogue& catalogue) {
  if (!scene.models.effects_auto) return {};
  const std::vector<IdleValue> idle = idle_values(scene, catalogue);
  if (idle.empty()) return {};
  const std::vector<EffectVerdict> verdicts = judge_effects(scene, catalogue, nullptr);
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < idle.size(); ++i) {
    const std::string& id = idle[i].declared_by.front();
    const auto of_it = [&](const IdleValue& value) { return value.declared_by.front() == id; };
    if (std::any_of(idle.begin(), idle.begin() + static_cast<std::ptrdiff_t>(i), of_it)) continue;
    const auto all = std::ranges::count_if(idle, of_it);
    std::vector<std::string> with;
    for (const ModelChoice& effect : scene.models.effects) with.push_back(effect.id);
    with.push_back(id);
    warnings.push_back(InputError(idle[i].mark, idle[i].path,
                                  fmt::format("{} is not part of this run, so {}: {}.", id,
                                              all == 1 ? "this value does nothing" : fmt::format("this and {} more of its values do nothing", all - 1),
                                              std::ranges::find(verdicts, id, &EffectVerdict::id)->because),
                                  fmt::format("Write {} to have it, or remove {}.", written_list(with), all == 1 ? "this key" : "these keys"))
                           .what());
  }
  return warnings;
}

std::string with_its_defaults(const similitude_descriptor& effect) {
  std::string text = std::string("{id: ") + effect.id;
  for (std::uint32_t i = 0; i < effect.parameter_count; ++i) {
    const similitude_parameter& row = effect.parameters[i];
    if (row.type != SIMILITUDE_CHOICE && std::isnan(row.default_value)) continue;
    const std::string unit = text_of(row.unit);
    text += std::string(", ") + row.name + ": " + default_text(row) + (unit.empty() || unit == "1" ? "" : " " + unit);
  }
  return text + "}";
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
      std::vector<similitude_relevance> said;
      for (std::size_t species = 0; species == 0 || species < scene.particles.size(); ++species) {
        const similitude_bed bed = describe(scene, species);
        const EffectModel model = create_model<similitude_effect_functions>(entry, bed, values_of(choice));
        said.push_back(relevance_of(model, scene, bed, species, occurred));
      }
      const auto decisive = std::ranges::max_element(said, less_in_need);
      const similitude_relevance& relevance = *decisive;
      if (!std::ranges::all_of(said, [&](const similitude_relevance& other) { return say_the_same(other, relevance); }))
        verdict.species = scene.particles[static_cast<std::size_t>(decisive - said.begin())].name;
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
