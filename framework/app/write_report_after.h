#pragma once
#include <filesystem>

namespace similitude::app {

/// The report of a run or a study that is over. Whatever goes wrong is a warning: results are never lost for their page.
void write_report_after(const std::filesystem::path& folder);

}  // namespace similitude::app
