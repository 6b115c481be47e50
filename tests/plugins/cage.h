#pragma once
/// A folder of chosen creatures, gone with the test.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "loader/catalogue.h"

namespace zoo {

class Cage {
 public:
  Cage() {
    std::string pattern = (std::filesystem::temp_directory_path() / "zoo-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Cage() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Cage(const Cage&) = delete;
  Cage& operator=(const Cage&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  std::string path(const std::string& file) const { return (folder_ / file).string(); }

  /// Brings drag_<creature>.so in.
  Cage& add(const std::string& creature) {
    const std::string file = "drag_" + creature + ".so";
    std::filesystem::copy_file(std::filesystem::path(ZOO_FOLDER) / file, folder_ / file);
    return *this;
  }
  Cage& write(const std::string& file, const std::string& text) {
    std::ofstream(folder_ / file) << text;
    return *this;
  }

  similitude::SearchLevel level(const std::string& name = "user folder") const { return {name, folder_}; }
  similitude::Catalogue catalogue() const {
    return similitude::Catalogue(std::vector<similitude::SearchLevel>{level()});
  }

 private:
  std::filesystem::path folder_;
};

/// The text of the PluginError that `work` throws, or "no error".
template <class Work>
std::string error_of(Work&& work) {
  try {
    work();
  } catch (const similitude::PluginError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace zoo
