#include "coupling/smoothing.h"

#include <cmath>
#include <numbers>

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
  const auto [sx, sy, sz] = share_;
  for (int step = 0; step < steps_; ++step) {
    const Row* const from = field.data();
    Row* const to = scratch_.data();
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t c = 0; c < cells; ++c) {
      const auto& link = map_.links(static_cast<std::size_t>(c));
      const Row here = from[c];
      const Row &west = from[link[0]], &east = from[link[1]], &front = from[link[2]], &back = from[link[3]],
                &below = from[link[4]], &above = from[link[5]];
      // Differences first: a closed face links the cell to itself and passes exactly nothing.
      to[c].x = here.x + sx * ((west.x - here.x) + (east.x - here.x)) + sy * ((front.x - here.x) + (back.x - here.x)) +
                sz * ((below.x - here.x) + (above.x - here.x));
      to[c].y = here.y + sx * ((west.y - here.y) + (east.y - here.y)) + sy * ((front.y - here.y) + (back.y - here.y)) +
                sz * ((below.y - here.y) + (above.y - here.y));
      to[c].z = here.z + sx * ((west.z - here.z) + (east.z - here.z)) + sy * ((front.z - here.z) + (back.z - here.z)) +
                sz * ((below.z - here.z) + (above.z - here.z));
      to[c].w = here.w + sx * ((west.w - here.w) + (east.w - here.w)) + sy * ((front.w - here.w) + (back.w - here.w)) +
                sz * ((below.w - here.w) + (above.w - here.w));
    }
    field.swap(scratch_);
  }
}

}  // namespace similitude
