#pragma once
/// The page of a run or of a study.

#include <filesystem>

namespace similitude {

/// Writes report.html into a folder that holds a study.json or a manifest.json, from the files there alone; returns its
/// path. A file that is missing or damaged leaves a gap on the page. Throws InputError if the folder holds neither a run
/// nor a study, OutputError if the page cannot be written.
std::filesystem::path write_report(const std::filesystem::path& folder);

}  // namespace similitude
