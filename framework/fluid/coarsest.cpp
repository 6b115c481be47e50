#include "fluid/coarsest.h"

#include <algorithm>

namespace similitude::multigrid {

namespace {

std::size_t u(Index row) { return static_cast<std::size_t>(row); }

/// visit(row, row of the level) for all cells in order.
template <class Visit>
void in_order(const Level& level, Visit&& visit) {
  Index row = 0;
  for (Index k = 0; k < level.n[2]; ++k) {
    for (Index j = 0; j < level.n[1]; ++j) {
      for (Index i = 0; i < level.n[0]; ++i) visit(row++, level.at(i, j, k));
    }
  }
}

}  // namespace

Coarsest::Coarsest(const Level& level)
    : count_(level.cell_count()), matrix_(u(count_ * count_)), unknown_(u(count_)), region_(u(count_)) {
  stack_.reserve(u(count_));
}

void Coarsest::factor(const Level& level) {
  std::fill(matrix_.begin(), matrix_.end(), 0.0);
  in_order(level, [&](Index row, Index c) {
    // A cell cut off on all sides keeps its own zero.
    entry(row, row) += level.diagonal[u(c)] > 0 ? level.diagonal[u(c)] : 1;
    const Triple at{row % level.n[0], row / level.n[0] % level.n[1], row / (level.n[0] * level.n[1])};
    Index stride = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const Index below = at[a] > 0 ? row - stride : row + (level.n[a] - 1) * stride;
      const double link = level.weight[a][u(c)];
      if (link > 0) {
        entry(row, below) -= link;
        entry(below, row) -= link;
      }
      stride *= level.n[a];
    }
  });
  pin_closed_regions(level);
  for (Index column = 0; column < count_; ++column) {
    const double inverse = 1 / entry(column, column);
    entry(column, column) = inverse;
    for (Index row = column + 1; row < count_; ++row) {
      const double factor = entry(row, column) * inverse;
      for (Index other = column + 1; other <= row; ++other) entry(row, other) -= factor * entry(other, column);
    }
    for (Index row = column + 1; row < count_; ++row) entry(row, column) *= inverse;
  }
}

void Coarsest::pin_closed_regions(const Level& level) {
  std::fill(region_.begin(), region_.end(), Index{-1});
  in_order(level, [&](Index row, Index c) {
    unknown_[u(row)] = (level.outlet[0][u(c)] + level.outlet[1][u(c)]) + level.outlet[2][u(c)];
  });
  for (Index seed = 0; seed < count_; ++seed) {
    if (region_[u(seed)] >= 0) continue;
    bool reaches_outlet = false;
    double largest = 0;
    region_[u(seed)] = seed;
    stack_.assign(1, seed);
    while (!stack_.empty()) {
      const Index row = stack_.back();
      stack_.pop_back();
      reaches_outlet = reaches_outlet || unknown_[u(row)] > 0;
      largest = std::max(largest, entry(row, row));
      for (Index other = 0; other < count_; ++other) {
        if (entry(row, other) == 0 || region_[u(other)] >= 0) continue;
        region_[u(other)] = seed;
        stack_.push_back(other);
      }
    }
    if (reaches_outlet) continue;
    for (Index row = seed; row < count_; ++row) {
      for (Index other = seed; other < count_; ++other) {
        if (region_[u(row)] == seed && region_[u(other)] == seed) entry(row, other) += largest;
      }
    }
  }
}

void Coarsest::solve(Level& level) {
  in_order(level, [&](Index row, Index c) { unknown_[u(row)] = level.b[u(c)]; });
  for (Index row = 0; row < count_; ++row) {
    double value = unknown_[u(row)];
    for (Index other = 0; other < row; ++other) value -= entry(row, other) * unknown_[u(other)];
    unknown_[u(row)] = value;
  }
  for (Index row = 0; row < count_; ++row) unknown_[u(row)] *= entry(row, row);
  for (Index row = count_; row-- > 0;) {
    double value = unknown_[u(row)];
    for (Index other = row + 1; other < count_; ++other) value -= entry(other, row) * unknown_[u(other)];
    unknown_[u(row)] = value;
  }
  in_order(level, [&](Index row, Index c) { level.x[u(c)] = unknown_[u(row)]; });
}

}  // namespace similitude::multigrid
