#pragma once
/// K of every particle by the drag law, in blocks of plain columns: gather, let the plugin map, scatter.

#include <vector>

#include "coupling/cell_map.h"
#include "coupling/seen_by_gas.h"
#include "loader/catalogue.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude {

/// Drag laws give K of model A. Where the gas alone carries the stress (model B), the whole force is K / eps.
enum class DragForm { as_given, over_gas_fraction };

class ExchangeCoefficient {
 public:
  ExchangeCoefficient(const ModelScene& scene, const CellMap& map, const DragModel& law, DragForm form);

  bool needs_sauter_diameter() const { return needs_.sauter_diameter != 0; }

  /// Writes K [kg/s], parcel weight included, into particles.gas[].w. `gas` holds per cell: velocity of the gas [m/s] and, as
  /// the fourth, the gas fraction. `sizes` holds per cell sum d^3 as x and sum d^2 as y of the solids, smoothed; it is read only
  /// if the law needs the Sauter diameter. Throws SimulationError with the law's own words, or when K is not a number >= 0.
  void evaluate(ParticleStore& particles, const CellRows& gas, const CellRows& sizes);

  /// [m], what the drag law sees of particle row p.
  double diameter_of(const ParticleStore& particles, std::size_t p) const {
    return drag_diameter(classes_[particles.species[p]], particles, p);
  }
  /// [m^3], that row p displaces: all physical particles it stands for.
  double displaced_volume(const ParticleStore& particles, std::size_t p) const;

 private:
  static constexpr std::size_t k_block_rows = 256;
  enum { k_diameter, k_gas_fraction, k_slip_speed, k_gas_density, k_gas_viscosity, k_sauter, k_cell_size, k_exchange, k_columns };
  using Workspace = Column<double>;   // k_columns columns of k_block_rows

  void evaluate_block(std::size_t block, ParticleStore& particles, const CellRows& gas, const CellRows& sizes,
                      Workspace& columns, similitude_status& status) const;

  const CellMap& map_;
  const DragModel& law_;
  DragForm form_;
  std::vector<ParticleClass> classes_;
  double gas_density_, gas_viscosity_;   // [kg/m^3], [Pa s]
  double cell_size_;                     // [m], cube root of the cell's volume
  similitude_drag_needs needs_{};
  std::vector<Workspace> workspaces_;    // one per thread
};

}  // namespace similitude
