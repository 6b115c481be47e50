#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/text_table.h"
#include "loader/json_text.h"
#include "loader/number_text.h"
#include "particles/bed_file.h"
#include "stepper/bed_numbers.h"
#include "stepper/inspection.h"
#include "stepper/prediction.h"

namespace similitude::app {
namespace {

constexpr double k_shown_share = 0.02;   // stages that cost less are not worth a line

struct CheckArguments {
  std::string case_file;
  std::vector<std::string> overrides;
  int threads = 0;
  bool json = false;
};

/// All that is known of a case before it runs.
struct Inspection {
  Assembly assembly;
  TimeSteps steps;
  std::vector<std::string> pipeline;
  std::vector<FieldUse> fields;
  std::vector<PairUse> pairs;
  std::vector<EffectVerdict> effects;
  PredictedCost cost;
  BedNumbers bed;
};

const char* verdict_word(int verdict) {
  if (verdict == 1) return "needed";
  return verdict == 0 ? "negligible" : "cannot tell";
}

nlohmann::json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json as_json(const BedNumbers& bed) {
  nlohmann::json page{{"classes", nlohmann::json::array()},
                      {"weight_Pa", bed.pressure},
                      {"height_m", bed.height},
                      {"cell_per_diameter", bed.cell_over_diameter}};
  for (const ClassNumbers& one : bed.classes)
    page["classes"].push_back({{"name", one.name},
                               {"count", one.count},
                               {"u_mf_m_per_s", number_or_null(one.minimum_fluidisation)},
                               {"u_t_m_per_s", number_or_null(one.terminal_velocity)}});
  return page;
}

nlohmann::json as_json(const Inspection& seen) {
  const double to_real = 1 / seen.assembly.results.time;
  nlohmann::json page;
  page["pipeline"] = seen.pipeline;
  page["fields"] = nlohmann::json::array();
  for (const FieldUse& field : seen.fields) {
    page["fields"].push_back(
        {{"name", field.name}, {"bytes_per_item", field.bytes_per_item}, {"items", field.items}, {"because", field.because}});
  }
  for (const PairUse& pair : seen.pairs) {
    nlohmann::json& one = page["contact_pairs"][pair.pair] = nlohmann::json::object();
    for (const auto& [name, value] : pair.parameters) one[name] = value;
  }
  page["bed"] = as_json(seen.bed);
  page["time_steps"] = {{"dt", seen.steps.dt * to_real},
                        {"gas_dt", seen.steps.gas_dt() * to_real},
                        {"limits", nlohmann::json::array()}};
  for (const TimeStepLimit& limit : seen.steps.limits) {
    page["time_steps"]["limits"].push_back({{"name", limit.name},
                                            {"step", limit.kind == StepKind::gas ? "gas_dt" : "dt"},
                                            {"advised", number_or_null(limit.advised * to_real)},
                                            {"hard", number_or_null(limit.hard * to_real)},
                                            {"binding", limit.binding},
                                            {"because", limit.because},
                                            {"hard_because", limit.hard_because}});
  }
  page["effects"] = nlohmann::json::array();
  for (const EffectVerdict& effect : seen.effects) {
    page["effects"].push_back({{"id", effect.id},
                               {"group", effect.group},
                               {"value", number_or_null(effect.value)},
                               {"threshold", number_or_null(effect.threshold)},
                               {"verdict", verdict_word(effect.verdict)},
                               {"because", effect.because},
                               {"range", {number_or_null(effect.lowest), number_or_null(effect.highest)}},
                               {"source", effect.source},
                               {"chosen", effect.chosen},
                               {"predicted_wall_s", number_or_null(effect.predicted_wall_s)}});
  }
  page["predicted"] = {{"particle_steps", seen.cost.particle_steps},
                       {"threads", seen.cost.threads},
                       {"wall_s", number_or_null(seen.cost.wall_s)},
                       {"stages", nlohmann::json::array()}};
  for (const StageTime& stage : seen.cost.stages)
    page["predicted"]["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}});
  return page;
}

template <class Bed>
std::string bed_line(const Scene<Bed>& scene, const TimeSteps& steps, double time_ratio) {
  std::string line = fmt::format("{:.4g} x {:.4g} x {:.4g} mm, gas {:.4g} kg/m^3 and {:.4g} Pa s, dt {:.3g} s", 1e3 * scene.size[0],
                                 1e3 * scene.size[1], 1e3 * scene.size[2], scene.gas_density, scene.gas_viscosity,
                                 steps.dt / time_ratio);
  for (const ParticleClass& species : scene.particles) {
    line += fmt::format(", {} {:.4g} mm and {:.4g} kg/m^3", species.name, 1e3 * species.diameter, species.density);
    if (species.count) line += fmt::format(" x {}", *species.count);
    if (species.rows) line += fmt::format(" x {} of the file", species.rows->count);
  }
  return line;
}

void print(const Inspection& seen, std::ostream& out) {
  const double to_real = 1 / seen.assembly.results.time;
  out << seen.assembly.real.title << "\n";
  out << "  real bed       " << bed_line(seen.assembly.real, seen.steps, seen.assembly.results.time) << "\n";
  out << "  simulated bed  " << bed_line(seen.assembly.model, seen.steps, 1) << "\n";
  if (!seen.bed.classes.empty()) out << "  bed            " << in_words(seen.bed) << "\n";
  if (!seen.pairs.empty()) out << "\ncontacts by pairs of materials, where they differ (real bed)\n";
  for (const PairUse& pair : seen.pairs) {
    out << fmt::format("  {:<30}", pair.pair);
    for (const auto& [name, value] : pair.parameters) out << fmt::format("  {} {}", name, value);
    out << "\n";
  }
  out << "\npipeline of a gas step\n";
  for (const std::string& pass : seen.pipeline) out << "  " << pass << "\n";
  out << fmt::format("\n{:<36}{:>10}{:>12}  {}\n", "field", "bytes/item", "items", "because");
  for (const FieldUse& field : seen.fields) {
    out << fmt::format("{:<36}{:>10}{:>12}  {}\n", field.name, field.bytes_per_item, field.items, field.because);
  }
  out << fmt::format("\ntime steps of the real bed: dt {:.4g} s, {} per gas step\n", seen.steps.dt * to_real, seen.steps.sub_steps);
  out << fmt::format("{:<32}{:>12}{:>12}   {}\n", "limit", "advised [s]", "hard [s]", "because");
  for (const TimeStepLimit& limit : seen.steps.limits) {
    out << fmt::format("{:<32}{:>12.3g}{:>12.3g} {} {}\n", limit.name, limit.advised * to_real, limit.hard * to_real,
                       limit.binding ? "*" : " ", limit.because + (limit.hard_because.empty() ? "" : "; hard: " + limit.hard_because));
  }
  out << fmt::format("\n{:<24}{:<14}{:<9}{:>10}  {}\n", "effect", "verdict", "in case", "price [s]", "because");
  if (seen.effects.empty()) out << "  no effect plugin is installed\n";
  for (const EffectVerdict& effect : seen.effects) {
    out << fmt::format("{:<24}{:<14}{:<9}{:>10}  {}\n", effect.id, verdict_word(effect.verdict), effect.chosen ? "yes" : "no",
                       std::isfinite(effect.predicted_wall_s) ? two_digits(effect.predicted_wall_s) : "-", effect.because);
  }
  out << fmt::format("\npredicted: {} particles, {:.3g} particle-steps, ", seen.cost.particles, seen.cost.particle_steps);
  if (!seen.cost.gap.empty()) {
    out << "no wall time, since the calibration stopped: " << seen.cost.gap << "\n";
    return;
  }
  out << seconds_text(seen.cost.wall_s) << fmt::format(" of wall time on this machine with {} thread{}, of which\n", seen.cost.threads, seen.cost.threads == 1 ? "" : "s");
  std::vector<StageTime> stages = seen.cost.stages;
  std::stable_sort(stages.begin(), stages.end(), [](const StageTime& a, const StageTime& b) { return a.seconds > b.seconds; });
  for (const StageTime& stage : stages)
    if (stage.seconds >= k_shown_share * seen.cost.wall_s) out << fmt::format("  {:<36}{:>10}\n", stage.name, seconds_text(stage.seconds));
}

int check(const CheckArguments& arguments) {
  const Catalogue plugins = catalogue_for(arguments.case_file);
  CaseFile case_file = read_case(arguments.case_file, plugins, arguments.overrides);
  read_bed_rows(case_file.scene);
  Inspection seen;
  seen.assembly = assemble(case_file.scene, plugins);
  seen.bed = bed_numbers(seen.assembly.real);
  seen.steps = choose_time_steps(seen.assembly);
  for (const std::string& warning : case_file.warnings) std::cerr << "warning: " << warning << "\n";
  for (const std::string& warning : warnings_of(seen.assembly, seen.steps, plugins)) std::cerr << "warning: " << warning << "\n";
  predict_with_threads(arguments.threads);
  seen.pipeline = pipeline_words(seen.assembly, seen.steps);
  seen.fields = field_uses(seen.assembly);
  seen.pairs = pair_uses(seen.assembly);
  seen.effects = effect_verdicts(case_file.scene, seen.assembly, seen.steps, plugins);
  seen.cost = predict_cost(seen.assembly, seen.steps);
  if (arguments.json) {
    std::cout << json_text(as_json(seen)) << "\n";
  } else {
    print(seen, std::cout);
  }
  return 0;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = app.add_subcommand("check", "Validate a case; print both beds, pipeline, fields, limits, effects and cost.");
  command->add_option("CASE", arguments->case_file, "case file (YAML)")->required();
  command->add_option("--set", arguments->overrides, "change a value of the case: key=value")->allow_extra_args(false);
  add_threads_option(*command, arguments->threads, "threads that the predicted time is of (default: all cores)");
  command->add_flag("--json", arguments->json, "for other programs");
  command->callback([arguments, &action] { action = [arguments] { return check(*arguments); }; });
}

}  // namespace similitude::app
