#pragma once
/// Which scalars the effects of a case bring into being, and where each effect finds the quantities of its own table.

#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "scene/scene.h"

namespace similitude {

/// Carried by the gas.
struct GasScalar {
  std::string name, unit, amount_unit;
  double capacity = 0;            // amount per kg of gas and unit of the scalar
  double diffusivity = 0;         // [m^2/s]
  double turbulent_number = 0;    // [-], 0: added viscosity adds no diffusivity
  double initial = 0;             // at the start everywhere, and what amounts are counted from
  double wall = 0;                // NaN: walls are closed
  std::vector<double> patch_value;   // by patch of the scene: of what flows in
};

/// A column of particles.
struct ParticleScalar {
  std::string name, unit, amount_unit;
  std::vector<double> initial;    // by class
  std::vector<double> capacity;   // by class: amount per kg and unit of the scalar
};

/// One effect with its quantities, in the order of its table.
struct EffectQuantities {
  const EffectModel* effect = nullptr;
  std::vector<int> kind;                          // SIMILITUDE_GAS_SCALAR ...
  std::vector<int> slot;                          // of a scalar in the plan; -1: no scalar, or not used
  std::vector<std::vector<double>> by_class;      // of particle properties, by class
  std::vector<double> wall;                       // of particle scalars: what walls hold; NaN: nothing
};

struct ScalarPlan {
  std::vector<GasScalar> gas;
  std::vector<ParticleScalar> particles;
  std::vector<EffectQuantities> effects;   // those that declare quantities

  bool empty() const { return gas.empty() && particles.empty(); }
};

/// Asks every effect what it uses and configures it with the values of its properties. Throws InputError for a value that a
/// case must give and does not, and PluginError with an effect's own words. [setup]
ScalarPlan plan_scalars(const ModelScene& scene, const std::vector<EffectModel>& effects);

}  // namespace similitude
