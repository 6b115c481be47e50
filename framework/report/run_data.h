#pragma once
/// What a page shows of one run, gathered from the run's folder.

#include <filesystem>
#include <nlohmann/json.hpp>

namespace similitude {

/// The file as JSON; null if it is missing or damaged.
nlohmann::ordered_json json_file(const std::filesystem::path& file);

/// manifest, timing, audit, monitors, profiles, front view; null for each that is missing. `view_bytes`: the front view may
/// take so much of the page; pictures are left out, evenly, until it fits.
nlohmann::ordered_json run_data(const std::filesystem::path& folder, std::size_t view_bytes);

}  // namespace similitude
