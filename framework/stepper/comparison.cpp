#include "stepper/comparison.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "particles/bed_file.h"
#include "scene/case_file.h"
#include "scene/messages.h"
#include "scene/model_reader.h"
#include "stepper/inspection.h"
#include "stepper/prediction.h"
#include "stepper/time_steps.h"

namespace similitude {
namespace {

constexpr const char* k_asked_for = "asked for";
constexpr double k_default_geometry = 0.25;   // r, where a law shrinks the bed
constexpr double k_default_coarsening = 2;    // n/r, where a law leaves it free

CaseFile case_with(const CaseAsTyped& typed, const LawChoice& law) {
  std::vector<std::string> overrides = typed.overrides;
  if (!law.scaling.empty()) overrides.push_back("models.scaling=" + law.scaling);
  return read_case(typed.file, typed.catalogue, overrides);
}

std::string with_parameters(const std::string& id, const std::vector<std::pair<std::string, std::string>>& parameters) {
  std::string text = "{id: " + id;
  for (const auto& [name, value] : parameters) text += ", " + name + ": " + value;
  return text + "}";
}

std::string in_words(const std::vector<std::pair<std::string, std::string>>& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters) text += (text.empty() ? "" : ", ") + name + " = " + value;
  return text;
}

LawChoice law_with(const std::string& id, const std::vector<std::pair<std::string, std::string>>& parameters,
                   const std::string& because) {
  return {id, with_parameters(id, parameters), in_words(parameters), because};
}

/// What the case gives its own law, for people.
std::string given_parameters(const ModelChoice& model) {
  std::string text;
  for (const ModelParameter& parameter : model.parameters) {
    if (!parameter.given) continue;
    text += (text.empty() ? "" : ", ") + parameter.name + " = " +
            (parameter.text.empty() ? fmt::format("{:.6g}", parameter.real) : parameter.text);
  }
  return text;
}

bool has(const similitude_descriptor& law, const std::string& name) {
  for (std::uint32_t i = 0; i < law.parameter_count; ++i)
    if (law.parameters[i].name == name) return true;
  return false;
}

/// The law's required parameters with sizes filled in, or the first that is no size.
struct Sizes {
  bool geometry = false, n = false;
  std::string unknown;
};

Sizes required_sizes(const similitude_descriptor& law) {
  Sizes sizes;
  for (std::uint32_t i = 0; i < law.parameter_count; ++i) {
    const similitude_parameter& row = law.parameters[i];
    if (row.required == 0) continue;
    if (std::string(row.name) == "geometry") {
      sizes.geometry = true;
    } else if (std::string(row.name) == "n") {
      sizes.n = true;
    } else if (sizes.unknown.empty()) {
      sizes.unknown = row.name;
    }
  }
  return sizes;
}

/// "length=0.5,diameter=0.5": all that a law cannot do without, as --law takes it.
std::string example_of_law(const similitude_descriptor& law) {
  std::string text;
  for (std::uint32_t i = 0; i < law.parameter_count; ++i) {
    const similitude_parameter& row = law.parameters[i];
    if (row.required != 0) text += (text.empty() ? "" : ",") + std::string(row.name) + "=" + example_of_parameter(row);
  }
  return text;
}

/// A law that takes the gas fraction at minimum fluidization gets the case's, whoever gave it there.
void pass_gas_fraction(const similitude_descriptor& law, double gas_fraction,
                       std::vector<std::pair<std::string, std::string>>& parameters) {
  const char* name = "gas_fraction_at_minimum_fluidization";
  if (has(law, name)) parameters.emplace_back(name, fmt::format("{:.17g}", gas_fraction));
}

struct Priced {
  Assembly assembly;
  TimeSteps steps;
  double particles, particle_steps;
};

Priced priced(const CaseAsTyped& typed, const LawChoice& law) {
  Priced bed{.assembly = assemble(case_with(typed, law).scene, typed.catalogue), .steps = {}, .particles = 0, .particle_steps = 0};
  bed.steps = choose_time_steps(bed.assembly);
  bed.particles = static_cast<double>(expected_particles(bed.assembly.model));
  bed.particle_steps = bed.particles * bed.assembly.model.time.end / bed.steps.dt;
  return bed;
}

/// The drag models of both beds with what they are asked through.
struct Drags {
  DragModel real;
  SphereDrag of_real, of_simulated;
};

Drags drags_of(const Assembly& assembly, const Catalogue& catalogue) {
  const ModelChoice& choice = assembly.real.models.drag;
  std::vector<similitude_value> values;
  for (const ModelParameter& p : choice.parameters) values.push_back({p.real, p.text.empty() ? nullptr : p.text.c_str()});
  const similitude_bed real = describe(assembly.real), simulated = describe(assembly.model);
  const auto cell = [](const auto& scene) { return std::cbrt(scene.cell[0] * scene.cell[1] * scene.cell[2]); };
  Drags drags{create_model<similitude_drag_functions>(*catalogue.find("drag", choice.id), real, values), {}, {}};
  drags.of_simulated = sphere_drag(assembly.drag, sphere_in_gas(simulated), cell(assembly.model));
  return drags;
}

Strategy audited_strategy(const CaseAsTyped& typed, const LawChoice& law, Comparison& comparison) {
  Strategy strategy{.law = law, .error = {}, .factors = {}, .groups = {}, .warnings = {}};
  const Priced bed = priced(typed, law);
  const Assembly& assembly = bed.assembly;
  strategy.factors = assembly.ratios;
  const double gas_fraction = given_gas_fraction_at_minimum(assembly.real).value_or(comparison.gas_fraction_at_minimum);
  const ScalingAudit audit = audit_of(assembly, typed.catalogue, gas_fraction);
  strategy.groups = audit.groups;
  comparison.legend = audit.legend;
  strategy.warnings = assembly.warnings;
  strategy.warnings.insert(strategy.warnings.end(), audit.warnings.begin(), audit.warnings.end());
  for (const std::string& warning : bed.steps.warnings) strategy.warnings.push_back(warning);
  if (std::abs(gas_fraction / comparison.gas_fraction_at_minimum - 1) > k_kept_within)
    strategy.warnings.push_back(fmt::format("its u0/u_mf is taken at the gas fraction that it was told, {:.4g}.", gas_fraction));
  strategy.particles = bed.particles;
  strategy.particle_steps = bed.particle_steps;
  strategy.speedup = comparison.particle_steps / bed.particle_steps;
  strategy.wall_s = bed.particle_steps / comparison.particle_steps_per_s +
                    static_cast<double>(bed.steps.gas_steps_until(assembly.model.time.end)) *
                        (comparison.gas_step_s + comparison.exchange_s * bed.particles);
  return strategy;
}

/// u_mf of all laws is taken where the first law that was told a gas fraction at minimum fluidization has it, so that the law is
/// judged by what it was made of.
std::optional<double> gas_fraction_told(const CaseAsTyped& typed, const std::vector<LawChoice>& laws) {
  for (const LawChoice& law : laws) {
    if (law.because != k_asked_for) continue;
    try {
      const std::optional<double> told = given_gas_fraction_at_minimum(case_with(typed, law).scene);
      if (told) return told;
    } catch (const InputError&) {   // told in the law's own row
    }
  }
  return {};
}

/// What is measured or taken once for all laws.
Comparison started(const CaseAsTyped& typed) {
  RealScene scene = read_case(typed.file, typed.catalogue, typed.overrides).scene;
  read_bed_rows(scene);
  if (scene.particles.empty() || !(describe(scene).gravity > 0))
    throw InputError("this case has no particles under gravity: there is nothing that a scaling law could compare.",
                     "Give scene.particles, or remove scene.gravity.");
  if (!(describe(scene).particle_count > 0))
    throw InputError("this case does not say how many particles it has, so that no cost can be compared.",
                     "Give the particles a count and bed: {fill: settle}.");
  Comparison comparison;
  comparison.title = scene.title;
  comparison.gas_fraction_at_minimum = gas_fraction_at_minimum(scene);
  const Assembly assembly = assemble(scene, typed.catalogue);
  const TimeSteps steps = choose_time_steps(assembly);
  const PredictedCost cost = predict_cost(assembly, steps);
  if (!cost.gap.empty()) throw InputError("no cost can be compared: " + cost.gap);
  comparison.particle_steps_per_s = cost.particle_steps_per_s;
  comparison.threads = cost.threads;
  comparison.gas_step_s = cost.gas_step_s;
  comparison.exchange_s = cost.exchange_s;
  comparison.particle_steps = priced(typed, {"exact", "exact", "", ""}).particle_steps;
  return comparison;
}

// ------------------------------------------------------------------------------------------------------- proposals

constexpr double k_reached_within = 1e-4;   // of the wanted speed-up, by bisection of the logarithm of the size

double speedup_of(const CaseAsTyped& typed, const LawChoice& law, double real_particle_steps) {
  return real_particle_steps / priced(typed, law).particle_steps;
}

/// One size of one law, and how far it may go.
struct Knob {
  std::string id, name;
  std::vector<std::pair<std::string, std::string>> fixed;
  double from, to;   // from the real bed to the coarsest
};

LawChoice at(const Knob& knob, double value, const std::string& because) {
  std::vector<std::pair<std::string, std::string>> parameters = knob.fixed;
  parameters.emplace_back(knob.name, fmt::format("{:.6g}", value));
  LawChoice law = law_with(knob.id, parameters, because);
  const auto is_size = [](const auto& one) { return one.first == "n" || one.first == "geometry"; };
  parameters.erase(std::remove_if(parameters.begin(), parameters.end(), [&](const auto& one) { return !is_size(one); }),
                   parameters.end());
  law.parameters = in_words(parameters);
  return law;
}

std::vector<Knob> knobs(const Catalogue& catalogue, double gas_fraction) {
  constexpr double k_coarsest = 10, k_smallest = 1.0 / 64;
  std::vector<Knob> all;
  for (const std::string& id : catalogue.ids("scaling")) {
    const similitude_descriptor& law = *catalogue.find("scaling", id)->descriptor;
    const Sizes sizes = required_sizes(law);
    if (!sizes.unknown.empty()) continue;
    std::vector<std::pair<std::string, std::string>> fixed;
    pass_gas_fraction(law, gas_fraction, fixed);
    if (sizes.geometry && sizes.n) {
      for (const double r : {0.5, 0.25})
        all.push_back({id, "n", {{"geometry", fmt::format("{}", r)}}, r, r * k_coarsest});
    } else if (sizes.n) {
      all.push_back({id, "n", fixed, 1, k_coarsest});
    } else if (sizes.geometry) {
      all.push_back({id, "geometry", fixed, 1, k_smallest});
    }
  }
  return all;
}

/// What reading the case says of a value that came from --law.
std::string as_asked(const std::string& id, const std::string& message) {
  const std::string set = "--set: models.scaling";
  return message.starts_with(set) ? "--law " + id + message.substr(set.size()) : message;
}

Strategy refused(const LawChoice& law, const std::string& why) {
  Strategy strategy{.law = law, .error = why, .factors = {}, .groups = {}, .warnings = {}};
  return strategy;
}

Strategy proposal(const CaseAsTyped& typed, const Knob& knob, double wanted, Comparison& comparison) {
  const std::string because = fmt::format("for {:.4g} times fewer particle-steps", wanted);
  const auto speedup = [&](double value) { return speedup_of(typed, at(knob, value, because), comparison.particle_steps); };
  double from = std::log(knob.from), to = std::log(knob.to);
  // A law may have no bed at the far end; what it does have lies nearer.
  const double furthest = speedup(knob.to);
  if (furthest < wanted)
    return refused(at(knob, knob.to, because),
                   fmt::format("with {} = {:.4g} the speed-up is {:.3g}, and {:.4g} is out of reach.", knob.name, knob.to,
                               furthest, wanted));
  while (std::abs(to - from) > k_reached_within) {
    const double middle = 0.5 * (from + to);
    (speedup(std::exp(middle)) < wanted ? from : to) = middle;
  }
  return audited_strategy(typed, at(knob, std::exp(to), because), comparison);
}

}  // namespace

