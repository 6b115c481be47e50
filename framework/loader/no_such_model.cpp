#include <cctype>

#include "loader/catalogue.h"
#include "loader/nearest_name.h"

namespace similitude {
namespace {

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

std::vector<std::string> ids_of(const std::vector<const PluginEntry*>& models) {
  std::vector<std::string> ids;
  for (const PluginEntry* model : models) ids.emplace_back(model->descriptor->id);
  return ids;
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
  const std::string nearest = nearest_name(id, ids_of(models));
  for (const PluginEntry* meant : models) {
    if (meant->descriptor->id != nearest) continue;
    help += "Did you mean \"" + std::string(meant->descriptor->id) + "\" (" + meant->descriptor->version;
    if (!meant->file.empty()) help += ", from " + meant->file.string();
    help += ")?\n";
    break;
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
