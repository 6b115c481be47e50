#include <iostream>
#include <new>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/waiting_threads.h"
#include "output/whole_file.h"
#include "particles/errors.h"
#include "scene/messages.h"
#include "stepper/version.h"

namespace {

enum ExitStatus { k_done = 0, k_stopped_by_guard = 1, k_wrong_input = 2, k_plugin = 3 };

std::string as_typed(int argc, char** argv) {
  std::string line;
  for (int i = 0; i < argc; ++i) line += (i == 0 ? "" : " ") + std::string(argv[i]);
  return line;
}

int refuse(const std::exception& error, ExitStatus status) {
  std::cerr << "error: " << error.what() << "\n";
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  similitude::app::let_waiting_threads_sleep_soon(argv);
  CLI::App app("Similitude: gas-solid beds by CFD-DEM, with the scaling law as a component.", "similitude");
  app.set_version_flag("--version", std::string("similitude ") + similitude::program_version() + ", plugin ABI " +
                                        std::to_string(SIMILITUDE_ABI_MAJOR) + "." + std::to_string(SIMILITUDE_ABI_MINOR));
  app.require_subcommand(1);
  app.footer("Exit status: 0 done, 1 stopped by a guard, 2 wrong input, 3 plugin missing or refused, 130/143 interrupted.");

  similitude::app::Action action;
  similitude::app::add_run(app, action, as_typed(argc, argv));
  similitude::app::add_check(app, action);
  similitude::app::add_scale(app, action);
  similitude::app::add_study(app, action);
  similitude::app::add_report(app, action);
  similitude::app::add_plugins(app, action);
  similitude::app::add_schema(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);   // --help, --version
    std::cerr << "error: " << similitude::app::command_line_error(app, error, argc, argv) << "\n";
    return k_wrong_input;
  }

  try {
    return action();
  } catch (const similitude::InputError& error) {
    return refuse(error, k_wrong_input);
  } catch (const similitude::OutputError& error) {
    return refuse(error, k_wrong_input);
  } catch (const similitude::PluginError& error) {
    return refuse(error, k_plugin);
  } catch (const similitude::SimulationError& error) {
    return refuse(error, k_stopped_by_guard);
  } catch (const std::bad_alloc&) {
    std::cerr << "error: there is not enough memory for this case.\n  Use larger cells or fewer particles: `similitude check` prints the bytes "
                 "of each.\n";
    return k_wrong_input;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << "\n  This is a fault of the program, not of the case.\n";
    return k_stopped_by_guard;
  }
}