ScalingAudit audit_of(const Assembly& assembly, const Catalogue& catalogue, double gas_fraction_at_minimum) {
  Drags drags = drags_of(assembly, catalogue);
  drags.of_real = sphere_drag(drags.real, sphere_in_gas(describe(assembly.real)),
                              std::cbrt(assembly.real.cell[0] * assembly.real.cell[1] * assembly.real.cell[2]));
  const AuditedBed real = audited(assembly.real, drags.of_real), simulated = audited(assembly.model, drags.of_simulated);
  ScalingAudit audit{.groups = compare_groups(real, simulated, gas_fraction_at_minimum), .warnings = {}, .legend = {}};
  audit.legend = group_legend(real, audit.groups, gas_fraction_at_minimum);
  audit.warnings = audit_warnings(real, simulated, audit.groups);
  return audit;
}

LawChoice law_from_text(const std::string& text) {
  const auto wrong = [&](const std::string& why) {
    return InputError("--law " + text + ": " + why, "Write for example --law link:n=2 or --law similarity:geometry=0.5,n=1.");
  };
  const std::size_t colon = text.find(':');
  const std::string id = text.substr(0, colon);
  if (id.empty()) throw wrong("the id of a scaling law is missing.");
  std::vector<std::pair<std::string, std::string>> parameters;
  std::size_t begin = colon == std::string::npos ? text.size() : colon + 1;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == part.size())
      throw wrong("\"" + part + "\" is not of the form parameter=value.");
    parameters.emplace_back(part.substr(0, equals), part.substr(equals + 1));
    begin = end + 1;
  }
  return law_with(id, parameters, k_asked_for);
}

