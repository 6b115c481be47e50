#pragma once
/// The inverse of reading: a case with every default filled in.

#include <filesystem>
#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "scene/scene.h"

namespace similitude {

/// JSON text that is itself a case file: reading it gives the same scene, bit by bit.
std::string resolved_case(const RealScene& scene, const std::vector<std::filesystem::path>& plugin_paths,
                          const Catalogue& catalogue);

}  // namespace similitude
