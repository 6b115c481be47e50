#pragma once
/// Effects that act on gas cells: the viscosity that motion below the cells adds, from the strain that the cells resolve.

#include <vector>

#include "coupling/coupling.h"
#include "fluid/grid.h"
#include "loader/catalogue.h"
#include "scene/scene.h"

namespace similitude {

class CellPass {
 public:
  /// The effect has a pass over cells; scene, grid and effect outlive this. [setup]
  CellPass(const ModelScene& scene, const Grid& grid, const EffectModel& effect) : scene_(scene), grid_(grid), effect_(effect) {}

  const char* id() const { return effect_.descriptor().id; }
  /// Before the gas step: adds to gas.added_viscosity, from the velocity of the last step. `time` [s] is that step's end.
  /// Throws SimulationError with the effect's own words. [main]
  void apply(GasFields& gas, const Column<double>& gas_fraction, double time) const;

 private:
  const ModelScene& scene_;
  const Grid& grid_;
  const EffectModel& effect_;
};

}  // namespace similitude
