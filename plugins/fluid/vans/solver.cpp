#include "solver.h"

#include <algorithm>
#include <cmath>

#include "boundary.h"
#include "viscous.h"

namespace similitude::vans {

namespace {

/// visit(cell, its lower and upper face) for all cells, along one axis.
template <class Visit>
void for_each_cell(const Staggered& mesh, std::size_t axis, Visit&& visit) {
  const Index step = mesh.face_stride(axis, axis);
#pragma omp parallel for schedule(static) if (mesh.cell_count >= k_worth_threads)
  for (Index k = 0; k < mesh.cells[2]; ++k) {
    for (Index j = 0; j < mesh.cells[1]; ++j) {
      const Index cell = mesh.cell({0, j, k}), face = mesh.face(axis, {0, j, k});
      for (Index i = 0; i < mesh.cells[0]; ++i) visit(u(cell + i), u(face + i), u(face + i + step));
    }
  }
}

}  // namespace

GasSolver::GasSolver(const similitude_grid& grid, const GasOptions& options)
    : mesh_(grid), options_(options), components_(make_components(mesh_)), pressure_equation_(grid) {
  std::size_t most_sites = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    velocity_[a].assign(u(component.rows), 0.0);
    stage_[a].assign(u(component.rows), 0.0);
    gain_[a].assign(component.faces.size(), 0.0);
    viscous_[a].assign(component.faces.size(), 0.0);
    for (const auto& sites : component.sites) most_sites = std::max(most_sites, sites.size());
  }
  for (FaceFields* field : {&flux_, &fraction_old_, &fraction_, &coefficient_, &gradient_, &mobility_}) {
    *field = make_face_fields(mesh_);
  }
  site_.assign(most_sites, 0.0);
  for (auto* field : {&divergence_, &right_side_, &increment_}) field->assign(u(mesh_.cell_count), 0.0);
  for (auto& share : active_share_) share.assign(u(mesh_.cell_count), 0.0);
  for (std::size_t a = 0; a < 3; ++a) set_active_shares(a);
  refuse_inlets_without_outlet();
}

void GasSolver::start(const similitude_gas_step& fields) {
  for (auto& axis : velocity_) std::fill(axis.begin(), axis.end(), 0.0);
  std::fill_n(fields.velocity, 3 * mesh_.cell_count, 0.0);
  std::fill_n(fields.pressure, mesh_.cell_count, 0.0);
  std::fill_n(fields.stress_force, 3 * mesh_.cell_count, 0.0);
}

void GasSolver::set_face_fractions(const double* gas_fraction, FaceFields& fraction) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    const Index count = static_cast<Index>(component.faces.size());
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const ActiveFace& face = component.faces[u(n)];
      fraction[a][u(face.face)] = 0.5 * (gas_fraction[face.below] + gas_fraction[face.above]);
    }
    for (const PatchFace& inlet : component.velocity) fraction[a][u(inlet.face)] = 1;
    copy_periodic_faces(mesh_, a, fraction[a]);
  }
}

void GasSolver::set_flux(const FaceFields& fraction) {
  for (std::size_t a = 0; a < 3; ++a) {
#pragma omp parallel for schedule(static) if (mesh_.face_count[a] >= k_worth_threads)
    for (Index f = 0; f < mesh_.face_count[a]; ++f) flux_[a][u(f)] = fraction[a][u(f)] * velocity_[a][u(f)];
  }
}

void GasSolver::divergence_of(const FaceFields& field, std::vector<double>& out) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const double per_length = 1 / mesh_.spacing[a];
    const double keep = a == 0 ? 0 : 1;
    for_each_cell(mesh_, a, [&](std::size_t cell, std::size_t low, std::size_t high) {
      out[cell] = keep * out[cell] + (field[a][high] - field[a][low]) * per_length;
    });
  }
}

/// gradient = grad of a cell field at active faces; `patch_value(patch)` holds half a cell beyond pressure patches.
template <class PatchValue>
void GasSolver::set_gradient(const double* field, PatchValue&& patch_value) {
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    const double per_length = 1 / mesh_.spacing[a];
#pragma omp parallel for schedule(static) if (component.open_count >= k_worth_threads)
    for (Index n = 0; n < component.open_count; ++n) {
      const ActiveFace& face = component.faces[u(n)];
      gradient_[a][u(face.face)] = (field[face.above] - field[face.below]) * per_length;
    }
    for (const PatchFace& outlet : component.pressure) {
      const double outward = 2 * (patch_value(mesh_.grid->patches[outlet.patch]) - field[outlet.cell]) * per_length;
      gradient_[a][u(outlet.face)] = outlet.side == 1 ? outward : -outward;
    }
    copy_periodic_faces(mesh_, a, gradient_[a]);
  }
}

