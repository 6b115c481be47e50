#include "stepper/resume.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "loader/catalogue.h"
#include "output/sha256.h"
#include "scene/messages.h"

namespace similitude {
namespace {

using Json = nlohmann::ordered_json;

/// What may change: when to end, how often to write, what it is called. Plugins are compared by their files, so the folders
/// they were found in may change too.
constexpr std::array<std::string_view, 6> k_free = {"/title",      "/time/end",        "/output/vtk", "/output/monitors",
                                                    "/output/checkpoint", "/plugin_paths"};
constexpr std::string_view k_bed_file = "/scene/bed/file";

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

std::string another_file(const std::string& was, const std::string& is, const std::string& file) {
  return fmt::format("the file is another (SHA-256 was {:.12}…, is {:.12}… of {})", was, is, file);
}

std::vector<std::string> lines_of_difference(const CaseIdentity& before, const CaseIdentity& now) {
  const Json was = values_of(before.resolved_case), is = values_of(now.resolved_case);
  const bool bytes_are_known = !before.bed_sha256.empty() && !now.bed_sha256.empty();
  std::vector<std::string> lines;
  for (const auto& [pointer, value] : was.items()) {
    if (is_free(pointer)) continue;
    if (bytes_are_known && pointer == k_bed_file) {
      if (before.bed_sha256 != now.bed_sha256) {
        lines.push_back(dotted(pointer) + ": " + another_file(before.bed_sha256, now.bed_sha256, shown(is[pointer])));
      }
    } else if (!is.contains(pointer)) {
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
      lines.push_back(name + ": " + another_file(was.sha256, is->sha256, is->file));
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

CaseIdentity identity_of(const CaseFile& case_file) {
  const std::string& bed = case_file.scene.bed.file;
  return {.resolved_case = case_file.resolved, .bed_sha256 = bed.empty() ? "" : sha256_of_file(bed)};
}

std::string case_differences(const CaseIdentity& before, const CaseIdentity& now) { return indented(lines_of_difference(before, now)); }

EarlierRun newest_checkpoint(const OutputDirectory& directory, const std::function<void(const std::string&)>& warn) {
  const std::string anew = "Start the run anew with --force, or in another folder with -o.";
  const std::vector<std::filesystem::path> files = checkpoints_in(directory.file(k_checkpoint_folder));
  if (files.empty()) throw InputError(directory.path().string() + " holds no checkpoint.", anew);
  for (std::size_t n = 0; n < files.size(); ++n) {
    // Out of reach is not damaged: it may be there again tomorrow.
    if (const std::ifstream stream(files[n]); !stream) {
      const int error = errno;
      throw InputError(files[n].string() + " cannot be opened: " + std::generic_category().message(error) + ".",
                       "Make it readable and resume again; if it is taken away, the checkpoint before it is used.");
    }
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
  std::string differences = case_differences(before, now);
  if (differences.empty() && (before.dt != now.dt || before.sub_steps != now.sub_steps)) {
    differences = indented({fmt::format("time steps of the simulated bed: were {} x {:.17g} s, are {} x {:.17g} s", before.sub_steps,
                                        before.dt, now.sub_steps, now.dt)});
  }
  if (!differences.empty()) {
    throw InputError("the earlier run was of another case:" + differences,
                     "Undo these changes to go on with that run, or start a new one in another folder with -o.");
  }
  const std::vector<std::string> plugins = plugin_differences(before.plugins, now.plugins);
  if (!plugins.empty()) {
    throw PluginError("the earlier run used other plugins:" + indented(plugins),
                      "Put those back to go on with that run, or start a new one in another folder with -o.");
  }
}

}  // namespace similitude
