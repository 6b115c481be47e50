#include "study/study.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>

#include "app/commands.h"
#include "app/text_table.h"
#include "app/write_report_after.h"
#include "loader/number_text.h"
#include "scene/messages.h"

namespace similitude::app {
namespace {

struct StudyArguments {
  std::string study_file, folder;
  bool resume = false;
};

constexpr int k_some_case_failed = 1;

/// "6.1 ± 4 %" of errors; "-" where there is a gap.
std::string error_cell(const StudyCase& one, std::size_t metric) {
  if (metric >= one.results.size() || !one.results[metric].error.known()) return "-";
  if (one.reference && one.results[metric].metric->kind != MetricKind::residual) return "reference";
  if (one.results[metric].metric->kind == MetricKind::residual)
    return fmt::format("{:.1e}", one.results[metric].error.value);
  return percent_text(one.results[metric].error);
}

/// Metrics on top of each other: a terminal is narrow, and there may be ten.
Table table_of(const StudyPlan& plan, const StudyResult& result) {
  Table table{{"case", "", "time", "particles", "steps/s"}};
  for (std::size_t m = 0; m < plan.study.metrics.size(); ++m) table[0].push_back(fmt::format("({})", m + 1));
  for (const StudyCase& one : result.cases) {
    std::vector<std::string> row{one.name, one.done ? (one.pareto ? "*" : "") : one.status};
    row.push_back(std::isnan(one.wall_s) ? "-" : seconds_text(one.wall_s));
    row.push_back(one.done ? std::to_string(one.particles) : "-");
    row.push_back(one.done ? fmt::format("{:.2g} M", 1e-6 * one.timing.particle_steps_per_s) : "-");
    for (std::size_t m = 0; m < plan.study.metrics.size(); ++m) row.push_back(error_cell(one, m));
    table.push_back(std::move(row));
  }
  return table;
}

void print_gaps(const StudyPlan& plan, const StudyResult& result, std::ostream& out) {
  for (const StudyCase& one : result.cases) {
    if (!one.done) out << one.name << ": " << one.status << (one.reason.empty() ? "" : ": " + one.reason) << "\n";
    for (std::size_t m = 0; m < one.results.size(); ++m)
      if (!one.results[m].error.known())
        out << one.name << ": no " << plan.study.metrics[m]->name << " error: " << one.results[m].error.gap << "\n";
  }
}

int threads_of(const StudyPlan& plan, const StudyResult& result) {
  return plan.study.threads > 0 ? plan.study.threads : result.machine.cores;
}

void print(const StudyPlan& plan, const StudyResult& result, std::ostream& out) {
  out << "\n"
      << plan.study.title << "\n"
      << result.machine.processor << ", " << threads_of(plan, result) << " threads; errors against "
      << plan.reference_name() << ", 95 % intervals; * no other case beats it in both time and (1)\n";
  for (std::size_t m = 0; m < plan.study.metrics.size(); ++m)
    out << fmt::format("  ({}) {}: {}\n", m + 1, plan.study.metrics[m]->name, plan.study.metrics[m]->doc);
  out << "\n";
  print_table(table_of(plan, result), out);
  out << "\n";
  print_gaps(plan, result, out);
  for (const FrontierStep& step : result.frontier.steps)
    out << fmt::format("{} -> {}: {} x the time, {}{} % of error{}\n", step.from, step.to,
                       two_digits(step.time_ratio), step.error_change < 0 ? "" : "+", two_digits(100 * step.error_change),
                       step.distinguishable ? "" : ", not distinguishable");
  for (const StudyOrder& order : result.orders) {
    if (order.order.known())
      out << fmt::format("order in {} by {}: {:.2g} ({:.2g} ... {:.2g})\n", order.axis, order.metric, order.order.value,
                         order.order.low, order.order.high);
    else
      out << fmt::format("order in {} by {}: {}\n", order.axis, order.metric, order.order.gap);
  }
  out << "\n" << result.advice << "\n";
}

int study(const StudyArguments& arguments) {
  const StudyFile file = read_study(arguments.study_file);
  const Catalogue plugins = catalogue_for(file.base.string());
  const StudyPlan plan = plan_study(file, plugins);
  const std::filesystem::path folder =
      arguments.folder.empty() ? std::filesystem::path("results") / file.name : std::filesystem::path(arguments.folder);
  if (!arguments.resume && holds_a_study(folder, plan))
    throw InputError(folder.string() + " holds an earlier study.",
                     "Give another folder with -o, or --resume to run only what is missing there.");
  for (const std::string& warning : plan.warnings) std::cerr << "warning: " << warning << "\n";

  std::cout << plan.study.title << "\n"
            << plan.cases.size() << " cases, one after the other; what they say is in run.log of their folders\n";
  const int interrupted = run_cases(plan, plugins, folder, [](const std::string& line) { std::cout << line << std::endl; });
  if (interrupted != 0) {
    std::cout << "\ninterrupted; go on with --resume\n";
    return interrupted;
  }
  const StudyResult result = evaluate(plan, folder);
  write_study(plan, result, folder);
  print(plan, result, std::cout);
  std::cout << "\nresults in " << folder.string() << "\n";
  write_report_after(folder);
  for (const StudyCase& one : result.cases)
    if (!one.done) return k_some_case_failed;
  return 0;
}

}  // namespace

void add_study(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand("study", "Run many cases and say what accuracy costs in time.");
  command->add_option("STUDY", arguments->study_file, "study file (YAML)")->required();
  command->add_option("-o,--output", arguments->folder, "folder for results (default: results/<study name>)");
  command->add_flag("--resume", arguments->resume,
                    "run only what is missing in the folder, half-finished cases from their checkpoints");
  command->footer("Exit status 1: a case failed; the others were run and compared.");
  command->callback([arguments, &action] { action = [arguments] { return study(*arguments); }; });
}

}  // namespace similitude::app
