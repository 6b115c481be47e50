#include "fluid/multigrid_cg.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fluid/coarsest.h"
#include "fluid/levels.h"
#include "fluid/regions.h"
#include "fluid/smoother.h"

namespace similitude {

using multigrid::Coarsest;
using multigrid::Level;

struct MultigridCG::Parts {
  explicit Parts(const similitude_grid& grid)
      : mesh(grid), levels(multigrid::make_levels(mesh)), coarsest(levels.back()), regions(mesh) {
    partial_sums.assign(static_cast<std::size_t>(mesh.cells[2]), 0);
    for (auto* field : {&solution, &search, &image}) field->assign(levels.front().x.size(), 0);
  }

  Staggered mesh;
  std::vector<Level> levels;
  Coarsest coarsest;
  multigrid::ClosedRegions regions;
  std::vector<double> solution, search, image;  // layout of the finest level
  std::vector<double> partial_sums;             // a value per plane
};

namespace {

/// levels.front().x = approximate inverse applied to levels.front().b.
void v_cycle(std::vector<Level>& levels, Coarsest& coarsest) {
  const std::size_t deepest = levels.size() - 1;
  for (std::size_t l = 0; l < deepest; ++l) {
    Level& level = levels[l];
    if (level.smoothed) {
      multigrid::smooth_from_zero(level);
      multigrid::residual(level);
      multigrid::restrict_to(level, level.residual, levels[l + 1]);
    } else {
      multigrid::restrict_to(level, level.b, levels[l + 1]);
    }
  }
  coarsest.solve(levels[deepest]);
  for (std::size_t l = deepest; l-- > 0;) {
    multigrid::interpolate_from(levels[l], levels[l + 1]);
    if (levels[l].smoothed) multigrid::smooth(levels[l]);
  }
}

}  // namespace

MultigridCG::MultigridCG(const similitude_grid& grid) : parts_(std::make_unique<Parts>(grid)) {}
MultigridCG::~MultigridCG() = default;
MultigridCG::MultigridCG(MultigridCG&&) noexcept = default;

bool MultigridCG::has_closed_region() const { return parts_->regions.count() > 0; }

void MultigridCG::set_coefficients(const std::array<const double*, 3>& coefficient) {
  std::vector<Level>& levels = parts_->levels;
  multigrid::set_finest(levels.front(), parts_->mesh, coefficient);
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) multigrid::set_coarser(levels[l], levels[l + 1]);
  parts_->coarsest.factor(levels.back());
}

SolveReport MultigridCG::solve(const double* rhs, double* p, const SolveOptions& options) {
  Parts& parts = *parts_;
  Level& finest = parts.levels.front();
  const multigrid::FinestSums sums(finest, parts.partial_sums);
  SolveReport report;

  // The matrix is -div(c grad), which is positive: b = -rhs.
  multigrid::for_each_row(finest, [&](Index row_of_cells, Index first) {
    const double* const from = rhs + row_of_cells;
    double* const to = finest.b.data() + first;
    for (Index i = 0; i < finest.n[0]; ++i) to[i] = -from[i];
  });
  const double scale = options.scale > 0 ? options.scale : sums.largest(finest.b);
  const double imbalance = parts.regions.subtract_mean(finest.b);
  std::fill(parts.solution.begin(), parts.solution.end(), 0.0);
  std::fill(parts.search.begin(), parts.search.end(), 0.0);
  double largest = sums.largest(finest.b);
  const double target = options.tolerance * scale;
  double old_product = 0;
  while (largest > target && report.iterations < options.most_iterations) {
    v_cycle(parts.levels, parts.coarsest);
    const double product = sums.product(finest.b, finest.x);
    const double keep = report.iterations == 0 ? 0 : product / old_product;
    sums.scale_and_add(parts.search, keep, finest.x);
    old_product = product;
    finest.refresh_ghosts(parts.search);
    multigrid::apply(finest, parts.search, parts.image);
    const double step = product / sums.product(parts.search, parts.image);
    if (!std::isfinite(step)) break;
    sums.add(parts.solution, step, parts.search);
    sums.add(finest.b, -step, parts.image);
    largest = sums.largest(finest.b);
    ++report.iterations;
  }
  parts.regions.subtract_mean(parts.solution);
  multigrid::for_each_row(finest, [&](Index row_of_cells, Index first) {
    const double* const from = parts.solution.data() + first;
    double* const to = p + row_of_cells;
    for (Index i = 0; i < finest.n[0]; ++i) to[i] = from[i];
  });
  report.residual = scale > 0 ? largest / scale : 0;
  report.imbalance = scale > 0 ? imbalance / scale : 0;
  report.converged = largest <= target;
  return report;
}

}  // namespace similitude
