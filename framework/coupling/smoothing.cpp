#include "coupling/smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "particles/pack.h"

namespace similitude {

Smoothing::Smoothing(const CellMap& map, double length) : map_(map) {
  const double wanted = length * length / (8 * std::numbers::ln2);   // [m^2]
  double cells_squared = 0;                                          // [-], sum over axes of variance in cells
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double h = map.spacing(static_cast<int>(axis));
    variance_[axis] = std::max(0.0, wanted - h * h / 6);
    cells_squared += variance_[axis] / (h * h);
  }
  // A step that passes a share s through each face adds the variance 2 s h^2 along that axis; the shares of all six faces
  // may not exceed one half.
  steps_ = static_cast<int>(std::ceil(2 * cells_squared));
  if (steps_ == 0) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double h = map.spacing(static_cast<int>(axis));
    share_[axis] = variance_[axis] / (h * h) / (2 * steps_);
  }
  scratch_.resize(map.cell_count());
}

void Smoothing::apply(CellRows& field) {
  const auto cells = static_cast<std::ptrdiff_t>(map_.cell_count());
  const pack::V4 sx = pack::all(share_[0]), sy = pack::all(share_[1]), sz = pack::all(share_[2]);
  for (int step = 0; step < steps_; ++step) {
    const Row* const from = field.data();
    Row* const to = scratch_.data();
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t c = 0; c < cells; ++c) {
      const auto& link = map_.links(static_cast<std::size_t>(c));
      const auto at = [&](std::size_t n) { return pack::load(from[link[n]]); };
      const pack::V4 here = pack::load(from[c]);
      // Differences first: a closed face links the cell to itself and passes exactly nothing.
      const pack::V4 along_x = (at(0) - here) + (at(1) - here);
      const pack::V4 along_y = (at(2) - here) + (at(3) - here);
      const pack::V4 along_z = (at(4) - here) + (at(5) - here);
      pack::store(to[c], here + sx * along_x + sy * along_y + sz * along_z);
    }
    field.swap(scratch_);
  }
}

}  // namespace similitude
