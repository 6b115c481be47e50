/// study.json and study.csv.

#include <cmath>
#include <nlohmann/json.hpp>

#include "loader/json_text.h"
#include "output/csv.h"
#include "output/whole_file.h"
#include "stepper/version.h"
#include "study/study.h"

namespace similitude {
namespace {

using json = nlohmann::ordered_json;

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json interval(const Estimate& e) {
  if (!e.known()) return {{"value", nullptr}, {"gap", e.gap}};
  return {{"value", number(e.value)},
          {"low", number(e.low)},
          {"high", number(e.high)},
          {"lower_bound", e.lower_bound},
          {"effective_samples", number(e.effective_samples)}};
}

json metric_json(const MetricResult& result) {
  json page = interval(result.value);
  page["unit"] = result.metric->unit;
  if (!result.metric->of_profile()) return page;
  page["bins"] = result.bins;
  page["bins_left_out"] = result.bins_left_out;
  page["heights"] = json::array();
  for (const ErrorAtHeight& height : result.heights)
    page["heights"].push_back(
        {{"z", height.z}, {"l2", interval(height.l2)}, {"difference", interval(height.difference)}});
  return page;
}

json profile_json(const Profile& profile) {
  json page{{"sampler", profile.sampler}, {"bins", json::array()}};
  for (const ProfileBin& bin : profile.bins)
    page["bins"].push_back({{"x", bin.x},
                            {"z", bin.z},
                            {"mean", number(bin.mean)},
                            {"standard_error", number(bin.standard_error)},
                            {"blocks", number(bin.blocks)}});
  return page;
}

json stages_json(const RunTiming& timing) {
  json list = json::array();
  for (const RunTiming::Stage& stage : timing.stages)
    list.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"share", stage.share}});
  return list;
}

