#pragma once
/// The command line's own errors, in the words of the others.

#include <string>

#include <CLI/CLI.hpp>

namespace similitude::app {

/// What is wrong with what was typed and, on an indented line, what to type instead. After `app.parse` threw `error`.
std::string command_line_error(CLI::App& app, const CLI::ParseError& error, int argc, char** argv);

/// --threads N, 1 or more; `threads` stays as it is without it.
void add_threads_option(CLI::App& command, int& threads, const std::string& doc);

}  // namespace similitude::app
