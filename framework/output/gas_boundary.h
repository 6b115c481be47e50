#pragma once
/// What the domain's walls, plates and patches do to the gas: for the books, from the fields alone, so that it checks what solver and
/// coupling say of themselves.

#include <array>
#include <vector>

#include "coupling/coupling.h"
#include "fluid/grid.h"

namespace similitude {

/// At an instant; of the simulated bed.
struct BoundaryAction {
  std::array<double, 3> force{};   // [N], of pressure on all that is not open, and momentum carried through patches
  double pumping = 0;              // [W], pressure times volume flow into the domain, summed over patches
};

/// Friction of walls is left out, and the pressure on a face is carried there from the cell with the gradient before it: right to
/// a part of half a cell.
class GasBoundary {
 public:
  explicit GasBoundary(const Grid& grid);
  /// `time` [s] is for the ramps of inlets.
  BoundaryAction action(const GasFields& gas, const Column<double>& gas_fraction, double gas_density, double time) const;

 private:
  /// One side of a face that is not open: the cell it bounds.
  struct Side {
    std::size_t cell, behind;   // the cell, and the next one away from the face (the same if there is none)
    std::size_t axis;
    double inward;              // +1: the cell lies above the face along the axis
    int patch;                  // -1: a wall or plate
  };
  const Grid& grid_;
  std::vector<Side> sides_;
};

}  // namespace similitude
