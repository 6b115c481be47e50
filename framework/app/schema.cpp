#include "scene/schema.h"

#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "loader/json_text.h"

namespace similitude::app {

void add_schema(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of case files, with every plugin's parameters.");
  command->callback([&action] {
    action = [] {
      std::cout << json_text(case_schema(catalogue())) << "\n";
      return 0;
    };
  });
}

}  // namespace similitude::app
