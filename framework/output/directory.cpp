#include "output/directory.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <vector>

#include "output/whole_file.h"
#include "scene/messages.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;

struct FrameFolder {
  const char* name;
  const char* prefix;
  const char* extension;
};
// Checkpoints are the first to go: what is left when a removal is broken off must not look like a run that can go on.
constexpr std::array k_frame_folders = {FrameFolder{k_checkpoint_folder, "checkpoint_", ".h5"},
                                        FrameFolder{"particles", "particles_", ".vtp"},
                                        FrameFolder{"fluid", "fluid_", ".vti"}};

std::string file_of_a_run(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : k_files_of_a_run)
    if (fs::exists(folder / name, ignored)) return name;
  return "";
}

bool is_frame(const fs::path& file, const FrameFolder& frames) {
  fs::path name = file.filename();
  if (name.extension() == ".part" || name.extension() == ".damaged") name = name.stem();
  return name.extension() == frames.extension && name.string().starts_with(frames.prefix);
}

/// Only what a run writes: whatever else lies in the folder is the user's.
void remove_run(const fs::path& folder) {
  for (const FrameFolder& frames : k_frame_folders) {
    const fs::path inner = folder / frames.name;
    if (!fs::is_directory(inner)) continue;
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(inner))
      if (entry.is_regular_file() && is_frame(entry.path(), frames)) old.push_back(entry.path());
    for (const fs::path& file : old) fs::remove(file);
  }
  for (const char* name : k_files_of_a_run) {
    fs::remove(folder / name);
    fs::remove(folder / (std::string(name) + ".part"));
  }
}

/// Asked of the file system itself: permission bits say nothing about root, read-only mounts or quotas.
int error_of_writing_in(const fs::path& folder) {
  const fs::path probe = folder / ".similitude-may-write";
  const int descriptor = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  ::close(descriptor);
  ::unlink(probe.c_str());
  return 0;
}

void refuse_unless_writable(const fs::path& path) {
  if (const int no = error_of_writing_in(path); no != 0)
    throw InputError(
        "the folder " + path.string() + " cannot be written to: " + std::generic_category().message(no) + ".",
        "Give another folder with -o, or change its permissions.");
}

}  // namespace

bool holds_a_run(const fs::path& folder) { return !file_of_a_run(folder).empty(); }

OutputDirectory::OutputDirectory(const fs::path& path, bool force) : path_(path) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw InputError(path.string() + " is a file, not a folder for results.", "Give another folder with -o.");
  if (const std::string found = file_of_a_run(path); !found.empty() && !force)
    throw InputError(path.string() + " holds an earlier run (" + found + ").",
                     std::string("Give another folder with -o, ") +
                         (fs::is_directory(path / k_checkpoint_folder, error) ? "--resume to go on with that run, " : "") +
                         "or --force to replace that run.");
  fs::create_directories(path, error);
  if (error)
    throw InputError("the folder " + path.string() + " cannot be made: " + error.message() + ".",
                     "Give another folder with -o.");
  refuse_unless_writable(path);
  try {
    if (force) remove_run(path);
  } catch (const fs::filesystem_error& e) {
    throw InputError("the earlier run in " + path.string() + " cannot be removed: " + e.code().message() + " (" +
                         e.path1().filename().string() + ").",
                     "Give another folder with -o.");
  }
}

OutputDirectory OutputDirectory::of_earlier_run(const fs::path& path) {
  if (!holds_a_run(path))
    throw InputError(path.string() + " holds no earlier run.", "Leave --resume out to start one, or give that run's folder with -o.");
  refuse_unless_writable(path);
  return {path, Existing{}};
}

fs::path OutputDirectory::subfolder(const std::string& name) const {
  const fs::path folder = path_ / name;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_output_error(folder, "made", error.value());
  return folder;
}

}  // namespace similitude