std::vector<LawChoice> default_laws(const CaseAsTyped& typed, std::vector<std::string>& left_out) {
  const CaseFile own = read_case(typed.file, typed.catalogue, typed.overrides);
  const ModelChoice& scaling = own.scene.models.scaling;
  std::vector<LawChoice> laws{{scaling.id, "", given_parameters(scaling), "the case's own"}};
  const double gas_fraction = gas_fraction_at_minimum(own.scene);
  for (const std::string& id : typed.catalogue.ids("scaling")) {
    if (id == scaling.id) continue;
    const similitude_descriptor& law = *typed.catalogue.find("scaling", id)->descriptor;
    const Sizes sizes = required_sizes(law);
    if (!sizes.unknown.empty()) {
      left_out.push_back(id + ": say its " + sizes.unknown + ", for example --law " + id + ":" + example_of_law(law));
      continue;
    }
    std::vector<std::pair<std::string, std::string>> parameters;
    if (sizes.geometry) parameters.emplace_back("geometry", fmt::format("{}", k_default_geometry));
    if (sizes.n)
      parameters.emplace_back("n", fmt::format("{}", k_default_coarsening * (sizes.geometry ? k_default_geometry : 1)));
    LawChoice choice = law_with(id, parameters, "by default");
    pass_gas_fraction(law, gas_fraction, parameters);
    choice.scaling = with_parameters(id, parameters);
    laws.push_back(choice);
  }
  return laws;
}

