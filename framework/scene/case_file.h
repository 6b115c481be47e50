#pragma once
/// From a case file to the real bed: strict YAML, units, models resolved against the plugins' own parameter tables.

#include <filesystem>
#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "scene/scene.h"

namespace similitude {

struct CaseFile {
  std::filesystem::path path;                        // of the file that was read, absolute
  RealScene scene;
  std::vector<std::filesystem::path> plugin_paths;   // absolute
  std::string resolved;                              // JSON: the case with every default filled in, itself a case file
  std::vector<std::string> warnings;                 // each with its place, as errors
};

/// Only the key plugin_paths, made absolute from the case's folder, so that the catalogue can be built before the case is
/// read. Throws InputError.
std::vector<std::filesystem::path> plugin_paths_of(const std::filesystem::path& case_file);

/// `overrides` are "key=value" with dotted keys, as of --set; they win over the file. Throws InputError (exit 2) with file,
/// line and column, or PluginError (exit 3) when the case names a model that no plugin provides.
CaseFile read_case(const std::filesystem::path& case_file, const Catalogue& catalogue,
                   const std::vector<std::string>& overrides = {});

}  // namespace similitude
