#pragma once
/// The folder of one run.

#include <array>
#include <filesystem>
#include <string>

namespace similitude {

class OutputDirectory {
 public:
  /// Creates the folder and the folders above it. If it holds an earlier run: with `force` that run's own files are
  /// removed (and nothing else), without it InputError (scene/messages.h). InputError too if the folder cannot be made
  /// or written to.
  OutputDirectory(const std::filesystem::path& path, bool force);

  /// The folder of an earlier run that is to go on. InputError if there is no such run or it cannot be written to.
  static OutputDirectory of_earlier_run(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(const std::string& name) const { return path_ / name; }
  /// A folder inside, created if needed. Throws OutputError (output/whole_file.h).
  std::filesystem::path subfolder(const std::string& name) const;

 private:
  struct Existing {};
  OutputDirectory(const std::filesystem::path& path, Existing) : path_(path) {}
  std::filesystem::path path_;
};

/// Every file that a run may write into its folder itself, beside the folders of frames and checkpoints.
inline constexpr std::array k_files_of_a_run = {"manifest.json", "particles.pvd", "fluid.pvd",  "monitors.csv", "profiles.csv",
                                                "profile_blocks.csv", "probes.csv", "scalars.csv", "timing.json", "report.html",
                                                "audit.json", "front_view.bin", "view.py"};
/// Where a run's checkpoints lie in its folder.
inline constexpr const char* k_checkpoint_folder = "checkpoints";

/// Does the folder hold files of a run? What `--force` asks about.
bool holds_a_run(const std::filesystem::path& folder);

}  // namespace similitude
