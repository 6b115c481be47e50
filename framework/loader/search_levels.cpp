#include <dlfcn.h>

#include <cstdlib>
#include <sstream>

#include "loader/catalogue.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Empty if there is neither XDG_DATA_HOME nor HOME. A relative XDG_DATA_HOME does not count (XDG base directories
/// 0.8).
fs::path user_folder() {
  const fs::path data = variable("XDG_DATA_HOME");
  if (data.is_absolute()) return data / "similitude" / "plugins";
  const fs::path home = variable("HOME");
  return home.empty() ? fs::path() : home / ".local" / "share" / "similitude" / "plugins";
}

/// The file this code was loaded from: libsimilitude, or the program that has it built in.
fs::path own_file() {
  Dl_info info{};
  std::error_code failed;
  if (dladdr(reinterpret_cast<const void*>(&own_file), &info) != 0 && info.dli_fname != nullptr) {
    const fs::path library = fs::weakly_canonical(info.dli_fname, failed);
    if (!failed && fs::exists(library, failed)) return library;
  }
  return fs::read_symlink("/proc/self/exe", failed);
}

/// Beside libsimilitude, wherever the system keeps its libraries, or in ../lib of the program. Holds for a prefix that
/// was moved after the installation, and for the build tree.
fs::path install_folder() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const fs::path plugins = fs::path("similitude") / "plugins";
  for (const fs::path& candidate :
       {own_file().parent_path() / plugins, own_file().parent_path().parent_path() / "lib" / plugins,
        program.parent_path().parent_path() / "lib" / plugins})
    if (fs::is_directory(candidate, failed)) return candidate;
  return program.parent_path().parent_path() / "lib" / plugins;
}

}  // namespace

std::vector<SearchLevel> search_levels(const std::vector<fs::path>& plugin_paths_of_case) {
  std::vector<SearchLevel> levels;
  for (const fs::path& folder : plugin_paths_of_case) levels.push_back({"plugin_paths of the case", folder, true});
  std::istringstream folders(variable("SIMILITUDE_PLUGIN_PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty()) levels.push_back({"SIMILITUDE_PLUGIN_PATH", folder, true});
  if (!user_folder().empty()) levels.push_back({"user folder", user_folder()});
  levels.push_back({"install folder", install_folder()});
  return levels;
}

}  // namespace similitude
