#pragma once
#include <filesystem>
#include <string>

namespace similitude::app {

/// Writes a working project for a plugin of `kind` and `id` into the folder named after the id's last word, under
/// `parent`: law, test, README, CMakeLists.txt and a case. Returns the commands that build, test and use it.
/// Throws InputError on an unknown kind, an id that is none, a folder that is there, and templates that are not installed.
std::string write_new_plugin(const std::string& kind, const std::string& id, const std::filesystem::path& parent);

}  // namespace similitude::app
