#include "fluid/coarsest.h"

#include <Eigen/Cholesky>
#include <vector>

namespace similitude::multigrid {

struct Coarsest::Parts {
  explicit Parts(Index cells) : matrix(cells, cells), unknown(cells), factors(cells), region(static_cast<std::size_t>(cells)) {
    stack.reserve(static_cast<std::size_t>(cells));
  }
  Eigen::MatrixXd matrix;
  Eigen::VectorXd unknown;
  Eigen::LDLT<Eigen::MatrixXd> factors;  // no square roots: a scaled bed keeps its bits
  std::vector<Index> region;
  std::vector<Index> stack;
};

Coarsest::Coarsest(const Level& level) : parts_(std::make_unique<Parts>(level.cell_count())) {}
Coarsest::~Coarsest() = default;
Coarsest::Coarsest(Coarsest&&) noexcept = default;

void Coarsest::factor(const Level& level) {
  Eigen::MatrixXd& m = parts_->matrix;
  const Index count = level.cell_count();
  m.setZero();
  const auto number = [&](const Triple& at) { return at[0] + level.n[0] * (at[1] + level.n[1] * at[2]); };
  const auto value = [](const std::vector<double>& field, Index c) { return field[static_cast<std::size_t>(c)]; };
  std::vector<Index>& region = parts_->region;
  Triple at{};
  for (at[2] = 0; at[2] < level.n[2]; ++at[2]) {
    for (at[1] = 0; at[1] < level.n[1]; ++at[1]) {
      for (at[0] = 0; at[0] < level.n[0]; ++at[0]) {
        const Index c = level.at(at[0], at[1], at[2]), here = number(at);
        // A cell cut off on all sides keeps its own zero.
        m(here, here) += value(level.diagonal, c) > 0 ? value(level.diagonal, c) : 1;
        for (std::size_t a = 0; a < 3; ++a) {
          const double link = value(level.weight[a], c);
          if (!(link > 0)) continue;
          Triple below = at;
          below[a] = at[a] > 0 ? at[a] - 1 : level.n[a] - 1;
          m(here, number(below)) -= link;
          m(number(below), here) -= link;
        }
      }
    }
  }
  // Regions that no pressure patch reaches: add the constant, so that the matrix can be inverted.
  const auto outlet = [&](Index row) {
    const Index i = row % level.n[0], j = row / level.n[0] % level.n[1], k = row / (level.n[0] * level.n[1]);
    const Index c = level.at(i, j, k);
    return value(level.outlet[0], c) + value(level.outlet[1], c) + value(level.outlet[2], c);
  };
  std::fill(region.begin(), region.end(), Index{-1});
  for (Index seed = 0; seed < count; ++seed) {
    if (region[static_cast<std::size_t>(seed)] >= 0) continue;
    bool pinned = false;
    double largest = 0;
    parts_->stack.assign(1, seed);
    region[static_cast<std::size_t>(seed)] = seed;
    while (!parts_->stack.empty()) {
      const Index row = parts_->stack.back();
      parts_->stack.pop_back();
      pinned = pinned || outlet(row) > 0;
      largest = std::max(largest, m(row, row));
      for (Index other = 0; other < count; ++other) {
        if (m(row, other) == 0 || region[static_cast<std::size_t>(other)] >= 0) continue;
        region[static_cast<std::size_t>(other)] = seed;
        parts_->stack.push_back(other);
      }
    }
    if (pinned) continue;
    for (Index row = seed; row < count; ++row) {
      if (region[static_cast<std::size_t>(row)] != seed) continue;
      for (Index other = seed; other < count; ++other) {
        if (region[static_cast<std::size_t>(other)] == seed) m(row, other) += largest;
      }
    }
  }
  parts_->factors.compute(m);
}

void Coarsest::solve(Level& level) {
  Eigen::VectorXd& unknown = parts_->unknown;
  const auto row_wise = [&](auto&& visit) {
    Index row = 0;
    for (Index k = 0; k < level.n[2]; ++k) {
      for (Index j = 0; j < level.n[1]; ++j) {
        for (Index i = 0; i < level.n[0]; ++i) visit(row++, static_cast<std::size_t>(level.at(i, j, k)));
      }
    }
  };
  row_wise([&](Index row, std::size_t c) { unknown[row] = level.b[c]; });
  parts_->factors.solveInPlace(unknown);
  row_wise([&](Index row, std::size_t c) { level.x[c] = unknown[row]; });
}

}  // namespace similitude::multigrid
