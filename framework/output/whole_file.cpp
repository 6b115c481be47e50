#include "output/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace similitude {

OutputError::OutputError(const std::string& what, const std::string& fix)
    : std::runtime_error(what + (fix.empty() ? "" : "\n  " + fix)) {}

void throw_output_error(const std::filesystem::path& file, const std::string& action, int error) {
  if (error == ENOSPC || error == EDQUOT)
    throw OutputError(file.string() + ": cannot be " + action + ": the disk is full.",
                      "Free space there or give another folder with -o. What was written before is whole.");
  throw OutputError(file.string() + ": cannot be " + action + ": " + std::generic_category().message(error) + ".",
                    "Check that its folder exists and may be written to, or give another folder with -o.");
}

namespace {

/// An open file that nobody will miss unless keep() is called.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path path)
      : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {}
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!kept_) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  bool write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }
  bool sync() const { return ::fsync(descriptor_) == 0; }
  bool close() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    return ::close(descriptor) == 0;
  }
  bool rename_to(const std::filesystem::path& target) {
    kept_ = ::rename(path_.c_str(), target.c_str()) == 0;
    return kept_;
  }

 private:
  std::filesystem::path path_;
  int descriptor_;
  bool kept_ = false;
};

/// The new name must survive a power cut as well. Not every file system can do it, and the file is whole either way.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::path part = file;
  part += ".part";
  TemporaryFile temporary(part);
  if (!temporary.is_open() || !temporary.write(bytes) || !temporary.sync() || !temporary.close() ||
      !temporary.rename_to(file))
    throw_output_error(file, "written", errno);
  sync_folder(file.parent_path());
}

void sync_file(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw_output_error(file, "synced", errno);
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (error != 0) throw_output_error(file, "synced", error);
}

}  // namespace similitude
