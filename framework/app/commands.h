#pragma once
/// The subcommands. Each adds itself to the command line and leaves what to do in `action`, which returns the exit status.

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "loader/catalogue.h"
#include "scene/case_file.h"

namespace similitude::app {

using Action = std::function<int()>;

void add_run(CLI::App& app, Action& action, const std::string& command_line);
void add_check(CLI::App& app, Action& action);
void add_scale(CLI::App& app, Action& action);
void add_plugins(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_study(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);

/// The plugins that a case sees: its own plugin_paths first.
Catalogue catalogue_for(const std::string& case_file);
/// The plugins that any case sees.
Catalogue catalogue();

}  // namespace similitude::app
