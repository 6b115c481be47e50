#include "coupling/cell_map.h"

namespace similitude {

CellMap::CellMap(const Grid& grid) : links_(grid.cell_count()) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    cells_[a] = grid.cells(axis);
    periodic_[a] = grid.periodic(axis);
    spacing_[a] = grid.spacing(axis);
  }
  const double* const origin = grid.table().origin;
  origin_ = {origin[0], origin[1], origin[2], 0};
  width_ = {spacing_[0], spacing_[1], spacing_[2], 1};
  extent_ = {static_cast<double>(cells_[0]), static_cast<double>(cells_[1]), static_cast<double>(cells_[2]), 0};
  layer_size_ = static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]);

  for (int k = 0; k < cells_[2]; ++k) {
    for (int j = 0; j < cells_[1]; ++j) {
      for (int i = 0; i < cells_[0]; ++i) {
        const std::array<int, 3> here{i, j, k};
        auto& link = links_[index(i, j, k)];
        for (std::size_t direction = 0; direction < 6; ++direction) {
          const std::size_t axis = direction / 2;
          const bool upper = direction % 2 == 1;
          std::array<int, 3> face = here, there = here;
          if (upper) ++face[axis];
          there[axis] += upper ? 1 : -1;
          const bool outside = there[axis] < 0 || there[axis] >= cells_[axis];
          const int of_axis = static_cast<int>(axis);
          const bool passes = (!outside || periodic_[axis]) && grid.open(of_axis, grid.face(of_axis, face[0], face[1], face[2]));
          if (outside) there[axis] = upper ? 0 : cells_[axis] - 1;
          if (!passes) there = here;
          link[direction] = static_cast<std::uint32_t>(index(there[0], there[1], there[2]));
        }
      }
    }
  }
}

void CellMap::bring_inside(Place& at) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::int32_t cell = at.cell[axis];
    if (cell >= 0 && cell < cells_[axis]) continue;
    if (periodic_[axis]) {
      cell = (cell % cells_[axis] + cells_[axis]) % cells_[axis];
    } else {
      at.from_centre[axis] = cell < 0 ? -0.5 : 0.5;
      cell = cell < 0 ? 0 : cells_[axis] - 1;
    }
    at.cell[axis] = cell;
  }
}

}  // namespace similitude
