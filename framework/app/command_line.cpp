#include "app/command_line.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include <fmt/format.h>

#include "loader/nearest_name.h"
#include "scene/section.h"

namespace similitude::app {
namespace {

std::vector<std::string> commands_of(CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> options_of(CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// "similitude plugins"
std::string in_full(const CLI::App& command) {
  return (command.get_parent() == nullptr ? "" : in_full(*command.get_parent()) + " ") + command.get_name();
}

/// Without the program's own name; "" for the program itself.
std::string words_before(const CLI::App& command) {
  return command.get_parent() == nullptr ? "" : words_before(*command.get_parent()) + command.get_name() + " ";
}

/// The deepest command that was named, and the word after it where a command should stand.
struct Named {
  CLI::App* command;
  std::string unknown;
};

Named named(CLI::App& app, int argc, char** argv) {
  Named found{&app, ""};
  for (int i = 1; i < argc && !commands_of(*found.command).empty(); ++i) {
    const std::string word = argv[i];
    if (word.starts_with('-')) continue;
    const std::vector<CLI::App*> commands = found.command->get_subcommands({});
    const auto next = std::ranges::find(commands, word, [](const CLI::App* command) { return command->get_name(); });
    if (next == commands.end()) {
      found.unknown = word;
      break;
    }
    found.command = *next;
  }
  return found;
}

std::string unknown_command(CLI::App& parent, const std::string& word) {
  const std::string before = words_before(parent), nearest = nearest_name(word, commands_of(parent));
  return fmt::format("there is no command \"{}{}\".", before, word) +
         (nearest.empty() ? fmt::format("\n  Commands of {}: {}.", in_full(parent), listed(commands_of(parent)))
                          : fmt::format(" Did you mean \"{}{}\"?", before, nearest));
}

/// Words that a command has no place for: the first that looks like an option is the likely slip of the pen.
std::string unexpected(CLI::App& command) {
  const std::vector<std::string> words = command.remaining();
  for (const std::string& word : words) {
    if (!word.starts_with('-')) continue;
    const std::string name = word.substr(0, word.find('='));
    const std::string nearest = nearest_name(name, options_of(command));
    return fmt::format("{} has no option {}.", in_full(command), name) +
           (nearest.empty() ? fmt::format("\n  Options: {}.", listed(options_of(command))) : fmt::format(" Did you mean {}?", nearest));
  }
  return fmt::format("{} has no place for \"{}\".\n  {} --help says what it takes.", in_full(command), words.empty() ? "" : words.front(),
                     in_full(command));
}

}  // namespace

std::string command_line_error(CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const auto [command, unknown] = named(app, argc, argv);
  if (!unknown.empty()) return unknown_command(*command, unknown);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return unexpected(*command);
  if (!commands_of(*command).empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    return fmt::format("a command is missing.\n  Commands of {}: {}.", in_full(*command), listed(commands_of(*command)));
  const std::string what = error.what();
  return what + (what.ends_with('.') ? "" : ".") + fmt::format("\n  {} --help says what it takes.", in_full(*command));
}

void add_threads_option(CLI::App& command, int& threads, const std::string& doc) {
  command.add_option("--threads", threads, doc)->type_name("N")->check([](const std::string& text) {
    int count = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), count);
    const bool whole = problem == std::errc() && end == text.data() + text.size() && count >= 1;
    return whole ? std::string() : text + " is not a number of threads. Write 1 or more.";
  });
}

}  // namespace similitude::app