json prediction_json(const StudyCase& one) {
  if (!one.predicted.known()) return {{"wall_s", nullptr}, {"gap", one.predicted.gap}};
  json page{{"wall_s", one.predicted.wall_s},
            {"particle_steps", one.predicted.particle_steps},
            {"farthest_off", farthest_off(one.predicted, one.timing)},
            {"stages", json::array()}};
  for (const RunTiming::Stage& stage : one.predicted.stages) page["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}});
  return page;
}

json case_json(const StudyPlan& plan, const StudyCase& one, std::size_t index) {
  const bool planned = index < plan.cases.size();
  json page{{"name", one.name},
            {"folder", planned ? one.name : plan.study.reference.path.string()},
            {"reference", one.reference}};
  page["settings"] = json::object();
  if (planned)
    for (const Setting& setting : plan.cases[index].settings) page["settings"][setting.path] = setting.value;
  page["status"] = one.status;
  page["reason"] = one.reason;
  page["particles"] = one.particles;
  page["pareto"] = one.pareto;
  page["wall_s"] = number(one.wall_s);
  page["wall_s_repeats"] = one.repeats;
  page["extrapolated_from_s"] = one.extrapolated_from > 0 ? json(one.extrapolated_from) : json(nullptr);
  page["simulated_s"] = one.timing.simulated_s;
  page["particle_steps"] = one.timing.particle_steps;
  page["particle_steps_per_s"] = one.timing.particle_steps_per_s;
  page["peak_memory_bytes"] = number(one.peak_memory_bytes);
  page["stages"] = stages_json(one.timing);
  page["predicted"] = prediction_json(one);
  page["state_hash"] = one.state_hash.empty() ? json(nullptr) : json(one.state_hash);
  page["metrics"] = json::object();
  page["error"] = json::object();
  for (const MetricResult& result : one.results) {
    page["metrics"][result.metric->name] = metric_json(result);
    page["error"][result.metric->name] = interval(result.error);
  }
  page["profiles"] = json::array();
  for (const Profile& profile : one.profiles) page["profiles"].push_back(profile_json(profile));
  return page;
}

json reference_json(const StudyPlan& plan) {
  const StudyReference& reference = plan.study.reference;
  json page{{"name", plan.reference_name()}};
  page["kind"] = reference.kind == ReferenceKind::one_of_the_cases ? "case"
                 : reference.kind == ReferenceKind::stored_run     ? "run"
                                                                   : "data";
  if (reference.kind != ReferenceKind::one_of_the_cases) page["path"] = reference.path.string();
  page["profiles"] = json::array();  // of measured data; those of a run stand at its case
  if (reference.kind == ReferenceKind::measured_data)
    for (const Profile& profile : plan.outside->profiles) page["profiles"].push_back(profile_json(profile));
  return page;
}

json study_json(const StudyPlan& plan, const StudyResult& result) {
  json page;
  page["similitude_study"] = k_study_version;
  page["program"] = {{"name", "similitude"}, {"version", program_version()}};
  page["title"] = plan.study.title;
  page["study_file"] = plan.study.file.string();
  page["base"] = plan.study.base.string();
  page["machine"] = {
      {"processor", result.machine.processor}, {"cores", result.machine.cores}, {"kernel", result.machine.kernel}};
  page["threads"] = plan.study.threads > 0 ? plan.study.threads : result.machine.cores;
  page["smoothing_m"] = plan.smoothing ? json(*plan.smoothing) : json(nullptr);
  page["reference"] = reference_json(plan);
  page["metrics"] = json::array();
  for (const Metric* metric : plan.study.metrics)
    page["metrics"].push_back(
        {{"name", metric->name}, {"unit", metric->unit}, {"source", metric->source}, {"doc", metric->doc}});
  page["axes"] = json::array();
  for (const StudyAxis& axis : plan.study.axes) page["axes"].push_back(axis.path);
  page["cases"] = json::array();
  for (std::size_t k = 0; k < result.cases.size(); ++k) page["cases"].push_back(case_json(plan, result.cases[k], k));
  json steps = json::array();
  for (const FrontierStep& step : result.frontier.steps)
    steps.push_back({{"from", step.from},
                     {"to", step.to},
                     {"time_ratio", step.time_ratio},
                     {"error_change", step.error_change},
                     {"distinguishable", step.distinguishable}});
  page["frontier"] = {{"metric", plan.study.metrics.front()->name}, {"cases", result.frontier.cases}, {"steps", steps}};
  page["indistinguishable"] = json::object();
  for (std::size_t m = 0; m < plan.study.metrics.size(); ++m)
    page["indistinguishable"][plan.study.metrics[m]->name] = result.indistinguishable[m];
  page["orders"] = json::array();
  for (const StudyOrder& order : result.orders)
    page["orders"].push_back(
        {{"axis", order.axis}, {"metric", order.metric}, {"cases", order.cases}, {"order", interval(order.order)}});
  page["advice"] = result.advice;
  return page;
}

void write_csv(const StudyPlan& plan, const StudyResult& result, const std::filesystem::path& folder) {
  std::vector<std::string> columns{"case",           "status",   "reference",          "pareto",
                                   "particles",      "wall [s]", "particle_steps [1]", "particle_steps_per_s [1/s]",
                                   "peak_memory [B]"};
  for (const Metric* metric : plan.study.metrics)
    for (const std::string& part :
         {std::string(metric->name) + " [" + metric->unit + "]", std::string(metric->name) + " error [1]",
          std::string(metric->name) + " error low [1]", std::string(metric->name) + " error high [1]",
          std::string(metric->name) + " lower bound"})
      columns.push_back(part);
  const std::filesystem::path part = folder / "study.csv.part";
  {
    CsvWriter csv(part, columns);
    for (const StudyCase& one : result.cases) {
      std::vector<std::string> row{one.name,
                                   one.status,
                                   one.reference ? "true" : "false",
                                   one.pareto ? "true" : "false",
                                   std::to_string(one.particles),
                                   csv_number(one.wall_s),
                                   csv_number(one.timing.particle_steps),
                                   csv_number(one.timing.particle_steps_per_s),
                                   csv_number(one.peak_memory_bytes)};
      for (std::size_t m = 0; m < plan.study.metrics.size(); ++m) {
        const MetricResult none{
            .metric = plan.study.metrics[m], .value = gap("not run"), .error = gap("not run"), .heights = {}};
        const MetricResult& of = m < one.results.size() ? one.results[m] : none;
        for (const double value : {of.value.value, of.error.value, of.error.low, of.error.high})
          row.push_back(csv_number(value));
        row.push_back(of.error.known() ? (of.error.lower_bound ? "true" : "false") : "");
      }
      csv.row_of_text(row);
    }
  }
  std::error_code error;
  std::filesystem::rename(part, folder / "study.csv", error);
  if (error) throw_output_error(folder / "study.csv", "written", error.value());
}

}  // namespace

void write_study(const StudyPlan& plan, const StudyResult& result, const std::filesystem::path& folder) {
  write_csv(plan, result, folder);
  write_whole_file(folder / "study.json", json_text(study_json(plan, result)) + "\n");
}

}  // namespace similitude
