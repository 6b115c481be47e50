#include "study/study.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "output/checkpoint_file.h"
#include "output/whole_file.h"
#include "scene/case_file.h"
#include "scene/messages.h"
#include "scene/units.h"
#include "stepper/prediction.h"
#include "stepper/resume.h"
#include "stepper/stop_signal.h"
#include "study/child_run.h"
#include "study/leg.h"
#include "study/observed_order.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;

constexpr int k_exit_of_signal = 128;  // shells' convention
constexpr double k_rounding = 1e-9;    // relative, of times that were written and read
constexpr const char* k_log_file = "run.log";
constexpr const char* k_leg_folder = "leg";  // in the folder of a case
constexpr const char* k_reference_leg_folder = "reference_leg";

// --------------------------------------------------------------------------------------------------------- running

/// What a case's folder holds. Only what is worth nothing is written over.
enum class Earlier { nothing, half_finished, finished };

/// Throws InputError for a run of another case that was finished or could go on; of one that a guard stopped nothing more
/// comes.
Earlier earlier_run(const fs::path& folder, const PlannedCase& planned) {
  const bool can_go_on = !checkpoints_in(folder / k_checkpoint_folder).empty();
  const Earlier unfinished = can_go_on ? Earlier::half_finished : Earlier::nothing;
  if (!has_manifest(folder)) return unfinished;
  const RunManifest manifest = read_manifest(folder);
  const bool at_the_end = manifest.done() && manifest.simulated_s >= planned.end * (1 - k_rounding);
  std::string differences = case_differences(manifest.identity, planned.identity);
  if (manifest.end > planned.end * (1 + k_rounding))
    differences += fmt::format("\n    time.end: was {:.6g} s, is {:.6g} s", manifest.end, planned.end);
  if (manifest.done() && !at_the_end && !can_go_on)
    differences += fmt::format("\n    time.end: was run to {:.6g} s without a checkpoint to go on from, is {:.6g} s",
                               manifest.simulated_s, planned.end);
  if (differences.empty()) return at_the_end ? Earlier::finished : unfinished;
  if (!manifest.done() && (!can_go_on || manifest.status == "stopped")) return Earlier::nothing;
  throw InputError(folder.string() + " holds a run of another case:" + differences,
                   "Give another folder with -o, or remove that one to have the case run anew.");
}

std::vector<std::string> arguments_of(const StudyPlan& plan, const PlannedCase& planned, const fs::path& folder) {
  std::vector<std::string> arguments{"run", plan.study.base.string(), "-o", folder.string()};
  for (const std::string& assignment : planned.overrides) {
    arguments.push_back("--set");
    arguments.push_back(assignment);
  }
  if (plan.study.threads > 0) {
    arguments.push_back("--threads");
    arguments.push_back(std::to_string(plan.study.threads));
  }
  return arguments;
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.2g} GB", bytes / 1e9);
}

fs::path make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_output_error(folder, "made", error.value());
  return folder;
}

/// Short runs again, for their time only: results of the same case are the same bits.
void repeat_if_short(const StudyPlan& plan, const PlannedCase& planned, const fs::path& folder, Cost& cost) {
  const fs::path again = folder / "repeat";
  while (cost.repeats.front() < plan.study.short_run && static_cast<int>(cost.repeats.size()) < plan.study.repeats &&
         StopSignal::received() == 0) {
    std::vector<std::string> arguments = arguments_of(plan, planned, again);
    arguments.push_back("--force");
    const ChildOutcome outcome = run_child(arguments, folder / k_log_file);
    if (outcome.exit_status != 0) break;
    cost.repeats.push_back(read_timing(again).wall_s);
    cost.peak_memory_bytes = std::max(cost.peak_memory_bytes, outcome.peak_memory_bytes);
  }
  std::error_code ignored;
  fs::remove_all(again, ignored);
}

