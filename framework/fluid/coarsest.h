#pragma once
/// Direct solution on the coarsest level. Regions without a pressure patch have no pressure level of their own: the
/// constant is taken out there, and the answer has zero mean.

#include <vector>

#include "fluid/levels.h"

namespace similitude::multigrid {

class Coarsest {
 public:
  explicit Coarsest(const Level& level);

  void factor(const Level& level);
  /// level.x = inverse of A applied to level.b.
  void solve(Level& level);

 private:
  double& entry(Index row, Index column) { return matrix_[static_cast<std::size_t>(row * count_ + column)]; }
  /// Adds the constant to every region that no pressure patch reaches, so that the matrix can be inverted.
  void pin_closed_regions(const Level& level);

  Index count_;
  std::vector<double> matrix_;   // L D L^T: L below the diagonal, 1/D on it. No square roots: a scaled bed keeps its bits
  std::vector<double> unknown_;
  std::vector<Index> region_, stack_;
};

}  // namespace similitude::multigrid
