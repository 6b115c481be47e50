#include "output/gas_boundary.h"

#include <algorithm>

#include "fluid/face_tables.h"

namespace similitude {

GasBoundary::GasBoundary(const Grid& grid) : grid_(grid) {
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, 3> faces{grid.cells(0), grid.cells(1), grid.cells(2)};
    ++faces[static_cast<std::size_t>(axis)];
    for (int k = 0; k < faces[2]; ++k) {
      for (int j = 0; j < faces[1]; ++j) {
        for (int i = 0; i < faces[0]; ++i) {
          const std::size_t face = grid.face(axis, i, j, k);
          if (grid.open(axis, face)) continue;
          std::array<int, 3> above{i, j, k}, below{i, j, k};
          --below[static_cast<std::size_t>(axis)];
          const int patch = std::max(grid.face_kind(axis, face) - SIMILITUDE_FACE_PATCH, -1);
          const auto add = [&](std::array<int, 3> at, int inward) {
            const auto a = static_cast<std::size_t>(axis);
            if (at[a] < 0 || at[a] >= grid.cells(axis)) return;
            std::array<int, 3> next = at;
            next[a] += inward;
            const std::array<int, 3>& between = inward > 0 ? next : at;
            const bool has_next = next[a] >= 0 && next[a] < grid.cells(axis) &&
                                  grid.open(axis, grid.face(axis, between[0], between[1], between[2]));
            const std::size_t cell = grid.cell(at[0], at[1], at[2]);
            sides_.push_back({cell, has_next ? grid.cell(next[0], next[1], next[2]) : cell, a, static_cast<double>(inward), patch});
          };
          add(above, +1);
          add(below, -1);
        }
      }
    }
  }
}

BoundaryAction GasBoundary::action(const GasFields& gas, const Column<double>& gas_fraction, double gas_density, double time) const {
  const std::size_t cells = grid_.cell_count();
  const similitude_patch* patches = grid_.table().patches;
  BoundaryAction sum;
  for (const Side& side : sides_) {
    const double area = grid_.cell_volume() / grid_.spacing(static_cast<int>(side.axis));
    double pressure = gas.pressure[side.cell] + (gas.pressure[side.cell] - gas.pressure[side.behind]) / 2;
    if (side.patch >= 0) {
      const similitude_patch& patch = patches[side.patch];
      std::array<double, 3> velocity{}, superficial{};   // [m/s], of what crosses, and per area of the patch
      for (std::size_t a = 0; a < 3; ++a) {
        if (patch.kind == SIMILITUDE_PATCH_PRESSURE) {
          velocity[a] = gas.velocity[a * cells + side.cell];
          superficial[a] = gas_fraction[side.cell] * velocity[a];
        } else {
          velocity[a] = superficial[a] = patch.velocity[a] * flow::ramp_factor(patch, time);
        }
      }
      if (patch.kind == SIMILITUDE_PATCH_PRESSURE) pressure = patch.pressure;
      const double into = side.inward * superficial[side.axis] * area;   // [m^3/s]
      for (std::size_t a = 0; a < 3; ++a) sum.force[a] += gas_density * into * velocity[a];
      sum.pumping += pressure * into;
    }
    sum.force[side.axis] += side.inward * pressure * area;
  }
  return sum;
}

}  // namespace similitude
