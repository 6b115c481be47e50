#include "particles/bricks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "particles/most.h"
#include "scene/messages.h"

namespace similitude {

namespace {

// Some thousand spheres to a brick: few of their contacts cross to another, and rows, lists and history together stay
// in a core's second-level cache. There must be several bricks to a thread.
constexpr std::uint32_t k_cells_across = 8;
constexpr std::uint32_t k_cells_deep = 24;   // a shallow bed is one brick deep

std::uint32_t split_evenly(std::uint32_t cells, std::uint32_t at_most) {
  const std::uint32_t parts = (cells + at_most - 1) / at_most;
  return (cells + parts - 1) / parts;
}

double along(const Row& row, std::size_t axis) { return axis == 0 ? row.x : axis == 1 ? row.y : row.z; }

}  // namespace

void Bricks::lay_out(const std::array<double, 3>& size, const std::array<bool, 3>& periodic, double cut_off) {
  size_ = size;
  periodic_ = periodic;
  cut_off_ = cut_off;
  cells_per_brick_ = 1;
  double places = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double fitting = std::floor(size[axis] / cut_off);
    if (periodic[axis] && fitting < 2) {
      std::array<char, 160> what{};
      std::snprintf(what.data(), what.size(),
                    "scene.domain: the periodic direction %c is %.2f contact distances wide; a particle would meet its own image.",
                    "xyz"[axis], size[axis] / cut_off);
      throw InputError(what.data(), "Make it at least two contact distances wide, or give it walls.");
    }
    cells_[axis] = static_cast<std::uint32_t>(std::clamp(fitting, 1.0, 1e6));
    cells_per_length_[axis] = cells_[axis] / size[axis];
    brick_cells_[axis] = split_evenly(cells_[axis], axis == 1 ? k_cells_deep : k_cells_across);
    bricks_[axis] = (cells_[axis] + brick_cells_[axis] - 1) / brick_cells_[axis];
    cells_per_brick_ *= brick_cells_[axis];
    places *= bricks_[axis];
  }
  refuse_more_places(places);
  occupied_.resize(static_cast<std::size_t>(places));
  for (std::size_t image = 0; image < 27; ++image) {
    const auto turns = [&](std::size_t stride) { return static_cast<double>(image / stride % 3) - 1; };
    shifts_[image] = {turns(1) * size[0], turns(3) * size[1], turns(9) * size[2], 0};
  }
}

std::uint32_t Bricks::cell_along(std::size_t axis, double position) const {
  const double cell = position * cells_per_length_[axis];
  if (!(cell > 0)) return 0;   // also what lies outside, or is not a number and will be found by the guard
  return std::min(static_cast<std::uint32_t>(std::min(cell, 2e9)), cells_[axis] - 1);
}

void Bricks::sort(const ParticleStore& particles, const std::vector<std::uint8_t>& leaves) {
  refuse_more_rows(particles.size());
  const auto rows = static_cast<std::uint32_t>(particles.size());
  key_.resize(rows);
  place_of_row_.resize(rows);
#pragma omp parallel for schedule(static) if (rows >= k_rows_worth_threads)
  for (std::uint32_t row = 0; row < rows; ++row) {
    std::uint32_t place = 0, local = 0;
    for (std::size_t axis = 3; axis-- > 0;) {
      const std::uint32_t cell = cell_along(axis, along(particles.position[row], axis));
      place = place * bricks_[axis] + cell / brick_cells_[axis];
      local = local * brick_cells_[axis] + cell % brick_cells_[axis];
    }
    place_of_row_[row] = place;
    key_[row] = local;
  }

  std::fill(occupied_.begin(), occupied_.end(), k_empty);
  for (std::uint32_t row = 0; row < rows; ++row) {
    if (!leaves[row]) occupied_[place_of_row_[row]] = 0;
  }
  place_.clear();
  place_.reserve(most());
  first_row_.reserve(most() + 1);
  for (std::uint32_t place = 0; place < occupied_.size(); ++place) {
    if (occupied_[place] == k_empty) continue;
    occupied_[place] = static_cast<std::uint32_t>(place_.size());
    place_.push_back(place);
  }

  const std::size_t cells = place_.size() * cells_per_brick_;
  refuse_more_places(static_cast<double>(cells));
  if (cell_begin_.capacity() < cells + 1) cell_begin_.reserve(cells + cells / 2 + 1);
  cell_begin_.assign(cells + 1, 0);
  for (std::uint32_t row = 0; row < rows; ++row) {
    if (leaves[row]) continue;
    key_[row] += occupied_[place_of_row_[row]] * cells_per_brick_;
    ++cell_begin_[key_[row] + 1];
  }
  for (std::size_t cell = 0; cell < cells; ++cell) cell_begin_[cell + 1] += cell_begin_[cell];
  order_.resize(cell_begin_[cells]);
  for (std::uint32_t row = 0; row < rows; ++row) {
    if (!leaves[row]) order_[cell_begin_[key_[row]]++] = row;
  }
  for (std::size_t cell = cells; cell > 0; --cell) cell_begin_[cell] = cell_begin_[cell - 1];
  cell_begin_[0] = 0;

  // Ties by id: the order must not remember where rows stood before.
  const auto by_id = [&](std::uint32_t a, std::uint32_t b) { return particles.id[a] < particles.id[b]; };
#pragma omp parallel for schedule(static) if (rows >= k_rows_worth_threads)
  for (std::size_t cell = 0; cell < cells; ++cell) {
    std::sort(order_.begin() + cell_begin_[cell], order_.begin() + cell_begin_[cell + 1], by_id);
  }
  first_row_.resize(place_.size() + 1);
  for (std::size_t brick = 0; brick <= place_.size(); ++brick) first_row_[brick] = cell_begin_[brick * cells_per_brick_];
}

