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
  std::array<std::uint32_t, 8> cell;              // cell[m + 4] is cell[m] or its neighbour along z
  alignas(32) std::array<double, 8> weight;       // [-], >= 0
  std::int32_t layer_step;                        // -1 or +1: where along z the neighbours lie
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
    const Place at = place(position);
    return index(at.cell[0], at.cell[1], at.cell[2]);
  }

  /// The tent of one cell width around a position. Steps along x, then y, then z, each only through an open face: a
  /// weight that cannot pass stays where it is.
  Stencil stencil(const Row& position) const {
    const Place at = place(position);
    const unsigned lower = pack::bits(at.from_centre < 0);   // which neighbour the tent reaches along each axis
    const std::size_t x = lower & 1 ? 0 : 1, y = lower & 2 ? 2 : 3, z = lower & 4 ? 4 : 5;
    Stencil s;
    s.cell[0] = static_cast<std::uint32_t>(index(at.cell[0], at.cell[1], at.cell[2]));
    s.cell[1] = links_[s.cell[0]][x];
    for (std::size_t m = 0; m < 2; ++m) s.cell[2 + m] = links_[s.cell[m]][y];
    for (std::size_t m = 0; m < 4; ++m) s.cell[4 + m] = links_[s.cell[m]][z];
    s.layer_step = lower & 4 ? -1 : 1;
    const pack::V4 share = at.from_centre < 0 ? -at.from_centre : at.from_centre;   // [-], the neighbours', 0 ... 1/2
    const pack::V4 rest = pack::all(1) - share;
    const pack::V4 in_layer = __builtin_shufflevector(rest, share, 0, 4, 0, 4) * __builtin_shufflevector(rest, share, 1, 1, 5, 5);
    pack::store(s.weight.data(), in_layer * pack::all(rest[2]));
    pack::store(s.weight.data() + 4, in_layer * pack::all(share[2]));
    return s;
  }

 private:
  using Cells4 = std::int32_t __attribute__((vector_size(16)));

  /// Three axes at once; the fourth number means nothing.
  struct Place {
    Cells4 cell;
    pack::V4 from_centre;   // [-], -1/2 ... 1/2
  };

  Place place(const Row& position) const {
    const pack::V4 s = (pack::load(position) - pack::load(origin_)) / pack::load(width_);
    const pack::V4 lower = pack::floor(s);
    Place at{__builtin_convertvector(lower, Cells4), s - lower - 0.5};
    constexpr unsigned three_axes = 7;
    if ((~pack::bits((lower >= 0) & (lower < pack::load(extent_))) & three_axes) != 0) [[unlikely]] bring_inside(at);
    return at;
  }

  void bring_inside(Place& at) const;

  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(cells_[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(cells_[1]) * static_cast<std::size_t>(k));
  }

  std::array<int, 3> cells_{};
  std::array<bool, 3> periodic_{};
  std::array<double, 3> spacing_{};   // [m]
  Row origin_, width_, extent_;       // [m], [m] and in cells, by axis
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