/// Settles the bed for the run as well, where it is small or kept already.
Prediction predict(const fs::path& case_file, const std::vector<std::string>& overrides, int threads, const Catalogue& catalogue) {
  omp_set_num_threads(threads > 0 ? threads : omp_get_num_procs());
  Prediction predicted;
  try {
    const CaseFile file = read_case(case_file, catalogue, overrides);
    const Assembly assembly = assemble(file.scene, catalogue);
    const PredictedCost cost = predict_cost(assembly, choose_time_steps(assembly));
    predicted.gap = cost.gap;
    predicted.wall_s = cost.wall_s;
    predicted.particle_steps = cost.particle_steps;
    for (const StageTime& stage : cost.stages) predicted.stages.push_back({stage.name, stage.seconds});
  } catch (const std::exception& error) {  // the run will say it in its place
    predicted.gap = error.what();
  }
  return predicted;
}

/// What was run elsewhere, or in parts on several machines, says nothing of this one's speed.
std::string time_here(const StudyPlan& plan, const Catalogue& catalogue, const fs::path& run, const fs::path& leg) {
  if (!(plan.study.leg > 0)) return "its time on this machine is not known (leg: 10 ms would time it)";
  const std::string how = run_leg(run, leg, plan.study.leg, plan.study.threads);
  Cost cost = read_cost(leg);
  if (StopSignal::received() == 0 && read_leg(run, leg) && !cost.predicted.known()) {
    cost.predicted = predict(case_of_leg(leg), {}, plan.study.threads, catalogue);
    write_cost(leg, cost);
  }
  return "a short leg of it here: " + how;
}

/// A line that says how it ended.
std::string run_one(const StudyPlan& plan, const PlannedCase& planned, const Catalogue& catalogue, const fs::path& folder) {
  const Earlier earlier = earlier_run(folder, planned);
  if (earlier == Earlier::finished)
    return timed_here(folder) ? "was done before" : "was done elsewhere; " + time_here(plan, catalogue, folder, folder / k_leg_folder);
  make_folder(folder);
  const Prediction predicted = predict(plan.study.base, planned.overrides, plan.study.threads, catalogue);
  if (StopSignal::received() != 0) return "interrupted";
  std::error_code ignored;
  remove_cost(folder);
  bool resumed = earlier == Earlier::half_finished;
  const bool begun_here = !resumed || (has_manifest(folder) && made_here(read_manifest(folder)));
  std::vector<std::string> arguments = arguments_of(plan, planned, folder);
  arguments.push_back(resumed ? "--resume" : "--force");
  if (!resumed) fs::remove(folder / k_log_file, ignored);
  ChildOutcome outcome = run_child(arguments, folder / k_log_file);
  if (outcome.exit_status != 0 && resumed && earlier_run(folder, planned) == Earlier::nothing) {
    resumed = false;  // no checkpoint could be read: the run has set all of them aside
    arguments.back() = "--force";
    outcome = run_child(arguments, folder / k_log_file);
  }
  if (StopSignal::received() != 0) return "interrupted";
  if (outcome.exit_status != 0) {
    const std::string error = last_error_in(folder / k_log_file);
    return fmt::format("failed with exit status {}{}{}", outcome.exit_status,
                       error.empty() ? ", see " + (folder / k_log_file).string() : ": ", error);
  }
  Cost cost{.repeats = {read_timing(folder).wall_s}, .peak_memory_bytes = outcome.peak_memory_bytes, .predicted = predicted};
  repeat_if_short(plan, planned, folder, cost);
  if (StopSignal::received() != 0) return "interrupted";
  if (!begun_here) return "was begun elsewhere; " + time_here(plan, catalogue, folder, folder / k_leg_folder);
  write_cost(folder, cost);
  return fmt::format("{:.3g} s{}, {} particles, {}", cost.repeats.front(), resumed ? " since it was resumed" : "",
                     read_manifest(folder).particles, memory_text(cost.peak_memory_bytes));
}

// --------------------------------------------------------------------------------------------------------- judging

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// Of a whole run at the speed of a short one.
void take_leg(StudyCase& one, const Leg& leg, const fs::path& folder) {
  one.timing = leg.whole_run;
  one.extrapolated_from = leg.simulated_s;
  one.wall_s = leg.whole_run.wall_s;
  one.repeats = {one.wall_s};
  one.peak_memory_bytes = leg.peak_memory_bytes;
  one.predicted = read_cost(folder).predicted;
}

