#include "report/report.h"

#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "app/commands.h"
#include "app/write_report_after.h"

namespace similitude::app {

void write_report_after(const std::filesystem::path& folder) {
  try {
    std::cout << "report " << write_report(folder).string() << "\n";
  } catch (const std::exception& error) {
    std::cerr << "warning: the report was not written: " << error.what() << "\n";
  }
}

void add_report(CLI::App& app, Action& action) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("report", "Make report.html of a run or a study anew: one file that works offline.");
  command->add_option("DIR", *folder, "folder that similitude run or similitude study wrote")->required();
  command->callback([folder, &action] {
    action = [folder] {
      const std::filesystem::path file = write_report(*folder);
      std::cout << fmt::format("{} ({:.1f} MB)\n", file.string(), 1e-6 * static_cast<double>(std::filesystem::file_size(file)));
      return 0;
    };
  });
}

}  // namespace similitude::app