Comparison compare_laws(const CaseAsTyped& typed, const std::vector<LawChoice>& laws) {
  Comparison comparison = started(typed);
  comparison.gas_fraction_at_minimum = gas_fraction_told(typed, laws).value_or(comparison.gas_fraction_at_minimum);
  for (const LawChoice& law : laws) {
    try {
      comparison.strategies.push_back(audited_strategy(typed, law, comparison));
    } catch (const InputError& error) {
      if (law.because == k_asked_for) throw InputError(as_asked(law.id, error.what()));
      comparison.strategies.push_back(refused(law, error.what()));
    }
  }
  return comparison;
}

Comparison propose(const CaseAsTyped& typed, double speedup) {
  if (!(speedup > 1) || !std::isfinite(speedup))
    throw InputError(fmt::format("--speedup {:.4g}: the real bed itself is that fast.", speedup),
                     "Give a number above 1, for example --speedup 20.");
  Comparison comparison = started(typed);
  for (const Knob& knob : knobs(typed.catalogue, comparison.gas_fraction_at_minimum)) {
    try {
      comparison.strategies.push_back(proposal(typed, knob, speedup, comparison));
    } catch (const InputError& error) {
      comparison.strategies.push_back(refused({knob.id, "", "", ""}, error.what()));
    }
  }
  const auto losses = [](const Strategy& s) {
    return std::count_if(s.groups.begin(), s.groups.end(), [](const GroupComparison& g) { return !g.kept; });
  };
  std::stable_sort(comparison.strategies.begin(), comparison.strategies.end(), [&](const Strategy& a, const Strategy& b) {
    return a.error.empty() != b.error.empty() ? a.error.empty() : losses(a) < losses(b);
  });
  comparison.strategies.insert(comparison.strategies.begin(),
                               audited_strategy(typed, {"exact", "exact", "", "to compare with"}, comparison));
  return comparison;
}

}  // namespace similitude