void read_cost_into(StudyCase& one, const fs::path& folder) {
  one.timing = read_timing(folder);
  if (!timed_here(folder)) {
    if (const auto leg = read_leg(folder, folder / k_leg_folder)) take_leg(one, *leg, folder / k_leg_folder);
    return;
  }
  const Cost cost = read_cost(folder);
  one.repeats = cost.repeats.empty() ? std::vector<double>{one.timing.wall_s} : cost.repeats;
  one.wall_s = median(one.repeats);
  one.peak_memory_bytes = cost.peak_memory_bytes;
  one.predicted = cost.predicted;
}

StudyCase read_case_of(const PlannedCase& planned, const fs::path& folder) {
  StudyCase one;
  one.name = planned.name;
  one.status = "not run";
  one.reason = "it was not run";
  if (!has_manifest(folder)) {
    if (const std::string error = last_error_in(folder / k_log_file); !error.empty()) {
      one.status = "failed";
      one.reason = error;
    }
    return one;
  }
  const RunManifest manifest = read_manifest(folder);
  one.status = manifest.status;
  one.particles = manifest.particles;
  one.done = earlier_run(folder, planned) == Earlier::finished;
  one.reason = one.done ? "" : manifest.exit_reason;
  if (one.done) {
    one.state_hash = manifest.state_hash;
    read_cost_into(one, folder);
  } else if (manifest.done()) {
    one.status = "not run";
    one.reason = "it was not run to its end";
  }
  return one;
}

/// The stored run among the cases: its error is nought, its time what this machine needs for it, where that is known.
StudyCase stored_reference(const StudyPlan& plan, const fs::path& folder) {
  const fs::path run = plan.study.reference.path;
  StudyCase one;
  one.name = plan.reference_name();
  one.reference = one.done = true;
  one.status = "done";
  one.particles = plan.stored->particles;
  one.timing = read_timing(run);
  one.state_hash = plan.stored->state_hash;
  if (plan.outside) one.profiles = plan.outside->profiles;
  if (const auto leg = read_leg(run, folder / k_reference_leg_folder)) {
    take_leg(one, *leg, folder / k_reference_leg_folder);
  } else if (timed_here(run)) {
    one.wall_s = one.timing.wall_s;
    one.repeats = {one.wall_s};
  }
  return one;
}

/// The reference against itself: its own values, and no error.
void clear_errors(MetricResult& result) {
  if (result.metric->kind == MetricKind::residual) return;
  result.error = exactly(0);
  if (result.metric->of_profile()) result.value = exactly(0);
  result.heights.clear();
}

std::vector<Contender> contenders_of(const std::vector<StudyCase>& cases, std::size_t metric) {
  std::vector<Contender> contenders;
  for (const StudyCase& one : cases)
    contenders.push_back({one.name, one.done ? one.wall_s : Estimate::k_unknown,
                          one.done ? one.results[metric].error : gap(one.reason), one.reference});
  return contenders;
}

std::string in_words(const Metric& metric) {
  std::string text = metric.name;
  std::replace(text.begin(), text.end(), '_', ' ');
  return metric.kind == MetricKind::residual ? text : text + " error";
}

/// Cases that differ in one axis alone, for every choice of the others.
std::vector<std::vector<std::size_t>> lines_along(const StudyPlan& plan, const std::string& axis) {
  std::vector<std::vector<std::size_t>> lines;
  std::vector<std::string> keys;
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    std::string key;
    for (const Setting& setting : plan.cases[k].settings)
      if (setting.path != axis) key += setting.assignment() + "\n";
    const auto place = static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
    if (place == keys.size()) {
      keys.push_back(key);
      lines.emplace_back();
    }
    lines[place].push_back(k);
  }
  return lines;
}

