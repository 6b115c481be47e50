#pragma once
/// Conservative smoothing of cell fields: diffusion in flux form through open faces only. Self-adjoint, positive, and
/// the sum over cells stays what it was, to rounding.

#include <array>
#include <cstddef>
#include <vector>

#include "coupling/cell_map.h"

namespace similitude {

class Smoothing {
 public:
  /// `length` [m]: full width at half maximum of tent and smoothing together. A Gaussian of that width has variance
  /// length^2 / (8 ln 2); the tent of one cell brings h^2/6 of it, diffusion adds the rest, each axis for itself. Cells
  /// that are wide already get nothing.
  Smoothing(const CellMap& map, double length);

  /// Explicit steps of one apply(). Each keeps at least half of a cell's content in place, so that the chequer pattern
  /// decays and the smoothing as a whole is positive definite.
  int steps() const { return steps_; }
  /// [m^2], variance that apply() adds along an axis.
  double added_variance(int axis) const { return variance_[static_cast<std::size_t>(axis)]; }

  void apply(CellRows& field);

 private:
  /// Cells in a row whose neighbours lie equally far from them.
  struct Run {
    std::ptrdiff_t begin, end;                  // [doubles], four a cell
    std::array<std::ptrdiff_t, 6> neighbour;    // [doubles], from a cell to those at -x, +x, … +z; 0 where a face is closed
  };
  void find_runs();

  const CellMap& map_;
  std::vector<Run> runs_;
  std::array<double, 3> variance_{};   // [m^2]
  std::array<double, 3> share_{};      // [-], of a cell that passes one face in one step
  int steps_ = 0;
  CellRows scratch_;
};

}  // namespace similitude
