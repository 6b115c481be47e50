#pragma once
/// Uniform Cartesian cells of one bed, with what lies on every face. Owns the arrays that similitude_grid points to.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <similitude/abi.h>

#include "scene/scene.h"

namespace similitude {

class Grid {
 public:
  /// Lays patches, walls and baffles on faces. Throws InputError (scene/messages.h) naming the nearest aligned values when a
  /// patch or baffle is off the cell faces, outside its face, or overlaps another. Lengths in the messages are those of the
  /// scene given: build a Grid from the real bed first, so that a user reads his own numbers.
  template <class Bed>
  explicit Grid(const Scene<Bed>& scene);
  Grid(const Grid&) = delete;
  Grid& operator=(const Grid&) = delete;

  int cells(int axis) const { return table_.cells[axis]; }
  double spacing(int axis) const { return table_.spacing[axis]; }  // [m]
  bool periodic(int axis) const { return table_.periodic[axis] != 0; }
  std::size_t cell_count() const {
    return static_cast<std::size_t>(cells(0)) * static_cast<std::size_t>(cells(1)) * static_cast<std::size_t>(cells(2));
  }
  std::size_t face_count(int axis) const { return faces_[static_cast<std::size_t>(axis)].size(); }
  double cell_volume() const { return spacing(0) * spacing(1) * spacing(2); }  // [m^3]
  std::size_t cell(int i, int j, int k) const { return row(i, j, k, cells(0), cells(1)); }
  /// Between cell i-1 and i along `axis`.
  std::size_t face(int axis, int i, int j, int k) const {
    return row(i, j, k, cells(0) + (axis == 0 ? 1 : 0), cells(1) + (axis == 1 ? 1 : 0));
  }
  std::uint8_t face_kind(int axis, std::size_t face) const { return faces_[static_cast<std::size_t>(axis)][face]; }
  bool open(int axis, std::size_t face) const { return face_kind(axis, face) == SIMILITUDE_FACE_OPEN; }
  /// What crosses the plugin boundary; valid as long as this grid. A patch's velocity is a vector of space: an inlet on a
  /// high side has a negative normal component.
  const similitude_grid& table() const { return table_; }

 private:
  static std::size_t row(int i, int j, int k, int nx, int ny) {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(nx) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(ny) * static_cast<std::size_t>(k));
  }

  similitude_grid table_{};
  std::array<std::vector<std::uint8_t>, 3> faces_;
  std::vector<similitude_patch> patches_;
  std::vector<std::string> patch_names_;
};

extern template Grid::Grid(const Scene<RealBed>&);
extern template Grid::Grid(const Scene<ModelBed>&);

}  // namespace similitude
