#include "fluid/smoother.h"

#include <algorithm>
#include <cmath>

namespace similitude::multigrid {

namespace {

// The part of the spectrum of D^-1 A that the smoother has to damp: the upper bound is exact, the lower one is where
// errors become smooth enough for the next level (1/3 in three dimensions; a little above it measured best).
constexpr double k_upper = 2.0;
constexpr double k_lower = 0.4;
constexpr double k_centre = (k_upper + k_lower) / 2;
constexpr double k_half_width = (k_upper - k_lower) / 2;
constexpr int k_degree = 2;

struct Stencil {
  explicit Stencil(const Level& level)
      : diagonal(level.diagonal.data()), wx(level.weight[0].data()), wy(level.weight[1].data()), wz(level.weight[2].data()),
        row(level.row), plane(level.plane) {}
  double operator()(const double* x, Index c) const {
    return diagonal[c] * x[c] - ((wx[c] * x[c - 1] + wx[c + 1] * x[c + 1]) + (wy[c] * x[c - row] + wy[c + row] * x[c + row]) +
                                 (wz[c] * x[c - plane] + wz[c + plane] * x[c + plane]));
  }
  const double *diagonal, *wx, *wy, *wz;
  Index row, plane;
};

/// body(cell) for all cells and the ghosts between them, plane by plane.
template <class Body>
void sweep(const Level& level, Body&& body) {
  const Index span = level.span();
#pragma omp parallel for schedule(static) if (level.cell_count() >= k_worth_threads)
  for (Index k = 0; k < level.n[2]; ++k) {
    const Index first = level.at(0, 0, k);
#pragma omp simd
    for (Index c = first; c < first + span; ++c) body(c);
  }
}

void clear_ghosts_between_rows(const Level& level, std::vector<double>& field) {
  if (!level.periodic[0]) return;  // zero by themselves: no weight reaches them
  for (Index k = 0; k < level.n[2]; ++k) {
    for (Index j = 0; j < level.n[1]; ++j) {
      const Index first = level.at(0, j, k);
      field[static_cast<std::size_t>(first - 1)] = 0;
      field[static_cast<std::size_t>(first + level.n[0])] = 0;
    }
  }
}

/// One more Chebyshev step: direction = momentum direction + gain D^-1 (b - A x), x += direction.
void chebyshev_step(Level& level, double momentum, double gain) {
  level.refresh_ghosts(level.x);
  const Stencil a(level);
  const double* const x = level.x.data();
  const double* const b = level.b.data();
  const double* const inverse = level.inverse_diagonal.data();
  double* const direction = level.direction.data();
  double* const next = level.scratch.data();
  sweep(level, [=](Index c) {
    const double d = momentum * direction[c] + gain * (inverse[c] * (b[c] - a(x, c)));
    direction[c] = d;
    next[c] = x[c] + d;
  });
  std::swap(level.x, level.scratch);
}

void chebyshev_remaining_steps(Level& level) {
  constexpr double sigma = k_centre / k_half_width;
  double rho = 1 / sigma;
  for (int step = 1; step < k_degree; ++step) {
    const double next_rho = 1 / (2 * sigma - rho);
    chebyshev_step(level, next_rho * rho, 2 * next_rho / k_half_width);
    rho = next_rho;
  }
}

}  // namespace

void apply(const Level& level, const std::vector<double>& x, std::vector<double>& image) {
  const Stencil a(level);
  const double* const from = x.data();
  double* const to = image.data();
  sweep(level, [=](Index c) { to[c] = a(from, c); });
  clear_ghosts_between_rows(level, image);
}

void residual(Level& level) {
  level.refresh_ghosts(level.x);
  const Stencil a(level);
  const double* const x = level.x.data();
  const double* const b = level.b.data();
  double* const to = level.residual.data();
  sweep(level, [=](Index c) { to[c] = b[c] - a(x, c); });
}

void smooth_from_zero(Level& level) {
  const double* const b = level.b.data();
  const double* const inverse = level.inverse_diagonal.data();
  double* const x = level.x.data();
  double* const direction = level.direction.data();
  sweep(level, [=](Index c) { x[c] = direction[c] = (1 / k_centre) * (inverse[c] * b[c]); });
  chebyshev_remaining_steps(level);
}

void smooth(Level& level) {
  chebyshev_step(level, 0, 1 / k_centre);
  chebyshev_remaining_steps(level);
}

double FinestSums::product(const std::vector<double>& left, const std::vector<double>& right) const {
  const double* const l = left.data();
  const double* const r = right.data();
  const Index nx = level_.n[0], ny = level_.n[1];
#pragma omp parallel for schedule(static) if (level_.cell_count() >= k_worth_threads)
  for (Index k = 0; k < level_.n[2]; ++k) {
    double sum = 0;
    for (Index j = 0; j < ny; ++j) {
      const Index first = level_.at(0, j, k);
#pragma omp simd reduction(+ : sum)
      for (Index c = first; c < first + nx; ++c) sum += l[c] * r[c];
    }
    partial_[static_cast<std::size_t>(k)] = sum;
  }
  double total = 0;
  for (const double sum : partial_) total += sum;
  return total;
}

double FinestSums::largest(const std::vector<double>& field) const {
  const double* const value = field.data();
  const Index nx = level_.n[0], ny = level_.n[1];
#pragma omp parallel for schedule(static) if (level_.cell_count() >= k_worth_threads)
  for (Index k = 0; k < level_.n[2]; ++k) {
    double most = 0;
    for (Index j = 0; j < ny; ++j) {
      const Index first = level_.at(0, j, k);
#pragma omp simd reduction(max : most)
      for (Index c = first; c < first + nx; ++c) most = std::max(most, std::abs(value[c]));
    }
    partial_[static_cast<std::size_t>(k)] = most;
  }
  return *std::max_element(partial_.begin(), partial_.end());
}

void FinestSums::add(std::vector<double>& field, double factor, const std::vector<double>& other) const {
  double* const to = field.data();
  const double* const from = other.data();
  sweep(level_, [=](Index c) { to[c] += factor * from[c]; });
}

void FinestSums::scale_and_add(std::vector<double>& field, double factor, const std::vector<double>& other) const {
  double* const to = field.data();
  const double* const from = other.data();
  sweep(level_, [=](Index c) { to[c] = factor * to[c] + from[c]; });
}

}  // namespace similitude::multigrid
