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
  /// patch or baffle is off the cell faces, outside its face, or overlaps another.
  template <class Bed>
  explicit Grid(const Scene<Bed>& scene);
  Grid(const Grid&) = delete;
  Grid& operator=(const Grid&) = delete;

  int cells(int axis) const { return table_.cells[axis]; }
  double spacing(int axis) const { return table_.spacing[axis]; }
  bool periodic(int axis) const { return table_.periodic[axis] != 0; }
  std::size_t cell_count() const;
  std::size_t face_count(int axis) const;
  double cell_volume() const;
  std::size_t cell(int i, int j, int k) const;
  std::size_t face(int axis, int i, int j, int k) const;   // between cell i-1 and i along `axis`
  std::uint8_t face_kind(int axis, std::size_t face) const { return faces_[static_cast<std::size_t>(axis)][face]; }
  bool open(int axis, std::size_t face) const { return face_kind(axis, face) == SIMILITUDE_FACE_OPEN; }
  /// What crosses the plugin boundary; valid as long as this grid.
  const similitude_grid& table() const { return table_; }

 private:
  similitude_grid table_{};
  std::array<std::vector<std::uint8_t>, 3> faces_;
  std::vector<similitude_patch> patches_;
  std::vector<std::string> patch_names_;
};

extern template Grid::Grid(const Scene<RealBed>&);
extern template Grid::Grid(const Scene<ModelBed>&);

}  // namespace similitude
