#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/new_plugin.h"
#include "doctor/examination.h"
#include "loader/describe.h"
#include "loader/json_text.h"

namespace similitude::app {
namespace {

struct PluginsArguments {
  std::string id, case_file;
  bool json = false;
};

Catalogue catalogue_of(const PluginsArguments& arguments) {
  return arguments.case_file.empty() ? catalogue() : catalogue_for(arguments.case_file);
}

int say(const std::string& text) {
  std::cout << text;
  return 0;
}

int say(const nlohmann::json& page) {
  std::cout << json_text(page) << "\n";
  return 0;
}

using Page = std::function<int(const PluginsArguments&)>;

void add_page(CLI::App& plugins, Action& action, const std::string& name, const std::string& doc, bool takes_id, Page page) {
  auto arguments = std::make_shared<PluginsArguments>();
  CLI::App* command = plugins.add_subcommand(name, doc);
  if (takes_id) command->add_option("ID", arguments->id, "id of a model, e.g. gidaspow")->required();
  command->add_option("--case", arguments->case_file, "also look in this case's plugin_paths");
  command->add_flag("--json", arguments->json, "for other programs");
  command->callback([arguments, page, &action] { action = [arguments, page] { return page(*arguments); }; });
}

void add_new(CLI::App& plugins, Action& action) {
  struct Arguments {
    std::string kind, id, parent = ".";
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = plugins.add_subcommand("new", "Write a working project for a plugin of your own.");
  command->add_option("KIND", arguments->kind, "drag, contact, fluid, scaling or effect")->required();
  command->add_option("ID", arguments->id, "its id for ever: my_law, or org.example.my_law")->required();
  command->add_option("-o,--output", arguments->parent, "folder that the project's folder is made in; here if left out");
  command->callback(
      [arguments, &action] { action = [arguments] { return say(write_new_plugin(arguments->kind, arguments->id, arguments->parent)); }; });
}

constexpr int k_not_healthy = 3;   // as any plugin that is refused

void add_doctor(CLI::App& plugins, Action& action) {
  auto file = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = plugins.add_subcommand("doctor", "Examine a plugin's file and what its models do, each check in a process of its own.");
  command->add_option("FILE", *file, "the library, e.g. build/drag_my_law.so")->required();
  command->add_flag("--json", *json, "for other programs");
  command->callback([file, json, &action] {
    action = [file, json] {
      const doctor::Examination examination = doctor::examine(*file);
      if (*json) {
        say(doctor::examination_json(examination));
      } else {
        say(doctor::examination_text(examination));
      }
      return examination.healthy() ? 0 : k_not_healthy;
    };
  });
}

}  // namespace

void add_plugins(CLI::App& app, Action& action) {
  CLI::App* plugins = app.add_subcommand("plugins", "The models that are installed.");
  plugins->require_subcommand(1);
  add_page(*plugins, action, "list", "Every plugin: kind, id, version, title, file.", false, [](const PluginsArguments& arguments) {
    const Catalogue known = catalogue_of(arguments);
    return arguments.json ? say(plugins_json(known)) : say(plugins_text(known));
  });
  add_page(*plugins, action, "info", "A model's parameters with units, defaults and ranges.", true,
           [](const PluginsArguments& arguments) {
             const Catalogue known = catalogue_of(arguments);
             return arguments.json ? say(plugin_info_json(known, arguments.id)) : say(plugin_info_text(known, arguments.id));
           });
  add_page(*plugins, action, "failures", "Files that were refused, why, and what to do.", false,
           [](const PluginsArguments& arguments) {
             const Catalogue known = catalogue_of(arguments);
             return arguments.json ? say(failures_json(known)) : say(failures_text(known));
           });
  add_new(*plugins, action);
  add_doctor(*plugins, action);
}

}  // namespace similitude::app
