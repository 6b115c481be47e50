#pragma once
/// Which cells touch through open faces, and the tent kernel on them. Walls, patches and baffles are closed here once;
/// deposit, interpolation and smoothing all walk these links, so none of them can cross what the others cannot.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fluid/grid.h"
#include "particles/pack.h"
#include "particles/store.h"

namespace similitude {

/// Four numbers per cell that are deposited, smoothed and interpolated together.
using CellRows = Column<Row>;

/// The cells that one particle touches and their weights, which sum to 1. A cell may appear more than once.
struct Stencil {
  std::array<std::uint32_t, 8> cell;   // cell[m + 4] is cell[m] or its neighbour along z
  std::array<double, 8> weight;        // [-], >= 0
  std::int32_t layer_step;             // -1 or +1: where along z the neighbours lie
};

class CellMap {
 public:
  explicit CellMap(const Grid& grid);

  std::size_t cell_count() const { return links_.size(); }
  std::size_t layer_size() const { return layer_size_; }   // cells of one z layer
  int layers() const { return cells_[2]; }
  bool periodic_layers() const { return periodic_[2]; }
  double spacing(int axis) const { return spacing_[static_cast<std::size_t>(axis)]; }
  double cell_volume() const { return spacing_[0] * spacing_[1] * spacing_[2]; }

  /// The neighbour of `cell` at -x, +x, -y, +y, -z, +z; the cell itself where the face between is not open.
  const std::array<std::uint32_t, 6>& links(std::size_t cell) const { return links_[cell]; }

  /// The cell a position lies in. Periodic directions wrap; else positions outside count for the nearest cell.
  std::size_t cell_at(const Row& position) const {
    const Place x = place(position.x, 0), y = place(position.y, 1), z = place(position.z, 2);
    return index(x.cell, y.cell, z.cell);
  }

  /// The tent of one cell width around a position. Steps along x, then y, then z, each only through an open face: a
  /// weight that cannot pass stays where it is.
  Stencil stencil(const Row& position) const {
    const Place x = place(position.x, 0), y = place(position.y, 1), z = place(position.z, 2);
    Stencil s;
    s.cell[0] = static_cast<std::uint32_t>(index(x.cell, y.cell, z.cell));
    s.cell[1] = links_[s.cell[0]][static_cast<std::size_t>(x.direction)];
    for (std::size_t m = 0; m < 2; ++m) s.cell[2 + m] = links_[s.cell[m]][2 + static_cast<std::size_t>(y.direction)];
    for (std::size_t m = 0; m < 4; ++m) s.cell[4 + m] = links_[s.cell[m]][4 + static_cast<std::size_t>(z.direction)];
    s.layer_step = 2 * z.direction - 1;
    for (std::size_t m = 0; m < 8; ++m) {
      s.weight[m] = (m & 1 ? x.share : 1 - x.share) * (m & 2 ? y.share : 1 - y.share) * (m & 4 ? z.share : 1 - z.share);
    }
    return s;
  }

 private:
  /// Along one axis: the cell, which neighbour the tent reaches (0 lower, 1 upper), and that neighbour's share.
  struct Place {
    int cell, direction;
    double share;   // [-], 0 ... 1/2
  };

  Place place(double coordinate, std::size_t axis) const {
    const double s = (coordinate - origin_[axis]) / spacing_[axis];
    const double lower = std::floor(s);
    int cell = static_cast<int>(lower);
    double from_centre = s - lower - 0.5;   // [-], -1/2 ... 1/2
    if (cell < 0 || cell >= cells_[axis]) {
      if (periodic_[axis]) {
        cell = (cell % cells_[axis] + cells_[axis]) % cells_[axis];
      } else {
        from_centre = cell < 0 ? -0.5 : 0.5;
        cell = cell < 0 ? 0 : cells_[axis] - 1;
      }
    }
    return {cell, from_centre < 0 ? 0 : 1, std::abs(from_centre)};
  }

  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(cells_[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(cells_[1]) * static_cast<std::size_t>(k));
  }

  std::array<int, 3> cells_{};
  std::array<bool, 3> periodic_{};
  std::array<double, 3> spacing_{}, origin_{};
  std::size_t layer_size_ = 0;
  Column<std::array<std::uint32_t, 6>> links_;
};

/// The adjoint of a unit deposit: the weighted mean of a cell field at a position.
inline Row gather(const Stencil& s, const CellRows& field) {
  pack::V4 total = pack::all(0);
  for (std::size_t m = 0; m < 8; ++m) total += pack::all(s.weight[m]) * pack::load(field[s.cell[m]]);
  Row sum;
  pack::store(sum, total);
  return sum;
}

}  // namespace similitude