void find_orders(const StudyPlan& plan, StudyResult& result) {
  for (const StudyAxis& axis : plan.study.axes) {
    const bool dt = axis.path == "time.dt";
    if (!dt && axis.path != "scene.domain.cell") continue;
    const auto step = [&](std::size_t k) { return dt ? plan.cases[k].dt : plan.cases[k].cell; };
    for (std::vector<std::size_t> line : lines_along(plan, axis.path)) {
      std::sort(line.begin(), line.end(), [&](std::size_t a, std::size_t b) { return step(a) > step(b); });
      for (std::size_t m = 0; m < plan.study.metrics.size(); ++m) {
        if (plan.study.metrics[m]->kind == MetricKind::residual) continue;
        double reference_step = 0;
        std::vector<OrderPoint> points;
        StudyOrder order{.axis = axis.path, .metric = plan.study.metrics[m]->name, .cases = {}, .order = {}};
        for (const std::size_t k : line) {
          order.cases.push_back(plan.cases[k].name);
          if (result.cases[k].reference)
            reference_step = step(k);
          else if (result.cases[k].done)
            points.push_back({step(k), result.cases[k].results[m].error});
        }
        order.order = observed_order(points, reference_step);
        result.orders.push_back(std::move(order));
      }
    }
  }
}

}  // namespace

bool holds_a_study(const fs::path& folder, const StudyPlan& plan) {
  if (fs::exists(folder / "study.json")) return true;
  return std::any_of(plan.cases.begin(), plan.cases.end(),
                     [&](const PlannedCase& one) { return has_manifest(folder / one.name); });
}

int run_cases(const StudyPlan& plan, const Catalogue& catalogue, const fs::path& folder, const std::function<void(const std::string&)>& say) {
  for (const PlannedCase& planned : plan.cases) earlier_run(folder / planned.name, planned);  // refuses another case's
  make_folder(folder);
  const StopSignal stop_signal;
  if (plan.stored && plan.study.leg > 0)
    say("reference, " + time_here(plan, catalogue, plan.study.reference.path, folder / k_reference_leg_folder));
  for (std::size_t k = 0; k < plan.cases.size() && StopSignal::received() == 0; ++k) {
    const PlannedCase& planned = plan.cases[k];
    say(fmt::format("{}/{} {}: {}", k + 1, plan.cases.size(), planned.name,
                    run_one(plan, planned, catalogue, folder / planned.name)));
  }
  return StopSignal::received() == 0 ? 0 : k_exit_of_signal + StopSignal::received();
}

StudyResult evaluate(const StudyPlan& plan, const fs::path& folder) {
  StudyResult result;
  result.machine = this_machine();
  std::vector<Observations> seen(plan.cases.size());
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    result.cases.push_back(read_case_of(plan.cases[k], folder / plan.cases[k].name));
    StudyCase& one = result.cases.back();
    one.reference = plan.reference_case == k;
    if (!one.done) continue;
    seen[k] = read_observations(folder / one.name, plan.cases[k].from);
    one.profiles = seen[k].profiles;
  }
  const Observations* reference = nullptr;
  if (plan.outside) reference = &*plan.outside;
  if (plan.reference_case && result.cases[*plan.reference_case].done) reference = &seen[*plan.reference_case];
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    if (!result.cases[k].done) continue;
    for (const Metric* metric : plan.study.metrics)
      result.cases[k].results.push_back(measure(*metric, seen[k], reference));
  }
  if (plan.stored) {
    result.cases.push_back(stored_reference(plan, folder));
    for (const Metric* metric : plan.study.metrics)
      result.cases.back().results.push_back(measure(*metric, *plan.outside, reference));
  }
  for (StudyCase& one : result.cases)
    if (one.reference)
      for (MetricResult& metric : one.results) clear_errors(metric);

  const std::vector<Contender> contenders = contenders_of(result.cases, 0);
  result.frontier = frontier_of(contenders);
  for (StudyCase& one : result.cases) one.pareto = result.frontier.holds(one.name);
  for (std::size_t m = 0; m < plan.study.metrics.size(); ++m)
    result.indistinguishable.push_back(indistinguishable(contenders_of(result.cases, m)));
  find_orders(plan, result);
  result.advice = reference == nullptr ? "The reference " + plan.reference_name() +
                                             " did not finish, so there is nothing to compare with."
                                       : advice(contenders, in_words(*plan.study.metrics.front()));
  return result;
}

}  // namespace similitude
