#pragma once
/// The grids of the multigrid preconditioner. Each level halves one axis of the level above; groups of cells never reach
/// across a baffle, so that a coarse cell lies on one side of it. Coarse faces carry the series resistance between the
/// centres they connect, and interpolation follows the same resistances: linear where coefficients are uniform, and
/// nothing leaks through a blocked face.

#include <array>
#include <vector>

#include "fluid/staggered.h"

namespace similitude::multigrid {

/// Cells with one ghost layer. Ghosts hold zero, or the other end's values in a periodic direction.
struct Level {
  Level(const Triple& cells, const std::array<bool, 3>& is_periodic);

  Index at(Index i, Index j, Index k) const { return 1 + i + row * (1 + j) + plane * (1 + k); }
  Index stride(std::size_t axis) const { return axis == 0 ? 1 : axis == 1 ? row : plane; }
  Index cell_count() const { return n[0] * n[1] * n[2]; }
  /// The cells of plane k lie in [at(0,0,k), at(0,0,k) + span()); the ghosts between its rows are harmless.
  Index span() const { return (n[1] - 1) * row + n[0]; }

  /// Copies the far ends of periodic directions into the ghosts.
  void refresh_ghosts(std::vector<double>& field) const;

  Triple n;
  std::array<bool, 3> periodic;
  Index row, plane;
  bool smoothed = true;  // false: a step between two smoothed levels, transfers only

  // A x = diagonal x - sum of weight times neighbour. All weights per volume of the finest cell.
  std::array<std::vector<double>, 3> weight;  // of a cell's lower face
  std::array<std::vector<double>, 3> outlet;  // to the zero pressure beyond pressure patches, by axis
  std::vector<double> diagonal;
  std::vector<double> inverse_diagonal;       // zero in ghosts and in cells cut off on all sides

  std::vector<double> x, b, residual, direction, scratch;

  // To the next level.
  std::size_t halved_axis = 0;
  std::vector<Index> start;          // first cell of every group along the halved axis, and the end
  std::vector<double> own, lean;     // shares of a cell in its group and in the neighbour group it is next to

  // Set-up only: positions that no group may reach across, along every axis.
  std::array<std::vector<Index>, 3> barriers;
};

/// From the grid itself down to a few dozen cells. The number of levels and groups depends on the grid only.
std::vector<Level> make_levels(const Staggered& mesh);
/// Coefficients of the finest level, from face coefficients in the layout of similitude_grid.
void set_finest(Level& finest, const Staggered& mesh, const std::array<const double*, 3>& coefficient);
/// Coefficients of the next level and the shares that connect the two.
void set_coarser(Level& fine, Level& coarse);

/// coarse.b = transpose of interpolation applied to `from`, a field of the fine level whose ghosts may be overwritten.
void restrict_to(const Level& fine, std::vector<double>& from, Level& coarse);
/// fine.x += interpolation of coarse.x, or fine.x = … where the fine level is not smoothed.
void interpolate_from(Level& fine, Level& coarse);

}  // namespace similitude::multigrid
