#pragma once
/// div(c grad p) = rhs on a staggered grid: conjugate gradients with a multigrid preconditioner. Variable face
/// coefficients, any cell counts, walls, baffles, pressure patches, periodic directions, closed regions. The same bits for
/// any number of threads. No allocation after construction.

#include <array>
#include <memory>

#include <similitude/abi.h>

namespace similitude {

struct SolveOptions {
  double tolerance = 1e-8;   // [-], stop when no cell's residual exceeds this times `scale`
  double scale = 0;          // in the unit of rhs; 0: the largest |rhs|
  int most_iterations = 100;
};

struct SolveReport {
  int iterations = 0;
  double residual = 0;    // [-], largest cell residual relative to the scale
  double imbalance = 0;   // [-], largest mean of rhs over a closed region, relative to the scale: has been subtracted
  bool converged = false;
};

class MultigridCG {
 public:
  /// `grid` stays valid. Open faces connect cells; pressure patches hold p = 0 half a cell away; all else is closed.
  explicit MultigridCG(const similitude_grid& grid);
  ~MultigridCG();
  MultigridCG(MultigridCG&&) noexcept;

  /// Face coefficients in the layout of similitude_grid, positive at open faces and pressure patches; the rest is ignored.
  void set_coefficients(const std::array<const double*, 3>& coefficient);
  /// rhs and p: cells. A closed region (no pressure patch) can only take a right-hand side of zero mean: its mean is
  /// subtracted and reported, and its p has zero mean.
  SolveReport solve(const double* rhs, double* p, const SolveOptions& options);
  /// Whether a closed region exists.
  bool has_closed_region() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace similitude
