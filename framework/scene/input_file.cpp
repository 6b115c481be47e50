#include "scene/input_file.h"

#include <algorithm>
#include <fstream>

#include "scene/messages.h"

namespace similitude {
namespace {

bool starts_so(const std::filesystem::path& file, const std::string& words) {
  if (words.empty()) return true;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(words)) return true;
  return false;
}

}  // namespace

void refuse_folder(const std::filesystem::path& file, const WantedFile& wanted) {
  std::error_code problem;
  if (!std::filesystem::is_directory(file, problem)) return;
  std::vector<std::filesystem::path> likely;
  for (const auto& entry : std::filesystem::directory_iterator(file, problem)) {
    const bool named_so = std::ranges::find(wanted.endings, entry.path().extension().string()) != wanted.endings.end();
    if (named_so && entry.is_regular_file(problem) && starts_so(entry.path(), wanted.first_words)) likely.push_back(entry.path());
  }
  std::string fix = "Give the " + wanted.what + " in it";
  if (!likely.empty()) fix += ", e.g. " + std::ranges::min_element(likely)->lexically_normal().string();
  throw InputError(file.string() + " is a folder.", fix + ".");
}

}  // namespace similitude
