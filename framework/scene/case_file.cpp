#include "scene/case_file.h"

#include <algorithm>

#include "scene/case_keys.h"
#include "scene/check.h"
#include "scene/document.h"
#include "scene/messages.h"
#include "scene/model_reader.h"
#include "scene/pair_reader.h"
#include "scene/quantities.h"
#include "scene/resolved.h"
#include "scene/scene_reader.h"
#include "scene/section.h"

namespace similitude {
namespace {

std::filesystem::path absolute_path(const std::filesystem::path& case_file) {
  return std::filesystem::absolute(case_file).lexically_normal();
}

std::filesystem::path folder_of(const std::filesystem::path& case_file) { return absolute_path(case_file).parent_path(); }

/// First of all: a file of another version may have any keys.
void check_version(const Document& document) {
  const DocumentNode* version = document.root().find("similitude");
  const std::string path = "similitude", known = std::to_string(k_case_version);
  if (version == nullptr)
    throw InputError(document.root().mark, path,
                     "this key is missing: it says for which version of the format a case is written.",
                     document.root().find("similitude_study") != nullptr ? "This looks like a study: similitude study runs it."
                                                                         : "Start the file with the line similitude: " + known + ".");
  if (!version->is_text(known.c_str()))
    throw InputError(version->mark, path,
                     version->described() + " is no version of the format that this program knows.",
                     "Write similitude: " + known + ", or use a program made for that version.");
}

std::vector<std::filesystem::path> plugin_paths(const Document& document, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  const DocumentNode* list = document.root().find("plugin_paths");
  if (list == nullptr || list->kind == DocumentNode::Kind::nothing) return paths;
  if (!list->is_list())
    throw InputError(list->mark, "plugin_paths", "a list is needed, but this is " + list->described() + ".",
                     "Write it in brackets, for example [my/plugins].");
  for (const DocumentNode& item : list->items) {
    const std::string written = read_text(item, "plugin_paths." + std::to_string(paths.size()));
    const std::filesystem::path path = (folder / written).lexically_normal();
    std::error_code problem;
    if (!std::filesystem::is_directory(path, problem))
      throw InputError(item.mark, "plugin_paths", "there is no folder " + path.string() + ".",
                       "A relative path starts at the case's folder.");
    paths.push_back(path);
  }
  return paths;
}

void read_effects(const Section& section, const Catalogue& catalogue, Models& models,
                  std::vector<std::string>& warnings) {
  const DocumentNode* node = section.node("effects");
  const std::string path = section.path("effects");
  models.effects_auto = node == nullptr || node->is_text("auto");
  if (models.effects_auto) return;
  if (!node->is_list())
    throw InputError(node->mark, path, node->described() + " is neither auto nor a list of effects.",
                     "Write auto, [] for none, or for example [" + (node->is_scalar() ? node->text : "id") + "].");
  for (const DocumentNode& item : node->items) {
    const std::string own = path + "." + std::to_string(models.effects.size());
    models.effects.push_back(read_model("effect", item, own, catalogue, {}, warnings));
    for (std::size_t i = 0; i + 1 < models.effects.size(); ++i)
      if (models.effects[i].id == models.effects.back().id)
        throw InputError(item.mark, own, models.effects[i].id + " is in the list twice.", "Keep one of the two.");
  }
}

void read_models(const Section& section, const Catalogue& catalogue, const Document& document, RealScene& scene,
                 std::vector<std::string>& warnings) {
  Models& models = scene.models;
  const auto read = [&](const char* kind) {
    return read_model(kind, *section.node(kind), section.path(kind), catalogue, {}, warnings);
  };
  models.drag = read("drag");
  read_contact(*section.node("contact"), section.path("contact"), catalogue, document, scene, warnings);
  models.fluid = read("fluid");
  read_effects(section, catalogue, models, warnings);

  const CaseKey& stiffness = simulated_stiffness_key();
  const std::string path = section.path("scaling");
  DocumentNode exact{DocumentNode::Kind::scalar, section.mark(), "exact", {}, {}};
  const DocumentNode& scaling = section.given("scaling") ? *section.node("scaling") : exact;
  models.scaling = read_model("scaling", scaling, path, catalogue, {std::string(stiffness.name)}, warnings);
  const auto& own = models.scaling.parameters;   // a law's own parameter of that name means what the law says
  if (std::any_of(own.begin(), own.end(), [&](const ModelParameter& p) { return p.name == stiffness.name; })) return;
  if (const DocumentNode* given = scaling.find(std::string(stiffness.name)))
    models.simulated_stiffness = read_quantity(*given, path + ".stiffness", stiffness.unit, stiffness.sign);
}

}  // namespace

std::vector<std::filesystem::path> plugin_paths_of(const std::filesystem::path& case_file) {
  return plugin_paths(Document(case_file), folder_of(case_file));
}

CaseFile read_case(const std::filesystem::path& case_file, const Catalogue& catalogue,
                   const std::vector<std::string>& overrides) {
  Document document(case_file);
  for (const std::string& assignment : overrides) document.set(assignment);
  check_version(document);
  const QuantityValues quantities = take_quantities(document, catalogue);
  const Section root(&document.root(), "", case_keys(), document.root().mark);

  CaseFile result;
  result.path = absolute_path(case_file);
  RealScene& scene = result.scene;
  scene.name = case_file.stem().string();
  scene.folder = folder_of(case_file).string();
  scene.title = root.given("title") ? root.text("title") : scene.name;
  result.plugin_paths = plugin_paths(document, folder_of(case_file));
  read_scene(root.section("scene"), scene);
  set_quantities(quantities, scene);
  read_models(root.section("models"), catalogue, document, scene, result.warnings);
  check_quantities(scene, catalogue);
  read_coupling(root.section("coupling"), scene);
  read_time(root.section("time"), scene);
  read_output(root.section("output"), scene);
  check_case(scene, document, result.warnings);
  result.resolved = resolved_case(scene, result.plugin_paths, catalogue);
  return result;
}

}  // namespace similitude
