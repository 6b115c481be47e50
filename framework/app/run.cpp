#include "stepper/run.h"

#include <iostream>
#include <memory>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/write_report_after.h"
#include "output/directory.h"
#include "particles/errors.h"
#include "scene/units.h"
#include "scene/messages.h"

namespace similitude::app {
namespace {

struct RunArguments {
  std::string case_file, folder, until;
  std::vector<std::string> overrides;
  int threads = 0;
  bool force = false, resume = false;
};

int run(const RunArguments& arguments, const std::string& command_line) {
  const Catalogue plugins = catalogue_for(arguments.case_file);
  const CaseFile case_file = read_case(arguments.case_file, plugins, arguments.overrides);
  RunOptions options{.folder = arguments.folder,
                     .force = arguments.force,
                     .resume = arguments.resume,
                     .until = {},
                     .threads = arguments.threads,
                     .command = command_line};
  if (!arguments.until.empty()) {
    try {
      options.until = parse_quantity(arguments.until, "s");
    } catch (const QuantityError& error) {
      throw InputError("--until: " + error.what, error.fix);
    }
  }
  const std::filesystem::path folder = results_folder(case_file, options);
  try {
    const int status = run_case(case_file, plugins, options, std::cout);
    if (holds_a_run(folder)) write_report_after(folder);   // not if a signal came before it began
    return status;
  } catch (const SimulationError&) {  // a guard: what there is until then is worth a look
    write_report_after(folder);
    throw;
  }
}

}  // namespace

void add_run(CLI::App& app, Action& action, const std::string& command_line) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Simulate a case and write its results.");
  command->add_option("CASE", arguments->case_file, "case file (YAML)")->required();
  command->add_option("-o,--output", arguments->folder, "folder for results (default: results/<case name>)");
  command->add_option("--set", arguments->overrides, "change a value of the case: key=value, e.g. models.drag=gidaspow")
      ->allow_extra_args(false);
  command->add_option("--until", arguments->until, "stop at this time of the real bed, e.g. \"0.2 s\"");
  add_threads_option(*command, arguments->threads, "threads (default: all cores); the results are the same bits");
  CLI::Option* force = command->add_flag("--force", arguments->force, "replace an earlier run in the folder");
  command->add_flag("--resume", arguments->resume, "go on from the newest checkpoint in the folder: the same results as without a break")
      ->excludes(force);
  command->callback([arguments, &action, command_line] { action = [arguments, command_line] { return run(*arguments, command_line); }; });
}

}  // namespace similitude::app
