#pragma once
/// Cells of one cut-off, gathered into bricks. Rows are sorted by (brick, cell, id), so that a brick is one contiguous
/// range of rows, and the order of rows follows from positions and ids alone. Bricks are the unit of work: they do not
/// depend on the number of threads, and so no sum does.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "particles/store.h"

namespace similitude {

/// Below this, waking the other threads costs more than their help.
constexpr std::size_t k_rows_worth_threads = 1000;

/// Rows that a search must look through, and the image they stand in.
struct RowRange {
  std::uint32_t begin = 0, end = 0;
  std::uint8_t image = 0;      // shift of these rows' positions, see Bricks::shift
  std::uint32_t brick = 0;
};

class Bricks {
 public:
  static constexpr std::uint8_t k_no_shift = 13;   // the middle of 3 x 3 x 3 images

  /// Cells at least `cut_off` [m] wide over the box [0, size]. Throws InputError if a periodic direction is narrower
  /// than two cut-offs, or if there are more bricks than numbers for them (most.h).
  void lay_out(const std::array<double, 3>& size, const std::array<bool, 3>& periodic, double cut_off);

  /// The order in which rows must stand: order()[k] is the present row that becomes row k. Rows with leaves[row] != 0 are
  /// left out. Positions must be wrapped. Throws InputError for more rows or cells than numbers for
  /// them (most.h).
  void sort(const ParticleStore& particles, const std::vector<std::uint8_t>& leaves);
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Bricks that can ever hold particles, of those that were sorted: places of the box, or particles where they are fewer.
  std::size_t most() const { return std::min(occupied_.size(), key_.size()); }
  /// Bricks that hold particles.
  std::uint32_t count() const { return static_cast<std::uint32_t>(first_row_.empty() ? 0 : first_row_.size() - 1); }
  std::uint32_t first_row(std::uint32_t brick) const { return first_row_[brick]; }
  std::uint32_t end_row(std::uint32_t brick) const { return first_row_[brick + 1]; }
  std::uint32_t brick_of(std::uint32_t row) const;

  std::uint32_t cells_per_brick() const { return cells_per_brick_; }
  RowRange cell_rows(std::uint32_t brick, std::uint32_t local) const;
  /// The rows of the 27 cells around a cell that stand behind the cell's first row. At most 27 ranges.
  std::size_t neighbours(std::uint32_t brick, std::uint32_t local, std::array<RowRange, 27>& out) const;

  /// What to add to the positions of rows seen through `image`; w is 0.
  const Row& shift(std::uint8_t image) const { return shifts_[image]; }
  double cut_off() const { return cut_off_; }
  std::size_t bytes() const;
  static constexpr std::size_t k_bytes_per_row = 3 * sizeof(std::uint32_t);   // key_, place_of_row_, order_

 private:
  static constexpr std::uint32_t k_empty = std::numeric_limits<std::uint32_t>::max();
  /// The same where all of them stand in the brick itself; false where they may not.
  bool neighbours_inside(std::uint32_t brick, std::uint32_t local, std::array<RowRange, 27>& out, std::size_t& count) const;
  std::uint32_t cell_along(std::size_t axis, double position) const;

  double cut_off_ = 0;
  std::array<double, 3> size_{}, cells_per_length_{};
  std::array<bool, 3> periodic_{};
  std::array<std::uint32_t, 3> cells_{}, brick_cells_{}, bricks_{};
  std::uint32_t cells_per_brick_ = 0;
  std::array<Row, 27> shifts_{};
  std::vector<std::uint32_t> occupied_;      // per place of the box: number among the bricks that hold particles
  std::vector<std::uint32_t> place_;         // per occupied brick
  std::vector<std::uint32_t> first_row_;     // per occupied brick, and the end
  std::vector<std::uint32_t> cell_begin_;    // per cell of the occupied bricks, and the end
  std::vector<std::uint32_t> key_, place_of_row_, order_;
};

}  // namespace similitude
