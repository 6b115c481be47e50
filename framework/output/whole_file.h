#pragma once
/// Files that are there as a whole or not at all.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace similitude {

/// A result could not be written (disk full, folder gone, no permission). Exit status 2. Message: which file and why,
/// then an indented fix.
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& what, const std::string& fix);
};

/// Throws the OutputError that fits errno value `error` for a failed action, e.g. "written", on `file`.
[[noreturn]] void throw_output_error(const std::filesystem::path& file, const std::string& action, int error);

/// Writes to a temporary name beside `file`, syncs, renames. A reader sees the file before or the file after, never a
/// part. On failure the temporary file is removed, an earlier `file` is untouched, and OutputError is thrown.
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// What was written to a growing file survives a power cut. Throws OutputError.
void sync_file(const std::filesystem::path& file);

}  // namespace similitude
