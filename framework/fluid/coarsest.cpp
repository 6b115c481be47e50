#include "fluid/coarsest.h"

#include <algorithm>

// A matrix of a few dozen rows: Eigen's vector code gains nothing and trips GCC 12's warnings.
#define EIGEN_DONT_VECTORIZE
#include <Eigen/Cholesky>

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

/// L D L^T without square roots: a bed scaled by powers of two keeps its bits.
struct Coarsest::Factors {
  explicit Factors(Index count) : matrix(count, count), decomposition(count), unknown(count), outlet(u(count)) {}
  Eigen::MatrixXd matrix;
  Eigen::LDLT<Eigen::MatrixXd> decomposition;
  Eigen::VectorXd unknown;
  std::vector<double> outlet;   // coefficient to pressure patches, by row
};

Coarsest::Coarsest(const Level& level)
    : count_(level.cell_count()), factors_(std::make_unique<Factors>(count_)), region_(u(count_)) {
  stack_.reserve(u(count_));
}
Coarsest::~Coarsest() = default;

void Coarsest::factor(const Level& level) {
  Eigen::MatrixXd& matrix = factors_->matrix;
  matrix.setZero();
  in_order(level, [&](Index row, Index c) {
    // A cell cut off on all sides keeps its own zero.
    matrix(row, row) += level.diagonal[u(c)] > 0 ? level.diagonal[u(c)] : 1;
    const Triple at{row % level.n[0], row / level.n[0] % level.n[1], row / (level.n[0] * level.n[1])};
    Index stride = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const Index below = at[a] > 0 ? row - stride : row + (level.n[a] - 1) * stride;
      const double link = level.weight[a][u(c)];
      if (link > 0) {
        matrix(row, below) -= link;
        matrix(below, row) -= link;
      }
      stride *= level.n[a];
    }
  });
  pin_closed_regions(level);
  factors_->decomposition.compute(matrix);
}

void Coarsest::pin_closed_regions(const Level& level) {
  Eigen::MatrixXd& matrix = factors_->matrix;
  std::fill(region_.begin(), region_.end(), Index{-1});
  in_order(level, [&](Index row, Index c) {
    factors_->outlet[u(row)] = (level.outlet[0][u(c)] + level.outlet[1][u(c)]) + level.outlet[2][u(c)];
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
      reaches_outlet = reaches_outlet || factors_->outlet[u(row)] > 0;
      largest = std::max(largest, matrix(row, row));
      for (Index other = 0; other < count_; ++other) {
        if (matrix(row, other) == 0 || region_[u(other)] >= 0) continue;
        region_[u(other)] = seed;
        stack_.push_back(other);
      }
    }
    if (reaches_outlet) continue;
    for (Index row = seed; row < count_; ++row) {
      for (Index other = seed; other < count_; ++other) {
        if (region_[u(row)] == seed && region_[u(other)] == seed) matrix(row, other) += largest;
      }
    }
  }
}

void Coarsest::solve(Level& level) {
  Eigen::VectorXd& unknown = factors_->unknown;
  in_order(level, [&](Index row, Index c) { unknown(row) = level.b[u(c)]; });
  factors_->decomposition.solveInPlace(unknown);
  in_order(level, [&](Index row, Index c) { level.x[u(c)] = unknown(row); });
}

}  // namespace similitude::multigrid
