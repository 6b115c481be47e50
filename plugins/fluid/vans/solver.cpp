#include "solver.h"

#include <algorithm>
#include <cmath>

#include "boundary.h"
#include "viscous.h"

namespace similitude::vans {

GasSolver::GasSolver(const similitude_grid& grid, const GasOptions& options)
    : FaceFlow(grid, {.density = options.density, .tolerance = options.tolerance, .most_iterations = options.most_iterations}),
      options_(options), components_{make_component(mesh_, tables_[0], 0), make_component(mesh_, tables_[1], 1),
                                     make_component(mesh_, tables_[2], 2)} {
  std::array<std::size_t, 3> most_sites{};
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    velocity_[a].assign(u(component.rows), 0.0);
    stage_[a].assign(u(component.rows), 0.0);
    gain_[a].assign(tables_[a].faces.size(), 0.0);
    viscous_[a].assign(tables_[a].faces.size(), 0.0);
    for (std::size_t b = 0; b < 3; ++b) most_sites[b] = std::max(most_sites[b], component.sites[b].size());
  }
  fraction_old_ = make_face_fields(mesh_);
  for (std::size_t b = 0; b < 3; ++b) sites_[b].assign(most_sites[b], 0.0);
}

/// Means of the two cells of every face, walls and patches included.
void GasSolver::set_added_viscosity(const double* added_in_cells) {
  if (cells_of_[0].empty()) {
    added_viscosity_ = make_face_fields(mesh_);
    for (std::size_t a = 0; a < 3; ++a) {
      Triple at{};
      for (at[2] = 0; at[2] < mesh_.face_extent[a][2]; ++at[2]) {
        for (at[1] = 0; at[1] < mesh_.face_extent[a][1]; ++at[1]) {
          for (at[0] = 0; at[0] < mesh_.face_extent[a][0]; ++at[0]) {
            const auto [below, above] = mesh_.cells_of_face(a, at);
            cells_of_[a].push_back({static_cast<Row>(below < 0 ? above : below), static_cast<Row>(above < 0 ? below : above)});
          }
        }
      }
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
#pragma omp parallel for schedule(static) if (mesh_.face_count[a] >= k_worth_threads)
    for (Index f = 0; f < mesh_.face_count[a]; ++f) {
      const auto [below, above] = cells_of_[a][u(f)];
      added_viscosity_[a][u(f)] = 0.5 * (added_in_cells[below] + added_in_cells[above]);
    }
  }
}

void GasSolver::viscous_force(const similitude_gas_step& step) {
  divergence_of(velocity_, divergence_);
  const bool adds = step.added_viscosity != nullptr;
  if (adds) set_added_viscosity(step.added_viscosity);
  for (std::size_t a = 0; a < 3; ++a) {
    const Viscosity viscosity{options_.viscosity, step.added_viscosity, adds ? &added_viscosity_[a] : nullptr};
    viscous_force_on(components_[a], viscosity, mesh_.spacing, velocity_, divergence_, sites_, viscous_[a]);
  }
}

/// gain_ = or += -div(F u); faces and slots of `velocity` are set.
void GasSolver::add_transport(const FaceFields& velocity, Gain kind) {
  for (std::size_t a = 0; a < 3; ++a) {
    transport(components_[a], options_.advection, mesh_.spacing, velocity[a], flux_, sites_, kind, gain_[a]);
  }
}

/// predicted = the velocity under the old pressure, transported by `share` of gain_, walls and mirrors included; mobility_
/// and coefficient_ for the projection.
void GasSolver::predict(const similitude_gas_step& step, double share, FaceFields& predicted) {
  const double inertia = options_.density / step.dt;
  const bool whole_stress = options_.momentum == Momentum::model_b;
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
      const double fraction = fraction_[a][f];
      const double momentum = inertia * (fraction_old_[a][f] * velocity_[a][f]) + (share * options_.density) * gain_[a][u(n)];
      const double stressed = whole_stress ? 1 : fraction;
      const double force = stressed * (viscous_[a][u(n)] - gradient_[a][f]) + (mean(push) + mean(owed));
      const double resistance = inertia * fraction + mean(step.exchange);
      predicted[a][f] = (momentum + force) / resistance;
      mobility_[a][f] = stressed / resistance;
      coefficient_[a][f] = fraction * mobility_[a][f];
    }
    set_boundaries(mesh_, table, components_[a], step.time, predicted[a]);
    flow::copy_periodic_faces(mesh_, a, predicted[a]);
    flow::copy_periodic_faces(mesh_, a, coefficient_[a]);
  }
}

void GasSolver::advance(const similitude_gas_step& step, similitude_gas_report& report) {
  set_face_fractions(step.gas_fraction_old, fraction_old_);
  set_face_fractions(step.gas_fraction, fraction_);
  for (std::size_t a = 0; a < 3; ++a) {
    set_walls(mesh_, components_[a], step.time, velocity_[a]);
    set_mirrors(components_[a], velocity_[a]);
  }
  set_flux(fraction_old_);
  viscous_force(step);
  set_pressure_gradient(step.pressure);
  add_transport(velocity_, Gain::first);
  predict(step, 1, stage_);
  add_transport(stage_, Gain::more);
  predict(step, 0.5, velocity_);
  const Projected projected = project(step);
  fill_velocity(step);
  if (options_.momentum == Momentum::model_a) fill_stress(step);
  fill_report(step, projected, report);
  fill_flux(step);
  fill_momentum(report);
}

/// What particles receive per volume: -grad p + div(tau).
void GasSolver::fill_stress(const similitude_gas_step& step) {
  FaceFields& force = gradient_;  // faces; zero where nothing is active
  for (std::size_t a = 0; a < 3; ++a) {
    const FaceTable& table = tables_[a];
    const Index count = static_cast<Index>(table.faces.size());
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const std::size_t f = u(table.faces[u(n)].face);
      force[a][f] = viscous_[a][u(n)] - force[a][f];
    }
    flow::copy_periodic_faces(mesh_, a, force[a]);
  }
  FaceFlow::fill_stress(force, step);
}

void GasSolver::fill_momentum(similitude_gas_report& report) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const FaceTable& table = tables_[a];
    double whole_boxes = 0, half_boxes = 0;
    const Index count = static_cast<Index>(table.faces.size());
    for (Index n = 0; n < table.open_count; ++n) whole_boxes += flux_[a][u(table.faces[u(n)].face)];
    for (Index n = table.open_count; n < count; ++n) half_boxes += flux_[a][u(table.faces[u(n)].face)];
    report.momentum[a] = options_.density * mesh_.cell_volume() * (whole_boxes + 0.5 * half_boxes);
  }
}

}  // namespace similitude::vans
