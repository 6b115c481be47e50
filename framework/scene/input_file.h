#pragma once
/// What is asked of every file that a user names, before it is read.

#include <filesystem>
#include <string>
#include <vector>

namespace similitude {

/// What was to be named: "case file", the ends of such names, and the words that one line of such a file starts with (empty: any).
struct WantedFile {
  std::string what;
  std::vector<std::string> endings;
  std::string first_words;
};

/// Throws InputError if `file` is a folder; the fix names the first file in it, by name, that may have been meant.
void refuse_folder(const std::filesystem::path& file, const WantedFile& wanted);

}  // namespace similitude
