#include "scene/schema.h"

#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"

namespace similitude::app {

void add_schema(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of case files, with every plugin's parameters.");
  command->callback([&action] {
    action = [] {
      std::cout << case_schema(catalogue()).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
      return 0;
    };
  });
}

}  // namespace similitude::app
