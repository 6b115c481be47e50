#include "stepper/resume.h"

#include <array>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "loader/catalogue.h"
#include "scene/messages.h"

namespace similitude {
namespace {

using Json = nlohmann::ordered_json;

/// What may change: when to end, how often to write, what it is called. Plugins are compared by their files, so the folders
/// they were found in may change too.
constexpr std::array<std::string_view, 6> k_free = {"/title",      "/time/end",        "/output/vtk", "/output/monitors",
                                                    "/output/checkpoint", "/plugin_paths"};

bool is_free(const std::string& pointer) {
  for (const std::string_view free : k_free) {
    if (pointer == free || pointer.starts_with(std::string(free) + "/")) return true;
  }
  return false;
}

/// "/scene/gas/density" as people write it: scene.gas.density.
std::string dotted(std::string pointer) {
  pointer.erase(0, 1);
  for (char& c : pointer) c = c == '/' ? '.' : c;
  return pointer;
}

std::string shown(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// Every value, by its path.
Json values_of(const std::string& resolved_case) { return Json::parse(resolved_case).flatten(); }

std::vector<std::string> case_differences(const std::string& before, const std::string& now) {
  const Json was = values_of(before), is = values_of(now);
  std::vector<std::string> lines;
  for (const auto& [pointer, value] : was.items()) {
    if (is_free(pointer)) continue;
    if (!is.contains(pointer)) {
      lines.push_back(fmt::format("{}: was {}, is left out", dotted(pointer), shown(value)));
    } else if (is[pointer] != value) {
      lines.push_back(fmt::format("{}: was {}, is {}", dotted(pointer), shown(value), shown(is[pointer])));
    }
  }
  for (const auto& [pointer, value] : is.items()) {
    if (!is_free(pointer) && !was.contains(pointer)) lines.push_back(fmt::format("{}: was left out, is {}", dotted(pointer), shown(value)));
  }
  return lines;
}

const ManifestPlugin* find(const std::vector<ManifestPlugin>& plugins, const ManifestPlugin& wanted) {
  for (const ManifestPlugin& plugin : plugins) {
    if (plugin.kind == wanted.kind && plugin.id == wanted.id) return &plugin;
  }
  return nullptr;
}

std::vector<std::string> plugin_differences(const std::vector<ManifestPlugin>& before, const std::vector<ManifestPlugin>& now) {
  std::vector<std::string> lines;
  for (const ManifestPlugin& was : before) {
    const ManifestPlugin* const is = find(now, was);
    const std::string name = was.kind + " " + was.id;
    if (is == nullptr) {
      lines.push_back(name + ": was in use, is not");
    } else if (is->version != was.version) {
      lines.push_back(fmt::format("{}: was version {}, is {} ({})", name, was.version, is->version, is->file));
    } else if (is->sha256 != was.sha256) {
      lines.push_back(fmt::format("{}: the file is another (SHA-256 was {:.12}…, is {:.12}… of {})", name, was.sha256, is->sha256, is->file));
    }
  }
  for (const ManifestPlugin& is : now) {
    if (find(before, is) == nullptr) lines.push_back(is.kind + " " + is.id + ": was not in use, is");
  }
  return lines;
}

std::string indented(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "\n    " + line;
  return text;
}

std::filesystem::path set_aside(const std::filesystem::path& file) {
  std::filesystem::path aside = file;
  aside += ".damaged";
  std::error_code error;
  std::filesystem::rename(file, aside, error);
  return error ? file : aside;
}

}  // namespace

EarlierRun newest_checkpoint(const OutputDirectory& directory, const std::function<void(const std::string&)>& warn) {
  const std::string anew = "Start the run anew with --force, or in another folder with -o.";
  const std::vector<std::filesystem::path> files = checkpoints_in(directory.file(k_checkpoint_folder));
  if (files.empty()) throw InputError(directory.path().string() + " holds no checkpoint.", anew);
  for (std::size_t n = 0; n < files.size(); ++n) {
    try {
      Checkpoint checkpoint = read_checkpoint(files[n]);
      return {std::move(checkpoint), {files.begin() + static_cast<std::ptrdiff_t>(n), files.end()}};
    } catch (const CheckpointFormatError& error) {
      throw InputError(files[n].string() + " has " + error.what() + ".", "Use the program that wrote it. " + anew);
    } catch (const Hdf5Error& error) {
      warn(files[n].string() + " is cut short or altered (" + error.what() + "); it is now " + set_aside(files[n]).filename().string() +
           (n + 1 < files.size() ? ", and the checkpoint before it is used." : "."));
    }
  }
  throw InputError("none of the checkpoints in " + directory.path().string() + " can be read.", anew);
}

void refuse_another_run(const RunIdentity& before, const RunIdentity& now) {
  std::vector<std::string> differences = case_differences(before.resolved_case, now.resolved_case);
  if (differences.empty() && (before.dt != now.dt || before.sub_steps != now.sub_steps)) {
    differences.push_back(fmt::format("time steps of the simulated bed: were {} x {:.17g} s, are {} x {:.17g} s", before.sub_steps, before.dt,
                                      now.sub_steps, now.dt));
  }
  if (!differences.empty()) {
    throw InputError("the earlier run was of another case:" + indented(differences),
                     "Undo these changes to go on with that run, or start a new one in another folder with -o.");
  }
  const std::vector<std::string> plugins = plugin_differences(before.plugins, now.plugins);
  if (!plugins.empty()) {
    throw PluginError("the earlier run used other plugins:" + indented(plugins),
                      "Put those back to go on with that run, or start a new one in another folder with -o.");
  }
}

}  // namespace similitude
