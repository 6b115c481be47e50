#include "loader/catalogue.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <variant>

#include "loader/library.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;

/// Every line of the fix is indented, so that a reader sees where the next message starts.
std::string with_fix(const std::string& what, const std::string& fix) {
  std::string message = what;
  if (!fix.empty()) message += "\n  ";
  for (const char c : fix) {
    message += c;
    if (c == '\n') message += "  ";
  }
  return message;
}

/// By name, so that nothing depends on the order in which the file system lists them.
std::vector<fs::path> libraries_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (const auto& item : fs::directory_iterator(folder, failed))
    if (item.path().extension() == ".so") files.push_back(item.path());
  std::sort(files.begin(), files.end());
  return files;
}

bool same_model(const PluginEntry& a, const PluginEntry& b) {
  return std::string(a.descriptor->kind) == b.descriptor->kind && std::string(a.descriptor->id) == b.descriptor->id;
}

bool by_kind_and_id(const PluginEntry& a, const PluginEntry& b) {
  return std::make_tuple(std::string(a.descriptor->kind), std::string(a.descriptor->id)) <
         std::make_tuple(std::string(b.descriptor->kind), std::string(b.descriptor->id));
}

}  // namespace

PluginError::PluginError(const std::string& what, const std::string& fix) : std::runtime_error(with_fix(what, fix)) {}

Catalogue::Catalogue(const std::vector<SearchLevel>& levels) : levels_(levels) {
  std::set<fs::path> searched;  // a folder named twice counts where it is nearest
  for (const SearchLevel& level : levels_)
    if (searched.insert(fs::weakly_canonical(level.folder)).second) search(level);
  std::sort(plugins_.begin(), plugins_.end(), by_kind_and_id);
}

Catalogue::Catalogue(std::vector<PluginEntry> plugins) : plugins_(std::move(plugins)) {
  std::sort(plugins_.begin(), plugins_.end(), by_kind_and_id);
}

Catalogue Catalogue::of_file(const fs::path& file) {
  Catalogue one;
  one.look_at(fs::absolute(file).lexically_normal(), "command line");
  std::sort(one.plugins_.begin(), one.plugins_.end(), by_kind_and_id);
  return one;
}

void Catalogue::search(const SearchLevel& level) {
  std::error_code failed;
  if (!fs::is_directory(level.folder, failed)) {
    if (level.must_exist)
      refused_.push_back({level.folder, "there is no such folder, and " + level.name + " names it.",
                          "Correct the path, or leave it out."});
    return;
  }
  for (const fs::path& file : libraries_in(fs::absolute(level.folder).lexically_normal())) look_at(file, level.name);
}

void Catalogue::look_at(const fs::path& file, const std::string& level) {
  const auto loaded = load_library(file);
  if (const auto* refusal = std::get_if<Refusal>(&loaded)) {
    refused_.push_back({file, refusal->reason, refusal->fix});
    return;
  }
  const similitude_entry& entry = *std::get<const similitude_entry*>(loaded);
  for (std::uint32_t k = 0; k < entry.descriptor_count; ++k) take({entry.descriptors[k], file, level, ""});
}

/// What was taken before is nearer and wins; at the same level nothing says which is meant.
void Catalogue::take(const PluginEntry& candidate) {
  const auto same =
      std::find_if(plugins_.begin(), plugins_.end(), [&](const auto& known) { return same_model(known, candidate); });
  if (same == plugins_.end()) {
    plugins_.push_back(candidate);
  } else if (same->level != candidate.level) {
    if (same->hides.empty()) same->hides = candidate.file.string();
  } else if (fs::canonical(same->file) != fs::canonical(candidate.file)) {  // a link to a library is that library
    throw PluginError("two files offer the " + std::string(candidate.descriptor->kind) + " model \"" +
                          candidate.descriptor->id + "\": " + same->file.string() + " and " + candidate.file.string() +
                          " (both found by " + candidate.level + ").",
                      "Remove one of them, or move the one that is meant to a nearer level of the search.");
  }
}

std::vector<std::string> Catalogue::ids(const std::string& kind) const {
  std::vector<std::string> found;
  for (const PluginEntry& plugin : plugins_)
    if (kind.empty() || kind == plugin.descriptor->kind) found.emplace_back(plugin.descriptor->id);
  return found;
}

const PluginEntry* Catalogue::find(const std::string& kind, const std::string& id) const {
  for (const PluginEntry& plugin : plugins_)
    if (kind == plugin.descriptor->kind && id == plugin.descriptor->id) return &plugin;
  return nullptr;
}

}  // namespace similitude
