#include "porous_solver.h"

#include <algorithm>
#include <cmath>

namespace similitude::porous {

using flow::FaceTable;
using flow::u;

PorousSolver::PorousSolver(const similitude_grid& grid, const GasOptions& options)
    : FaceFlow(grid, {.density = options.density, .tolerance = options.tolerance, .most_iterations = options.most_iterations}),
      options_(options), damped_(flow::make_face_fields(mesh_)), resistance_(flow::make_face_fields(mesh_)) {}

void PorousSolver::start(const similitude_gas_step& fields) {
  for (auto& axis : damped_) std::fill(axis.begin(), axis.end(), 0.0);
  FaceFlow::start(fields);
}

/// [kg/(m^3 s)]. The bed's own resistance is the mean over its particles, weighted by what they resist. Without any
/// particles every value gives the same flow, a potential one.
double PorousSolver::least_resistance(const similitude_gas_step& step) const {
  double sum = 0, squares = 0;   // in the order of the cells: the same bits for any number of threads
  for (Index c = 0; c < mesh_.cell_count; ++c) {
    sum += step.exchange[c];
    squares += step.exchange[c] * step.exchange[c];
  }
  return options_.free_resistance * (sum > 0 ? squares / sum : options_.density / step.dt);
}

/// Velocities under the old pressure; mobility_ and coefficient_ for the projection.
void PorousSolver::predict(const similitude_gas_step& step) {
  const double least = least_resistance(step);
  for (std::size_t a = 0; a < 3; ++a) {
    const FaceTable& table = tables_[a];
    const double* const push = step.exchange_velocity + static_cast<Index>(a) * mesh_.cell_count;
    const double* const owed = step.remainder + static_cast<Index>(a) * mesh_.cell_count;
    const Index count = static_cast<Index>(table.faces.size());
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const flow::ActiveFace& face = table.faces[u(n)];
      const std::size_t f = u(face.face);
      const auto mean = [&](const double* cells) { return 0.5 * (cells[face.below] + cells[face.above]); };
      const double given = mean(step.exchange), last = damped_[a][f];
      const double damped = last > 0 ? std::sqrt(given * last) : given;
      const double share = given > 0 ? damped / given : 0;
      const double resistance = std::max(damped, least);
      const double force = share * mean(push) + mean(owed) - fraction_[a][f] * gradient_[a][f];
      damped_[a][f] = damped;
      resistance_[a][f] = resistance;
      velocity_[a][f] = force / resistance;
      mobility_[a][f] = fraction_[a][f] / resistance;
      coefficient_[a][f] = fraction_[a][f] * mobility_[a][f];
    }
    flow::set_inlets(mesh_, table, a, step.time, velocity_[a]);
    flow::copy_periodic_faces(mesh_, a, velocity_[a]);
    flow::copy_periodic_faces(mesh_, a, coefficient_[a]);
  }
}

/// What particles receive per volume: -grad p.
void PorousSolver::fill_stress(const similitude_gas_step& step) {
  for (auto& axis : gradient_) {
    for (double& value : axis) value = -value;   // zero where nothing is active
  }
  FaceFlow::fill_stress(gradient_, step);
}

/// The report's momentum stays zero: this gas has none.
void PorousSolver::advance(const similitude_gas_step& step, similitude_gas_report& report) {
  set_face_fractions(step.gas_fraction, fraction_);
  set_pressure_gradient(step.pressure);
  predict(step);
  const Projected projected = project(step);
  fill_velocity(step);
  fill_stress(step);
  fill_report(step, projected, report);
  fill_flux(step);
}

void PorousSolver::save(double* out) const {
  for (const auto& axis : damped_) out = std::copy(axis.begin(), axis.end(), out);
}

void PorousSolver::load(const double* in) {
  for (auto& axis : damped_) {
    std::copy_n(in, axis.size(), axis.begin());
    in += axis.size();
  }
}

}  // namespace similitude::porous