void GasSolver::viscous_force() {
  divergence_of(velocity_, divergence_);
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    std::fill(viscous_[a].begin(), viscous_[a].end(), 0.0);
    for (std::size_t b = 0; b < 3; ++b) {
      if (b == a) {
        tension_along(component, options_.viscosity, mesh_.spacing[a], velocity_[a], divergence_, site_);
      } else {
        tension_across(component, b, options_.viscosity, mesh_.spacing, velocity_[a], velocity_[b], site_);
      }
      pull(component, b, mesh_.spacing[b], site_, viscous_[a]);
    }
  }
}

/// gain_ += -div(F u); faces and slots of `velocity` are set.
void GasSolver::add_transport(const FaceFields& velocity) {
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      carry(components_[a], b, options_.advection, velocity[a], flux_[b], site_);
      collect(components_[a], b, mesh_.spacing[b], site_, gain_[a]);
    }
  }
}

/// predicted = the velocity under the old pressure, transported by `share` of gain_, walls and mirrors included; mobility_
/// and coefficient_ for the projection.
void GasSolver::predict(const similitude_gas_step& step, double share, FaceFields& predicted) {
  const double inertia = options_.density / step.dt;
  const bool whole_stress = options_.momentum == Momentum::model_b;
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    const double* const push = step.exchange_velocity + static_cast<Index>(a) * mesh_.cell_count;
    const double* const owed = step.remainder + static_cast<Index>(a) * mesh_.cell_count;
    const Index count = static_cast<Index>(component.faces.size());
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const ActiveFace& face = component.faces[u(n)];
      const std::size_t f = u(face.face);
      const auto mean = [&](const double* cells) { return 0.5 * (cells[face.below] + cells[face.above]); };
      const double fraction = fraction_[a][f];
      const double momentum = inertia * (fraction_old_[a][f] * velocity_[a][f]) + (share * options_.density) * gain_[a][u(n)];
      const double stressed = whole_stress ? 1 : fraction;
      const double force = stressed * (viscous_[a][u(n)] - gradient_[a][f]) + (mean(push) + mean(owed));
      const double resistance = inertia * fraction + mean(step.exchange);
      predicted[a][f] = (momentum + force) / resistance;
      mobility_[a][f] = stressed / resistance;
      coefficient_[a][f] = fraction * mobility_[a][f];
    }
    set_boundaries(mesh_, component, step.time, predicted[a]);
    copy_periodic_faces(mesh_, a, predicted[a]);
    copy_periodic_faces(mesh_, a, coefficient_[a]);
  }
}

SolveReport GasSolver::project(const similitude_gas_step& step, double& throughput) {
  pressure_equation_.set_coefficients({coefficient_[0].data(), coefficient_[1].data(), coefficient_[2].data()});
  set_flux(fraction_);
  divergence_of(flux_, right_side_);
#pragma omp parallel for schedule(static) if (mesh_.cell_count >= k_worth_threads)
  for (Index c = 0; c < mesh_.cell_count; ++c) {
    right_side_[u(c)] += (step.gas_fraction[c] - step.gas_fraction_old[c]) / step.dt;
  }
  throughput = measure_throughput(step);
  const SolveReport solved = pressure_equation_.solve(
      right_side_.data(), increment_.data(),
      {.tolerance = options_.tolerance, .scale = throughput, .most_iterations = options_.most_iterations});
  if (!solved.converged) throw_not_converged(solved);

  set_gradient(increment_.data(), [](const similitude_patch&) { return 0.0; });
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    const Index count = static_cast<Index>(component.faces.size());
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const std::size_t f = u(component.faces[u(n)].face);
      velocity_[a][f] -= mobility_[a][f] * gradient_[a][f];
    }
    copy_periodic_faces(mesh_, a, velocity_[a]);
  }
#pragma omp parallel for schedule(static) if (mesh_.cell_count >= k_worth_threads)
  for (Index c = 0; c < mesh_.cell_count; ++c) step.pressure[c] += increment_[u(c)];
  return solved;
}

void GasSolver::advance(const similitude_gas_step& step, similitude_gas_report& report) {
  set_face_fractions(step.gas_fraction_old, fraction_old_);
  set_face_fractions(step.gas_fraction, fraction_);
  for (std::size_t a = 0; a < 3; ++a) {
    set_walls(mesh_, components_[a], step.time, velocity_[a]);
    set_mirrors(components_[a], velocity_[a]);
    std::fill(gain_[a].begin(), gain_[a].end(), 0.0);
  }
  set_flux(fraction_old_);
  viscous_force();
  set_gradient(step.pressure, [](const similitude_patch& patch) { return patch.pressure; });
  add_transport(velocity_);
  predict(step, 1, stage_);
  add_transport(stage_);
  predict(step, 0.5, velocity_);
  double throughput = 0;
  const SolveReport solved = project(step, throughput);
  set_gradient(step.pressure, [](const similitude_patch& patch) { return patch.pressure; });
  fill_cells(step);
  report.iterations = solved.iterations;
  fill_report(step, throughput, report);
}

}  // namespace similitude::vans
