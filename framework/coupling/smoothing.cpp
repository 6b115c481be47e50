#include "coupling/smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fluid/staggered.h"

namespace similitude {

Smoothing::Smoothing(const CellMap& map, double length) : map_(map) {
  const double wanted = length * length / (8 * std::numbers::ln2);   // [m^2]
  double cells_squared = 0;                                          // [-], sum over axes of variance in cells
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double h = map.spacing(static_cast<int>(axis));
    variance_[axis] = std::max(0.0, wanted - h * h / 6);
    cells_squared += variance_[axis] / (h * h);
  }
  // A step that passes a share s through each face adds the variance 2 s h^2 along that axis; the shares of all six faces
  // may not exceed one half.
  steps_ = static_cast<int>(std::ceil(2 * cells_squared));
  if (steps_ == 0) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double h = map.spacing(static_cast<int>(axis));
    share_[axis] = variance_[axis] / (h * h) / (2 * steps_);
  }
  scratch_.resize(map.cell_count());
  find_runs();
}

void Smoothing::find_runs() {
  constexpr std::ptrdiff_t k_longest = 4 * 64;   // [doubles]: threads share runs, so none may be long
  for (std::size_t c = 0; c < map_.cell_count(); ++c) {
    const auto begin = static_cast<std::ptrdiff_t>(4 * c);
    Run here{begin, begin + 4, {}};
    for (std::size_t n = 0; n < 6; ++n) here.neighbour[n] = 4 * static_cast<std::ptrdiff_t>(map_.links(c)[n]) - begin;
    if (!runs_.empty() && runs_.back().neighbour == here.neighbour && here.end - runs_.back().begin <= k_longest) {
      runs_.back().end = here.end;
    } else {
      runs_.push_back(here);
    }
  }
}

void Smoothing::apply(CellRows& field) {
  const double sx = share_[0], sy = share_[1], sz = share_[2];
  const auto runs = static_cast<std::ptrdiff_t>(runs_.size());
  for (int step = 0; step < steps_; ++step) {
    const double* const from = &field.data()->x;
    double* const to = &scratch_.data()->x;
#pragma omp parallel for schedule(static) if (static_cast<Index>(map_.cell_count()) >= k_worth_threads)
    for (std::ptrdiff_t r = 0; r < runs; ++r) {
      const Run& run = runs_[static_cast<std::size_t>(r)];
      const auto& at = run.neighbour;
#pragma omp simd
      for (std::ptrdiff_t i = run.begin; i < run.end; ++i) {
        // Differences first: a closed face links the cell to itself and passes exactly nothing.
        const double here = from[i];
        const double along_x = (from[i + at[0]] - here) + (from[i + at[1]] - here);
        const double along_y = (from[i + at[2]] - here) + (from[i + at[3]] - here);
        const double along_z = (from[i + at[4]] - here) + (from[i + at[5]] - here);
        to[i] = here + sx * along_x + sy * along_y + sz * along_z;
      }
    }
    field.swap(scratch_);
  }
}

}  // namespace similitude
