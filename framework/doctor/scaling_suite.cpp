#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "doctor/suites.h"
#include "doctor/trial_values.h"
#include "scene/messages.h"
#include "similarity/audit.h"
#include "similarity/ratios.h"

namespace similitude::doctor {
namespace {

using Values = std::vector<similitude_value>;

struct NamedRatio {
  const char* name;
  double similitude_ratios::*value;
};
constexpr NamedRatio k_ratios[] = {{"length", &similitude_ratios::length},
                                   {"diameter", &similitude_ratios::diameter},
                                   {"drag_diameter", &similitude_ratios::drag_diameter},
                                   {"particle_density", &similitude_ratios::particle_density},
                                   {"gas_density", &similitude_ratios::gas_density},
                                   {"gas_viscosity", &similitude_ratios::gas_viscosity},
                                   {"velocity", &similitude_ratios::velocity},
                                   {"time", &similitude_ratios::time},
                                   {"stiffness", &similitude_ratios::stiffness},
                                   {"modulus", &similitude_ratios::modulus},
                                   {"energy_loss", &similitude_ratios::energy_loss},
                                   {"parcel_weight", &similitude_ratios::parcel_weight}};

/// Throws Complaint with the law's words if it has no bed for these parameters.
similitude_ratios ratios_of(const ScalingModel& law) {
  similitude_ratios ratios = identity_ratios();
  similitude_bed bed = trial_bed();
  similitude_status status{};
  status.row = -1;
  law.functions().ratios(law.instance(), &bed, &ratios, &status);
  if (status.code != 0) throw Complaint(status);
  return ratios;
}

similitude_ratios ratios_of(const PluginEntry& plugin, const Values& values) {
  return ratios_of(create_model<similitude_scaling_functions>(plugin, trial_bed(), values));
}

std::string text(const similitude_ratios& ratios) {
  std::string words;
  for (const NamedRatio& r : k_ratios)
    if (ratios.*r.value != 1) words += fmt::format("{}{} {:.4g}", words.empty() ? "" : ", ", r.name, ratios.*r.value);
  return words.empty() ? "all 1" : words;
}

/// The first ratio that no bed can have, in words; empty if there is none.
std::string impossible(const similitude_ratios& ratios) {
  for (const NamedRatio& r : k_ratios)
    if (!(ratios.*r.value > 0) || !std::isfinite(ratios.*r.value)) return fmt::format("the ratio of {} is {:g}", r.name, ratios.*r.value);
  return "";
}

/// At the trial values, and with every number at either end of its range; a law may say in words that it has no bed there.
Outcome check_positive(const PluginEntry& plugin) {
  const similitude_descriptor& model = *plugin.descriptor;
  const char* const advice = "Ratios are simulated over real, above zero; what a law does not touch stays 1.";
  const Values middle = trial_values(model);
  const similitude_ratios first = ratios_of(plugin, middle);
  if (const std::string words = impossible(first); !words.empty()) return fail(words + ".", advice);
  int tried = 1, refused = 0;
  for (std::uint32_t p = 0; p < model.parameter_count; ++p) {
    if (model.parameters[p].type == SIMILITUDE_CHOICE) continue;
    for (const double end : {model.parameters[p].minimum, model.parameters[p].maximum}) {
      if (!std::isfinite(end)) continue;
      Values values = middle;
      values[p].real = end;
      ++tried;
      try {
        if (const std::string words = impossible(ratios_of(plugin, values)); !words.empty())
          return fail(fmt::format("{} with {} = {:g}.", words, model.parameters[p].name, end), advice);
      } catch (const PluginError&) {
        ++refused;
      } catch (const Complaint& complaint) {
        if (*complaint.what() == 0) return fail(fmt::format("it refuses {} = {:g} without a word.", model.parameters[p].name, end), "Fill status->text.");
        ++refused;
      }
    }
  }
  return ok(fmt::format("12 ratios above zero with {} sets of parameters, {} refused in words; here: {}", tried, refused, text(first)));
}

/// Every required pure number that may be 1 is 1: the simulated bed is the real one.
Outcome check_identity(const PluginEntry& plugin) {
  constexpr double rounding = 1e-9;
  const similitude_descriptor& model = *plugin.descriptor;
  Values values = trial_values(model);
  std::string set;
  for (std::uint32_t p = 0; p < model.parameter_count; ++p) {
    const similitude_parameter& row = model.parameters[p];
    const bool ratio = row.type == SIMILITUDE_REAL && std::strcmp(row.unit, "1") == 0 && row.minimum <= 1 && row.maximum >= 1;
    if (!ratio || (row.required == 0 && row.default_value != 1)) continue;
    values[p].real = 1;
    set += fmt::format("{}{}", set.empty() ? "" : " = ", row.name);
  }
  if (set.empty()) return skipped("it has no parameter that could be 1");
  const similitude_ratios ratios = ratios_of(plugin, values);
  for (const NamedRatio& r : k_ratios)
    if (!(std::abs(ratios.*r.value - 1) <= rounding))
      return fail(fmt::format("with {} = 1 the ratio of {} is {:.6g}.", set, r.name, ratios.*r.value),
                  "A bed that is not scaled is the real bed: every ratio is 1.");
  return ok("all ratios are 1 with " + set + " = 1");
}

constexpr double k_beside_the_middle = 0.45;   // of a range: in the middle of one like 0.01 ... 100 nothing is scaled

/// What the framework's own audit makes of a scaled bed.
Outcome check_audit(const PluginEntry& plugin) {
  constexpr double rounding = 1e-6;   // ratios that were written by hand agree so far
  const similitude_ratios ratios = ratios_of(plugin, trial_values(*plugin.descriptor, k_beside_the_middle));
  const double clock = ratios.time * ratios.velocity / ratios.length;
  if (!(std::abs(clock - 1) <= rounding))
    return fail(fmt::format("time x velocity / length is {:.6g}: the gas would cross the bed in another time than its clock says.", clock),
                "Give time as length / velocity.");
  const double volume = ratios.parcel_weight * std::pow(ratios.drag_diameter / ratios.diameter, 3);
  if (!(std::abs(volume - 1) <= rounding))
    return fail(fmt::format("the gas sees {:.6g} times the volume of particles that moves (parcel_weight drag_diameter^3 / diameter^3).", volume),
                "A parcel of w particles has w times the volume of one: parcel_weight = (diameter / drag_diameter)^3.");
  const RealScene real = trial_scene();
  try {
    const ModelScene simulated = simulated_bed(real, ratios);
    std::string kept, lost;
    for (const GroupComparison& group : compare_groups(describe(real), describe(simulated))) {
      if (!std::isfinite(group.ratio) || !(group.ratio > 0))
        return fail(fmt::format("the audit finds {} x {:g} in the simulated bed.", group.name, group.ratio), "Such a bed cannot be.");
      (group.kept ? kept : lost) += fmt::format("{}{}", (group.kept ? kept : lost).empty() ? "" : ", ",
                                                group.kept ? group.name : fmt::format("{} x {:.3g}", group.name, group.ratio));
    }
    return ok(fmt::format("{}; keeps {}; misses {}", text(ratios), kept.empty() ? "nothing" : kept, lost.empty() ? "nothing" : lost));
  } catch (const InputError& error) {
    return fail(fmt::format("no bed can be made of its ratios: {}", error.what()), "Check the formulas against the bed in `similitude scale`.");
  }
}

/// A law is a function of the bed: asked again it says the same.
Outcome check_repeats(const PluginEntry& plugin) {
  const ScalingModel law = create_model<similitude_scaling_functions>(plugin, trial_bed(), trial_values(*plugin.descriptor));
  const similitude_ratios first = ratios_of(law), second = ratios_of(law);
  for (const NamedRatio& r : k_ratios)
    if (first.*r.value != second.*r.value)
      return fail(fmt::format("asked twice for the same bed it gives {} {:.17g} and {:.17g}.", r.name, first.*r.value, second.*r.value),
                  "Keep nothing between calls.");
  return ok("asked twice it says the same");
}

}  // namespace

std::vector<Check> scaling_suite() {
  return {{"ratios", check_positive, true}, {"identity", check_identity}, {"audit", check_audit}, {"repeats itself", check_repeats}};
}

}  // namespace similitude::doctor
