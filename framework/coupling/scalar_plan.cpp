#include "coupling/scalar_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "scene/messages.h"

namespace similitude {
namespace {

constexpr double k_none = std::numeric_limits<double>::quiet_NaN();

std::span<const similitude_quantity> quantities_of(const EffectModel& effect) {
  return {effect.functions().quantities, effect.functions().quantity_count};
}

SourceMark mark_of(const ModelScene& scene, const EffectModel& effect) {
  for (const ModelChoice& choice : scene.models.effects) {
    if (choice.id == effect.descriptor().id) return choice.mark;
  }
  return {};
}

/// What the case gives, else the quantity's default.
double wanted(const ModelScene& scene, const EffectModel& effect, const similitude_quantity& quantity, const GivenValues& values,
              const std::string& section) {
  const double given = value_of(values, quantity.name);
  if (!std::isnan(given)) return given;
  if (!std::isnan(quantity.default_value)) return quantity.default_value;
  const std::string key = section + "." + quantity.name;
  std::string doc = quantity.doc;
  if (doc.ends_with('.')) doc.pop_back();
  throw InputError(mark_of(scene, effect), "models.effects",
                   std::string(effect.descriptor().id) + " needs " + key + " (" + doc + ").",
                   "Add " + key + (std::string(quantity.unit) == "1" ? "." : ", in " + std::string(quantity.unit) + "."));
}

class Planner {
 public:
  explicit Planner(const ModelScene& scene) : scene_(scene) {}

  void add(const EffectModel& effect) {
    const auto table = quantities_of(effect);
    if (table.empty()) return;
    EffectQuantities own;
    own.effect = &effect;
    std::vector<double> properties(table.size(), k_none);
    for (std::size_t q = 0; q < table.size(); ++q) {
      const similitude_quantity& quantity = table[q];
      own.kind.push_back(quantity.kind);
      own.slot.push_back(-1);
      own.by_class.emplace_back();
      own.wall.push_back(k_none);
      const auto& uses = effect.functions().uses;
      if (uses != nullptr && uses(effect.instance(), static_cast<std::uint32_t>(q)) == 0) continue;
      switch (quantity.kind) {
        case SIMILITUDE_GAS_SCALAR: own.slot[q] = gas_scalar(effect, quantity); break;
        case SIMILITUDE_GAS_PROPERTY: properties[q] = wanted(scene_, effect, quantity, scene_.gas_values, "scene.gas"); break;
        case SIMILITUDE_WALL_PROPERTY: properties[q] = value_of(scene_.wall_values, quantity.name); break;
        case SIMILITUDE_PARTICLE_PROPERTY: own.by_class[q] = of_classes(effect, quantity); break;
        default: break;
      }
    }
    for (std::size_t q = 0; q < table.size(); ++q) {   // once the properties are there that capacities are made of
      const auto& uses = effect.functions().uses;
      if (table[q].kind != SIMILITUDE_PARTICLE_SCALAR) continue;
      if (uses != nullptr && uses(effect.instance(), static_cast<std::uint32_t>(q)) == 0) continue;
      own.slot[q] = particle_scalar(effect, table[q], own);
      own.wall[q] = value_of(scene_.wall_values, table[q].name);
    }
    configure(effect, properties, own);
    plan_.effects.push_back(std::move(own));
  }

  ScalarPlan finish() {
    for (const GasScalar& scalar : plan_.gas) {
      if (scalar.capacity > 0) continue;
      throw PluginError("no effect of this case says how the gas holds the scalar " + scalar.name + ".",
                        "Add the effect that carries it to models.effects.");
    }
    return std::move(plan_);
  }

 private:
  std::vector<double> of_classes(const EffectModel& effect, const similitude_quantity& quantity) const {
    std::vector<double> values;
    for (const ParticleClass& species : scene_.particles) {
      values.push_back(wanted(scene_, effect, quantity, species.values, "scene.particles." + species.name));
    }
    return values;
  }

  int gas_scalar(const EffectModel& effect, const similitude_quantity& quantity) {
    for (std::size_t s = 0; s < plan_.gas.size(); ++s) {
      if (plan_.gas[s].name == quantity.name) return static_cast<int>(s);
    }
    GasScalar scalar;
    scalar.name = quantity.name;
    scalar.unit = quantity.unit;
    scalar.amount_unit = quantity.amount_unit != nullptr ? quantity.amount_unit : "";
    scalar.initial = wanted(scene_, effect, quantity, scene_.gas_values, "scene.gas");
    scalar.wall = value_of(scene_.wall_values, quantity.name);
    for (const Patch& patch : scene_.patches) {
      const double given = value_of(patch.values, quantity.name);
      scalar.patch_value.push_back(std::isnan(given) ? scalar.initial : given);
    }
    plan_.gas.push_back(scalar);
    return static_cast<int>(plan_.gas.size()) - 1;
  }

  int particle_scalar(const EffectModel& effect, const similitude_quantity& quantity, const EffectQuantities& own) {
    for (std::size_t s = 0; s < plan_.particles.size(); ++s) {
      if (plan_.particles[s].name == quantity.name) return static_cast<int>(s);
    }
    ParticleScalar scalar;
    scalar.name = quantity.name;
    scalar.unit = quantity.unit;
    scalar.amount_unit = quantity.amount_unit != nullptr ? quantity.amount_unit : "";
    scalar.initial = of_classes(effect, quantity);
    scalar.capacity.assign(scene_.particles.size(), 1.0);
    if (quantity.capacity >= 0) scalar.capacity = own.by_class[static_cast<std::size_t>(quantity.capacity)];
    plan_.particles.push_back(scalar);
    return static_cast<int>(plan_.particles.size()) - 1;
  }

  void configure(const EffectModel& effect, const std::vector<double>& properties, const EffectQuantities& own) {
    if (effect.functions().configure == nullptr) return;
    std::vector<similitude_gas_scalar_law> laws(properties.size());
    for (similitude_gas_scalar_law& law : laws) law = {.struct_size = sizeof(law), .reserved = 0, .capacity = 0, .diffusivity = 0, .turbulent_number = 0};
    similitude_status status{};
    effect.functions().configure(effect.instance(), properties.data(), laws.data(), &status);
    if (status.code != 0) throw InputError(mark_of(scene_, effect), "models.effects", std::string(effect.descriptor().id) + ": " + status.text);
    for (std::size_t q = 0; q < laws.size(); ++q) {
      if (own.kind[q] != SIMILITUDE_GAS_SCALAR || own.slot[q] < 0 || !(laws[q].capacity > 0)) continue;
      GasScalar& scalar = plan_.gas[static_cast<std::size_t>(own.slot[q])];
      scalar.capacity = laws[q].capacity;
      scalar.diffusivity = laws[q].diffusivity;
      scalar.turbulent_number = laws[q].turbulent_number;
    }
  }

  const ModelScene& scene_;
  ScalarPlan plan_;
};

}  // namespace

ScalarPlan plan_scalars(const ModelScene& scene, const std::vector<EffectModel>& effects) {
  Planner planner(scene);
  for (const EffectModel& effect : effects) planner.add(effect);
  return planner.finish();
}

}  // namespace similitude
