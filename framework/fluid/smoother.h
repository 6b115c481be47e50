#pragma once
/// Work on one level: A x, residuals, Chebyshev smoothing, sums in a fixed order.

#include <vector>

#include "fluid/levels.h"

namespace similitude::multigrid {

/// image = A x. Ghosts of x are fresh; ghosts of image are cleared.
void apply(const Level& level, const std::vector<double>& x, std::vector<double>& image);
/// level.residual = b - A x.
void residual(Level& level);
/// Chebyshev iterations on A x = b. The eigenvalues of D^-1 A lie in (0, 2], whatever the coefficients (Gershgorin), so
/// that no estimate is needed; the same polynomial before and after keeps the preconditioner symmetric.
void smooth_from_zero(Level& level);
void smooth(Level& level);

/// visit(row of cells in the grid's order, row of the level) for every line of cells along x.
template <class Visit>
void for_each_row(const Level& level, Visit&& visit) {
#pragma omp parallel for schedule(static) if (level.cell_count() >= k_worth_threads)
  for (Index k = 0; k < level.n[2]; ++k) {
    for (Index j = 0; j < level.n[1]; ++j) visit(level.n[0] * (j + level.n[1] * k), level.at(0, j, k));
  }
}

/// Sums over the finest level: one partial sum per plane, added in order, for any number of threads.
class FinestSums {
 public:
  explicit FinestSums(const Level& level, std::vector<double>& partial) : level_(level), partial_(partial) {}

  double product(const std::vector<double>& left, const std::vector<double>& right) const;
  double largest(const std::vector<double>& field) const;
  /// field += factor other
  void add(std::vector<double>& field, double factor, const std::vector<double>& other) const;
  /// field = factor field + other
  void scale_and_add(std::vector<double>& field, double factor, const std::vector<double>& other) const;

 private:
  const Level& level_;
  std::vector<double>& partial_;  // a value per plane
};

}  // namespace similitude::multigrid
