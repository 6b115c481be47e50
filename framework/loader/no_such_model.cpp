#include <algorithm>
#include <cctype>
#include <numeric>

#include "loader/catalogue.h"

namespace similitude {
namespace {

/// Levenshtein's distance: insertions, deletions and exchanges of a letter.
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t exchange = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({exchange, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// The model whose id is at most a third of the wanted word away (two letters at least), or null.
const PluginEntry* nearest(const std::vector<const PluginEntry*>& models, const std::string& wanted) {
  const PluginEntry* best = nullptr;
  std::size_t least = std::max<std::size_t>(2, wanted.size() / 3) + 1;
  for (const PluginEntry* model : models) {
    const std::size_t edits = edits_between(wanted, model->descriptor->id);
    if (edits < least) {
      least = edits;
      best = model;
    }
  }
  return best;
}

/// A library called <other kind>_… is not where a model of `kind` is missing from.
bool may_contain(const RefusedFile& file, const std::string& kind) {
  const std::string name = file.file.filename().string();
  for (const char* other : {"drag", "contact", "fluid", "scaling", "effect"})
    if (kind != other && !kind.empty() && name.starts_with(std::string(other) + "_")) return false;
  return true;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none" : text;
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

void Catalogue::throw_no_such_model(const std::string& kind, const std::string& id) const {
  const std::string model = kind.empty() ? "model" : kind + " model";
  std::vector<const PluginEntry*> models;
  for (const PluginEntry& plugin : plugins_)
    if (kind.empty() || kind == plugin.descriptor->kind) models.push_back(&plugin);

  std::string help;
  if (const PluginEntry* meant = nearest(models, id)) {
    help += "Did you mean \"" + std::string(meant->descriptor->id) + "\" (" + meant->descriptor->version;
    if (!meant->file.empty()) help += ", from " + meant->file.string();
    help += ")?\n";
  }
  help += capitalised(model) + "s found: " + listed(ids(kind)) + ".";

  std::string refused;
  std::size_t count = 0;
  for (const RefusedFile& file : refused_) {
    if (!may_contain(file, kind)) continue;
    ++count;
    refused += "\n  " + file.file.string() + ": " + file.reason;
  }
  if (count != 0)
    help += "\n" + std::to_string(count) + (count == 1 ? " file was" : " files were") +
            " refused and may contain it (`similitude plugins failures` says what to do):" + refused;

  std::vector<std::string> searched;
  for (const SearchLevel& level : levels_) searched.push_back(level.folder.string() + " (" + level.name + ")");
  if (!searched.empty()) help += "\nSearched: " + listed(searched) + ".";
  throw PluginError("there is no " + model + " \"" + id + "\".", help);
}

}  // namespace similitude