std::uint32_t Bricks::brick_of(std::uint32_t row) const {
  return static_cast<std::uint32_t>(std::upper_bound(first_row_.begin(), first_row_.end(), row) - first_row_.begin()) - 1;
}

RowRange Bricks::cell_rows(std::uint32_t brick, std::uint32_t local) const {
  const std::size_t cell = static_cast<std::size_t>(brick) * cells_per_brick_ + local;
  return {cell_begin_[cell], cell_begin_[cell + 1], k_no_shift, brick};
}

bool Bricks::neighbours_inside(std::uint32_t brick, std::uint32_t local, std::array<RowRange, 27>& out, std::size_t& count) const {
  // What lies before the brick along an axis belongs to earlier bricks. Behind it there must be nothing, or the cell must not
  // be its last.
  std::array<std::uint32_t, 3> at{};
  std::uint32_t place = place_[brick], inside = local;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = inside % brick_cells_[axis];
    inside /= brick_cells_[axis];
    const std::uint32_t here = place % bricks_[axis] * brick_cells_[axis] + at[axis];
    place /= bricks_[axis];
    if (periodic_[axis] || (at[axis] + 1 == brick_cells_[axis] && here + 1 < cells_[axis])) return false;
  }
  const std::uint32_t* const cell = cell_begin_.data() + static_cast<std::size_t>(brick) * cells_per_brick_ + local;
  const std::uint32_t before = at[0] > 0 ? 1 : 0, behind = at[0] + 1 < brick_cells_[0] ? 2 : 1;
  const std::ptrdiff_t line = brick_cells_[0], layer = line * brick_cells_[1];
  count = 0;
  const auto add = [&](std::ptrdiff_t to, std::uint32_t first) {
    const RowRange range{cell[to - first], cell[to + behind], k_no_shift, brick};
    if (range.end > range.begin) out[count++] = range;
  };
  add(0, 0);
  if (at[1] + 1 < brick_cells_[1]) add(line, before);
  if (at[2] + 1 < brick_cells_[2]) {
    if (at[1] > 0) add(layer - line, before);
    add(layer, before);
    if (at[1] + 1 < brick_cells_[1]) add(layer + line, before);
  }
  return true;
}

std::size_t Bricks::neighbours(std::uint32_t brick, std::uint32_t local, std::array<RowRange, 27>& out) const {
  if (std::size_t inside = 0; neighbours_inside(brick, local, out, inside)) return inside;
  // Along each axis: the cells before, here and after, as brick, cell in it, and image.
  struct Step {
    std::uint32_t brick, cell, image;
  };
  std::array<std::array<Step, 3>, 3> steps;
  std::array<std::uint32_t, 3> step_count{};
  std::uint32_t place = place_[brick];
  std::uint32_t inside = local;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t here = place % bricks_[axis] * brick_cells_[axis] + inside % brick_cells_[axis];
    place /= bricks_[axis];
    inside /= brick_cells_[axis];
    for (std::uint32_t turn = 0; turn < 3; ++turn) {
      std::uint32_t cell = here + turn - 1;   // wraps below zero to a huge number
      std::uint32_t image = 1;
      if (cell >= cells_[axis]) {
        if (!periodic_[axis]) continue;
        cell = turn == 0 ? cells_[axis] - 1 : 0;
        image = turn;
      }
      steps[axis][step_count[axis]++] = {cell / brick_cells_[axis], cell % brick_cells_[axis], image};
    }
  }

  const std::uint32_t first_row = cell_rows(brick, local).begin;
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < step_count[2]; ++c) {
    for (std::uint32_t b = 0; b < step_count[1]; ++b) {
      bool joins = false;   // the next cell along x continues the last range
      for (std::uint32_t a = 0; a < step_count[0]; ++a) {
        const Step &x = steps[0][a], &y = steps[1][b], &z = steps[2][c];
        const std::uint32_t neighbour = occupied_[x.brick + bricks_[0] * (y.brick + bricks_[1] * z.brick)];
        const auto image = static_cast<std::uint8_t>(x.image + 3 * (y.image + 3 * z.image));
        if (neighbour == k_empty || neighbour < brick) {
          joins = false;
          continue;
        }
        const RowRange rows = cell_rows(neighbour, x.cell + brick_cells_[0] * (y.cell + brick_cells_[1] * z.cell));
        if (joins && out[count - 1].brick == neighbour && out[count - 1].end == rows.begin && out[count - 1].image == image) {
          out[count - 1].end = rows.end;
        } else if (rows.end > rows.begin && rows.end > first_row) {
          out[count++] = {rows.begin, rows.end, image, neighbour};
          joins = true;
        } else {
          joins = false;
        }
      }
    }
  }
  return count;
}

std::size_t Bricks::bytes() const {
  return 4 * (occupied_.capacity() + place_.capacity() + first_row_.capacity() + cell_begin_.capacity() + key_.capacity() +
              place_of_row_.capacity() + order_.capacity());
}

}  // namespace similitude
