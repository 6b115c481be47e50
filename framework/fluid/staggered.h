#pragma once
/// Index arithmetic of similitude_grid for solvers that keep velocities on faces. A face's two cells, a cell's two faces,
/// neighbours with periodic wrap. Signed 64-bit indices; -1 where there is nothing.

#include <array>
#include <cstddef>
#include <cstdint>

#include <similitude/abi.h>

namespace similitude {

using Index = std::ptrdiff_t;
using Triple = std::array<Index, 3>;

/// Loops over fewer rows are not worth a second thread.
inline constexpr Index k_worth_threads = 8192;

struct Staggered {
  explicit Staggered(const similitude_grid& table) : grid(&table) {
    for (std::size_t a = 0; a < 3; ++a) {
      cells[a] = table.cells[a];
      spacing[a] = table.spacing[a];
      periodic[a] = table.periodic[a] != 0;
    }
    cell_count = cells[0] * cells[1] * cells[2];
    for (std::size_t a = 0; a < 3; ++a) {
      face_extent[a] = cells;
      face_extent[a][a] += 1;
      face_count[a] = face_extent[a][0] * face_extent[a][1] * face_extent[a][2];
    }
  }

  Index cell(const Triple& at) const { return at[0] + cells[0] * (at[1] + cells[1] * at[2]); }
  Index face(std::size_t axis, const Triple& at) const {
    return at[0] + face_extent[axis][0] * (at[1] + face_extent[axis][1] * at[2]);
  }
  /// From one face of `axis` to the next one along `direction`.
  Index face_stride(std::size_t axis, std::size_t direction) const {
    return direction == 0 ? 1 : direction == 1 ? face_extent[axis][0] : face_extent[axis][0] * face_extent[axis][1];
  }
  std::uint8_t kind(std::size_t axis, Index face_row) const { return grid->face_kind[axis][face_row]; }
  bool is_open(std::size_t axis, Index face_row) const { return kind(axis, face_row) == SIMILITUDE_FACE_OPEN; }
  /// The patch on a face, or null.
  const similitude_patch* patch(std::size_t axis, Index face_row) const {
    const int kind_here = kind(axis, face_row);
    return kind_here >= SIMILITUDE_FACE_PATCH ? &grid->patches[kind_here - SIMILITUDE_FACE_PATCH] : nullptr;
  }
  bool is_pressure_kind(std::uint8_t face_kind) const {
    return face_kind >= SIMILITUDE_FACE_PATCH &&
           grid->patches[face_kind - SIMILITUDE_FACE_PATCH].kind == SIMILITUDE_PATCH_PRESSURE;
  }
  bool is_pressure(std::size_t axis, Index face_row) const { return is_pressure_kind(kind(axis, face_row)); }

  /// The cells below and above a face, -1 outside the domain.
  std::array<Index, 2> cells_of_face(std::size_t axis, const Triple& at) const {
    Triple below = at, above = at;
    below[axis] -= 1;
    if (periodic[axis]) {
      if (below[axis] < 0) below[axis] += cells[axis];
      if (above[axis] >= cells[axis]) above[axis] -= cells[axis];
    }
    return {below[axis] < 0 ? -1 : cell(below), above[axis] >= cells[axis] ? -1 : cell(above)};
  }
  /// How many faces along their own axis are different ones: the last face of a periodic direction is the first.
  Index distinct_faces(std::size_t axis) const { return periodic[axis] ? cells[axis] : cells[axis] + 1; }

  double cell_volume() const { return spacing[0] * spacing[1] * spacing[2]; }  // [m^3]
  double face_area(std::size_t axis) const {                                   // [m^2]
    return spacing[(axis + 1) % 3] * spacing[(axis + 2) % 3];
  }

  const similitude_grid* grid;
  Triple cells{};
  std::array<double, 3> spacing{};  // [m]
  std::array<bool, 3> periodic{};
  Index cell_count = 0;
  std::array<Triple, 3> face_extent{};  // by axis
  std::array<Index, 3> face_count{};
};

}  // namespace similitude
