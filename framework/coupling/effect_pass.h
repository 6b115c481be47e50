#pragma once
/// An effect's force on particles, in blocks, with its reaction on the gas. Parcel weight and accounts are applied here.

#include <vector>

#include "coupling/cell_map.h"
#include "coupling/gas_motion.h"
#include "loader/catalogue.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude {

class EffectPass {
 public:
  /// The effect must have a particle pass and must outlive this, as must `motion`, which has what the effect reads of the gas; null
  /// if it reads nothing. [setup]
  EffectPass(const ModelScene& scene, const Grid& grid, const EffectModel& effect, const GasMotion* motion = nullptr);

  /// After Coupling::interpolate and before the sub-steps: adds the explicit force to stress_force, the linear coefficient
  /// to K and the added mass to the particles', all held over the gas step. What the gas was not charged for stays in drag_impulse, so settle_accounts() owes it.
  /// Throws SimulationError if the effect reports a failure.
  const char* id() const { return effect_.descriptor().id; }
  void apply(ParticleStore& particles, const Column<double>& gas_fraction, double gas_dt);

 private:
  void apply_block(std::size_t block, ParticleStore& particles, double gas_dt, Column<double>& workspace,
                   similitude_status& status) const;

  CellMap map_;
  const EffectModel& effect_;
  const GasMotion* motion_;
  similitude_effect_needs needs_;
  std::vector<ParticleClass> classes_;
  double gas_density_, gas_viscosity_;   // [kg/m^3], [Pa s]
  CellRows fraction_;                    // w: gas fraction
  std::vector<Column<double>> workspaces_;
};

}  // namespace similitude
