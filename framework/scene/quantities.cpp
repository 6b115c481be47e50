#include "scene/quantities.h"

#include <algorithm>
#include <set>

#include "scene/case_keys.h"
#include "scene/messages.h"
#include "scene/section.h"
#include "scene/units.h"

namespace similitude {

std::span<const similitude_quantity> quantities_of(const PluginEntry& effect) {
  const auto* functions = static_cast<const similitude_effect_functions*>(effect.descriptor->functions);
  if (functions == nullptr) return {};
  return {functions->quantities, functions->quantity_count};
}

namespace {

/// Every quantity of the given kinds that some effect declares.
std::vector<const similitude_quantity*> known(const Catalogue& catalogue, std::initializer_list<int> kinds) {
  std::vector<const similitude_quantity*> found;
  for (const PluginEntry& plugin : catalogue.plugins()) {
    if (std::string(plugin.descriptor->kind) != "effect") continue;
    for (const similitude_quantity& quantity : quantities_of(plugin)) {
      if (std::find(kinds.begin(), kinds.end(), quantity.kind) != kinds.end()) found.push_back(&quantity);
    }
  }
  return found;
}

bool is_key_of(KeyTable table, std::string_view name) {
  return std::any_of(table.begin(), table.end(), [&](const CaseKey& key) { return key.name == name; });
}

double in_range(const similitude_quantity& quantity, const DocumentNode& node, const std::string& path) {
  const double value = read_quantity(node, path, quantity.unit, Sign::any);
  if (value < quantity.minimum || value > quantity.maximum) {
    throw InputError(node.mark, path,
                     node.text + " is out of range: " + quantity.name + " lies between " +
                         format_quantity(quantity.minimum, quantity.unit) + " and " +
                         format_quantity(quantity.maximum, quantity.unit) + ".",
                     std::string(quantity.name) + ": " + quantity.doc);
  }
  return value;
}

GivenValues take_from(DocumentNode* section, const std::string& path, KeyTable own_keys,
                      const std::vector<const similitude_quantity*>& quantities) {
  GivenValues taken;
  if (section == nullptr || !section->is_map()) return taken;
  for (std::size_t k = 0; k < section->keys.size();) {
    const std::string name = section->keys[k].name;
    const auto quantity = std::find_if(quantities.begin(), quantities.end(),
                                       [&](const similitude_quantity* one) { return one->name == name; });
    if (quantity == quantities.end() || is_key_of(own_keys, name)) {
      ++k;
      continue;
    }
    const double value = in_range(**quantity, section->items[k], path + "." + name);
    taken.push_back({name, (*quantity)->unit, value, (*quantity)->scales_as, section->items[k].mark});
    section->keys.erase(section->keys.begin() + static_cast<std::ptrdiff_t>(k));
    section->items.erase(section->items.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return taken;
}

std::map<std::string, GivenValues> take_from_each(DocumentNode* sections, const std::string& path, KeyTable own_keys,
                                                  const std::vector<const similitude_quantity*>& quantities) {
  std::map<std::string, GivenValues> taken;
  if (sections == nullptr || !sections->is_map()) return taken;
  for (std::size_t k = 0; k < sections->keys.size(); ++k) {
    const std::string& name = sections->keys[k].name;
    taken[name] = take_from(&sections->items[k], path + "." + name, own_keys, quantities);
  }
  return taken;
}

/// Ids of effects that declare a quantity of this name.
std::vector<std::string> who_declares(const Catalogue& catalogue, const std::string& name) {
  std::vector<std::string> ids;
  for (const std::string& id : catalogue.ids("effect")) {
    const auto quantities = quantities_of(*catalogue.find("effect", id));
    if (std::any_of(quantities.begin(), quantities.end(), [&](const similitude_quantity& one) { return one.name == name; })) {
      ids.push_back(id);
    }
  }
  return ids;
}

}  // namespace

QuantityValues take_quantities(Document& document, const Catalogue& catalogue) {
  QuantityValues taken;
  DocumentNode* const scene = document.root().find("scene");
  if (scene == nullptr) return taken;
  const auto flowing = known(catalogue, {SIMILITUDE_GAS_SCALAR});
  taken.gas = take_from(scene->find("gas"), "scene.gas", gas_keys(), known(catalogue, {SIMILITUDE_GAS_SCALAR, SIMILITUDE_GAS_PROPERTY}));
  taken.walls = take_from(scene->find("walls"), "scene.walls", wall_keys(), known(catalogue, {SIMILITUDE_WALL_PROPERTY}));
  taken.patches = take_from_each(scene->find("patches"), "scene.patches", patch_keys(), flowing);
  taken.particles = take_from_each(scene->find("particles"), "scene.particles", particle_keys(),
                                   known(catalogue, {SIMILITUDE_PARTICLE_SCALAR, SIMILITUDE_PARTICLE_PROPERTY}));
  return taken;
}

void set_quantities(const QuantityValues& values, RealScene& scene) {
  scene.gas_values = values.gas;
  scene.wall_values = values.walls;
  for (Patch& patch : scene.patches) patch.values = values.patches.at(patch.name);
  for (ParticleClass& species : scene.particles) species.values = values.particles.at(species.name);
}

std::vector<IdleValue> idle_values(const RealScene& scene, const Catalogue& catalogue) {
  std::vector<IdleValue> idle;
  std::set<std::string> declared;
  for (const ModelChoice& effect : scene.models.effects) {
    for (const similitude_quantity& quantity : quantities_of(*catalogue.find("effect", effect.id))) declared.insert(quantity.name);
  }
  const auto look_at = [&](const GivenValues& values, const std::string& path) {
    for (const GivenValue& given : values)
      if (!declared.contains(given.name)) idle.push_back({path + "." + given.name, given.name, given.mark, who_declares(catalogue, given.name)});
  };
  look_at(scene.gas_values, "scene.gas");
  look_at(scene.wall_values, "scene.walls");
  for (const Patch& patch : scene.patches) look_at(patch.values, "scene.patches." + patch.name);
  for (const ParticleClass& species : scene.particles) look_at(species.values, "scene.particles." + species.name);
  return idle;
}

void check_quantities(const RealScene& scene, const Catalogue& catalogue) {
  if (scene.models.effects_auto) return;
  for (const IdleValue& value : idle_values(scene, catalogue)) {
    const std::vector<std::string>& ids = value.declared_by;
    throw InputError(value.mark, value.path,
                     "no effect of this case has a " + value.name + "; " + listed(ids) + (ids.size() == 1 ? " has." : " have."),
                     "Add " + ids.front() + " to models.effects, or remove this key.");
  }
}

}  // namespace similitude
