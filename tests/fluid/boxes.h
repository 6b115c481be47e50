#pragma once
/// Grids for tests, written down face by face as a host would hand them to a fluid plugin.

#include <array>
#include <cstdint>
#include <vector>

#include "fluid/staggered.h"

namespace similitude::test {

struct BoxOptions {
  std::array<int, 3> cells{4, 4, 4};
  std::array<double, 3> spacing{1, 1, 1};
  std::array<bool, 3> periodic{false, false, false};
  std::uint8_t walls = SIMILITUDE_FACE_NO_SLIP;
};

/// Owns the arrays of a similitude_grid; sides are walls unless periodic.
class Box {
 public:
  explicit Box(const BoxOptions& options) {
    table_.struct_size = sizeof table_;
    for (std::size_t a = 0; a < 3; ++a) {
      table_.cells[a] = options.cells[a];
      table_.spacing[a] = options.spacing[a];
      table_.periodic[a] = options.periodic[a] ? 1 : 0;
    }
    const Staggered mesh(table_);
    for (std::size_t a = 0; a < 3; ++a) {
      kinds_[a].assign(static_cast<std::size_t>(mesh.face_count[a]), SIMILITUDE_FACE_OPEN);
      table_.face_kind[a] = kinds_[a].data();
    }
    for (std::size_t a = 0; a < 3; ++a) {
      if (options.periodic[a]) continue;
      set_side(a, 0, options.walls);
      set_side(a, 1, options.walls);
    }
  }
  Box(const Box&) = delete;
  Box& operator=(const Box&) = delete;

  const similitude_grid& table() const { return table_; }
  Staggered mesh() const { return Staggered(table_); }

  /// Faces of one side of the domain: side 0 low, 1 high.
  void set_side(std::size_t axis, int side, std::uint8_t kind) {
    set_faces(axis, side == 0 ? 0 : table_.cells[axis], {0, 0, 0}, {table_.cells[0], table_.cells[1], table_.cells[2]}, kind);
  }
  /// Faces at index `at` along their axis, over cells [low, high) across.
  void set_faces(std::size_t axis, int at, std::array<int, 3> low, std::array<int, 3> high, std::uint8_t kind) {
    const Staggered mesh(table_);
    low[axis] = at;
    high[axis] = at + 1;
    for (int k = low[2]; k < high[2]; ++k) {
      for (int j = low[1]; j < high[1]; ++j) {
        for (int i = low[0]; i < high[0]; ++i) kinds_[axis][static_cast<std::size_t>(mesh.face(axis, {i, j, k}))] = kind;
      }
    }
  }
  /// The face kind of a new velocity patch; `velocity` is a vector of space.
  std::uint8_t velocity_patch(const char* name, std::array<double, 3> velocity, double ramp = 0) {
    similitude_patch patch{};
    patch.kind = SIMILITUDE_PATCH_VELOCITY;
    patch.name = name;
    for (std::size_t a = 0; a < 3; ++a) patch.velocity[a] = velocity[a];
    patch.ramp = ramp;
    return add(patch);
  }
  std::uint8_t pressure_patch(const char* name, double pressure) {
    similitude_patch patch{};
    patch.kind = SIMILITUDE_PATCH_PRESSURE;
    patch.name = name;
    patch.pressure = pressure;
    return add(patch);
  }

 private:
  std::uint8_t add(similitude_patch patch) {
    patch.struct_size = sizeof patch;
    patches_.push_back(patch);
    table_.patches = patches_.data();
    table_.patch_count = static_cast<std::uint32_t>(patches_.size());
    return static_cast<std::uint8_t>(SIMILITUDE_FACE_PATCH + patches_.size() - 1);
  }

  similitude_grid table_{};
  std::array<std::vector<std::uint8_t>, 3> kinds_;
  std::vector<similitude_patch> patches_;
};

}  // namespace similitude::test
