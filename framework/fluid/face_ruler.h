#pragma once
/// Positions and intervals of a bed counted in cells. Throws InputError for whatever does not lie on cell faces.

#include <array>
#include <string>

#include "scene/scene.h"

namespace similitude {

/// Whole cells from `low` up to `high`, along one axis.
struct CellRange {
  int low = 0, high = 0;
};

class FaceRuler {
 public:
  /// Throws if the domain is not a whole number of cells. Cells below `diameter` [m], that of the largest particles, are never advised.
  FaceRuler(const std::array<double, 3>& size, const std::array<double, 3>& cell, double diameter = 0);

  int cells(int axis) const { return cells_[static_cast<std::size_t>(axis)]; }
  /// The cells that an interval covers. `owner` is what it must not stick out of: "the bottom face", "the domain".
  CellRange range(int axis, Interval interval, const SourceMark& mark, const std::string& path, const std::string& owner) const;
  /// The face at a position strictly inside the domain.
  int interior_face(int axis, double position, const SourceMark& mark, const std::string& path) const;

 private:
  std::array<double, 3> size_, cell_;
  double diameter_;
  std::array<int, 3> cells_;
};

}  // namespace similitude
