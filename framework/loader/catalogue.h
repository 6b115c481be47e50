#pragma once
/// Every plugin this process knows: found, checked, loaded once and never unloaded.

#include <similitude/abi.h>
#include <similitude/known_here.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace similitude {

/// A plugin is missing or was refused. Exit status 3. Message as InputError's: what is wrong, then an indented fix.
class PluginError : public std::runtime_error {
 public:
  explicit PluginError(const std::string& what, const std::string& fix = "");
};

/// A folder that is searched for plugins, and why. Nearer levels come first and win.
/// Folders of the same name make one level.
struct SearchLevel {
  std::string name;  // "plugin_paths of the case", "SIMILITUDE_PLUGIN_PATH", "user folder", "install folder"
  std::filesystem::path folder;
  bool must_exist = false;  // the user named it: if it is not there, that is told
};

struct PluginEntry {
  const similitude_descriptor* descriptor = nullptr;  // for ever
  std::filesystem::path file;                         // absolute
  std::string level;                                  // name of its SearchLevel
  std::string hides;                                  // file of the same kind and id at a farther level, or ""
};

/// A library that was not taken, and why.
struct RefusedFile {
  std::filesystem::path file;
  std::string reason;  // both sides printed
  std::string fix;
};

/// A created model: functions and instance. Movable; destroys the instance, never the library.
template <class Functions>
class Model {
 public:
  Model() = default;
  Model(const similitude_descriptor& descriptor, void* instance, std::uint32_t sets = 1)
      : descriptor_(&descriptor),
        functions_(std::make_unique<Functions>(as_known_here(static_cast<const Functions*>(descriptor.functions)))),
        instance_(instance, descriptor.destroy),
        sets_(sets) {}
  explicit operator bool() const { return descriptor_ != nullptr; }
  const similitude_descriptor& descriptor() const { return *descriptor_; }
  /// A hook that the plugin's table does not reach is null.
  const Functions& functions() const { return *functions_; }
  void* instance() const { return instance_.get(); }
  /// Of parameters: a contact model has one for all contacts, or one for each pair of materials.
  std::uint32_t sets() const { return sets_; }

 private:
  const similitude_descriptor* descriptor_ = nullptr;
  std::unique_ptr<const Functions> functions_;
  std::unique_ptr<void, void (*)(void*)> instance_{nullptr, nullptr};
  std::uint32_t sets_ = 1;
};
using ContactModel = Model<similitude_contact_functions>;
using DragModel = Model<similitude_drag_functions>;
using FluidModel = Model<similitude_fluid_functions>;
using ScalingModel = Model<similitude_scaling_functions>;
using EffectModel = Model<similitude_effect_functions>;

/// What a solver asks for; zero throughout where it has no such hook.
similitude_fluid_needs needs_of(const FluidModel& fluid);
/// How many numbers a solver remembers beyond the step's fields; 0 without the hook. Throws PluginError if it does not say: what it
/// threw was told to the host's log. [main]
std::size_t state_size_of(const FluidModel& fluid);
/// Replaces what `state` held by those numbers. Throws as above.
void save_state_of(const FluidModel& fluid, std::vector<double>& state);

class Catalogue {
 public:
  /// Looks at every file in the levels' folders. A refused file is remembered, not fatal; the same kind and id twice at
  /// one level throws PluginError naming both files.
  explicit Catalogue(const std::vector<SearchLevel>& levels);
  /// Plugins that are already there: compiled in, or made up by a test. Nothing is searched and nothing is checked.
  explicit Catalogue(std::vector<PluginEntry> plugins);
  /// The models of one file alone, or why it is refused: for a diagnosis.
  static Catalogue of_file(const std::filesystem::path& file);

  /// In the order of kind, then id.
  const std::vector<PluginEntry>& plugins() const { return plugins_; }
  const std::vector<RefusedFile>& refused() const { return refused_; }
  std::vector<std::string> ids(const std::string& kind) const;
  /// Null if there is none.
  const PluginEntry* find(const std::string& kind, const std::string& id) const;
  /// "there is no drag model "gidaspo". Did you mean …" with the models found and the refused files that may contain
  /// it. An empty kind: any kind will do.
  [[noreturn]] void throw_no_such_model(const std::string& kind, const std::string& id) const;

 private:
  Catalogue() = default;
  void search(const SearchLevel& level);
  void look_at(const std::filesystem::path& file, const std::string& level);
  void take(const PluginEntry& candidate);

  std::vector<SearchLevel> levels_;
  std::vector<PluginEntry> plugins_;
  std::vector<RefusedFile> refused_;
};

/// From the nearest: the case's plugin_paths, the folders of SIMILITUDE_PLUGIN_PATH (colons between them), the user
/// folder
/// ${XDG_DATA_HOME:-~/.local/share}/similitude/plugins, the install folder, which is also the build tree's, found from
/// where this program lies.
std::vector<SearchLevel> search_levels(const std::vector<std::filesystem::path>& plugin_paths_of_case);

/// Creates a model with `sets` rows of values, in the order of its parameter table. A choice without a text is its
/// default. Throws PluginError with the plugin's own words on refusal, and std::logic_error when kind or number of
/// values do not fit.
template <class Functions>
Model<Functions> create_model(const PluginEntry& plugin, const similitude_bed& bed,
                              const std::vector<similitude_value>& values, std::uint32_t sets = 1);

}  // namespace similitude
