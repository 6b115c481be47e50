#include "fluid/face_flow.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "fluid/regions.h"

namespace similitude::flow {

namespace {

// [-], of a cell's gas: what moves less in a step is rounding, not flow.
constexpr double k_still = 1e-9;
// [-], of the inflow: how far the inlets of a closed region may be out of balance.
constexpr double k_balanced = 1e-9;

std::string place_of(const Staggered& mesh, Index cell) {
  char text[96];
  std::snprintf(text, sizeof text, "cell (%td, %td, %td)", cell % mesh.cells[0], cell / mesh.cells[0] % mesh.cells[1],
                cell / (mesh.cells[0] * mesh.cells[1]));
  return text;
}

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

FaceFlow::FaceFlow(const similitude_grid& grid, const Options& options)
    : mesh_(grid), options_(options), pressure_equation_(grid) {
  for (FaceFields* field : {&velocity_, &flux_, &fraction_, &mobility_, &coefficient_, &gradient_}) *field = make_face_fields(mesh_);
  for (auto* field : {&divergence_, &right_side_, &increment_}) field->assign(u(mesh_.cell_count), 0.0);
  for (std::size_t a = 0; a < 3; ++a) {
    tables_[a] = make_face_table(mesh_, a);
    active_share_[a].assign(u(mesh_.cell_count), 0.0);
    set_active_shares(a);
  }
  refuse_inlets_without_outlet();
}

void FaceFlow::start(const similitude_gas_step& fields) {
  for (auto& axis : velocity_) std::fill(axis.begin(), axis.end(), 0.0);
  std::fill_n(fields.velocity, 3 * mesh_.cell_count, 0.0);
  std::fill_n(fields.pressure, mesh_.cell_count, 0.0);
  std::fill_n(fields.stress_force, 3 * mesh_.cell_count, 0.0);
}

void FaceFlow::set_face_fractions(const double* gas_fraction, FaceFields& fraction) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const FaceTable& table = tables_[a];
    const Index count = static_cast<Index>(table.faces.size());
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const ActiveFace& face = table.faces[u(n)];
      fraction[a][u(face.face)] = 0.5 * (gas_fraction[face.below] + gas_fraction[face.above]);
    }
    for (const PatchFace& inlet : table.velocity) fraction[a][u(inlet.face)] = 1;
    copy_periodic_faces(mesh_, a, fraction[a]);
  }
}

void FaceFlow::set_flux(const FaceFields& fraction) {
  for (std::size_t a = 0; a < 3; ++a) {
#pragma omp parallel for schedule(static) if (mesh_.face_count[a] >= k_worth_threads)
    for (Index f = 0; f < mesh_.face_count[a]; ++f) flux_[a][u(f)] = fraction[a][u(f)] * velocity_[a][u(f)];
  }
}

void FaceFlow::divergence_of(const FaceFields& field, std::vector<double>& out) const {
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
void FaceFlow::set_gradient(const double* field, PatchValue&& patch_value) {
  for (std::size_t a = 0; a < 3; ++a) {
    const FaceTable& table = tables_[a];
    const double per_length = 1 / mesh_.spacing[a];
#pragma omp parallel for schedule(static) if (table.open_count >= k_worth_threads)
    for (Index n = 0; n < table.open_count; ++n) {
      const ActiveFace& face = table.faces[u(n)];
      gradient_[a][u(face.face)] = (field[face.above] - field[face.below]) * per_length;
    }
    for (const PatchFace& outlet : table.pressure) {
      const double outward = 2 * (patch_value(mesh_.grid->patches[outlet.patch]) - field[outlet.cell]) * per_length;
      gradient_[a][u(outlet.face)] = outlet.side == 1 ? outward : -outward;
    }
    copy_periodic_faces(mesh_, a, gradient_[a]);
  }
}

void FaceFlow::set_pressure_gradient(const double* pressure) {
  set_gradient(pressure, [](const similitude_patch& patch) { return patch.pressure; });
}

void FaceFlow::refuse_inlets_without_outlet() const {
  const multigrid::Regions regions(mesh_);
  std::vector<double> net(regions.reaches_outlet.size(), 0.0), gross(net.size(), 0.0);
  for (std::size_t a = 0; a < 3; ++a) {
    for (const PatchFace& inlet : tables_[a].velocity) {
      const similitude_patch& patch = mesh_.grid->patches[inlet.patch];
      const double volume = inlet.inward(patch.velocity[a]) * mesh_.face_area(a);
      const std::size_t region = regions.label[u(inlet.cell)];
      net[region] += volume;
      gross[region] += std::abs(volume);
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (const PatchFace& inlet : tables_[a].velocity) {
      const std::size_t region = regions.label[u(inlet.cell)];
      if (regions.reaches_outlet[region] || std::abs(net[region]) <= k_balanced * gross[region]) continue;
      throw std::invalid_argument(std::string("patch ") + mesh_.grid->patches[inlet.patch].name +
                                  " blows into a region without an opening: the gas has nowhere to go.\n  Add a patch of "
                                  "given pressure, e.g. outlet: {face: top, pressure: 0 Pa}.");
    }
  }
}

void FaceFlow::set_active_shares(std::size_t axis) {
  std::vector<double>& share = active_share_[axis];
  const FaceTable& table = tables_[axis];
  for (std::size_t n = 0; n < table.faces.size(); ++n) {
    const ActiveFace& face = table.faces[n];
    share[u(face.below)] += 1;
    if (static_cast<Index>(n) < table.open_count) share[u(face.above)] += 1;
  }
  for (double& value : share) value = value > 0 ? 1 / value : 0;
}

double FaceFlow::measure_throughput(const similitude_gas_step& step) const {
  double largest = k_still / step.dt;
#pragma omp parallel for schedule(static) reduction(max : largest) if (mesh_.cell_count >= k_worth_threads)
  for (Index k = 0; k < mesh_.cells[2]; ++k) {
    for (Index j = 0; j < mesh_.cells[1]; ++j) {
      for (Index i = 0; i < mesh_.cells[0]; ++i) {
        const Index cell = mesh_.cell({i, j, k});
        double through = std::abs(step.gas_fraction[cell] - step.gas_fraction_old[cell]) / step.dt;
        for (std::size_t a = 0; a < 3; ++a) {
          const Index low = mesh_.face(a, {i, j, k}), high = low + mesh_.face_stride(a, a);
          through += 0.5 * (std::abs(flux_[a][u(low)]) + std::abs(flux_[a][u(high)])) / mesh_.spacing[a];
        }
        largest = std::max(largest, through);
      }
    }
  }
  double inflow = 0;  // [1/s], per volume of one cell
  for (std::size_t a = 0; a < 3; ++a) {
    for (const PatchFace& inlet : tables_[a].velocity) {
      inflow += std::max(0.0, inlet.inward(velocity_[a][u(inlet.face)])) / mesh_.spacing[a];
    }
  }
  return std::max(largest, inflow);
}

FaceFlow::Projected FaceFlow::project(const similitude_gas_step& step) {
  pressure_equation_.set_coefficients({coefficient_[0].data(), coefficient_[1].data(), coefficient_[2].data()});
  set_flux(fraction_);
  divergence_of(flux_, right_side_);
#pragma omp parallel for schedule(static) if (mesh_.cell_count >= k_worth_threads)
  for (Index c = 0; c < mesh_.cell_count; ++c) {
    right_side_[u(c)] += (step.gas_fraction[c] - step.gas_fraction_old[c]) / step.dt;
  }
  const double throughput = measure_throughput(step);
  const SolveReport solved = pressure_equation_.solve(
      right_side_.data(), increment_.data(),
      {.tolerance = options_.tolerance, .scale = throughput, .most_iterations = options_.most_iterations});
  if (!solved.converged) throw_not_converged(solved);

  set_gradient(increment_.data(), [](const similitude_patch&) { return 0.0; });
  for (std::size_t a = 0; a < 3; ++a) {
    const FaceTable& table = tables_[a];
    const Index count = static_cast<Index>(table.faces.size());
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const std::size_t f = u(table.faces[u(n)].face);
      velocity_[a][f] -= mobility_[a][f] * gradient_[a][f];
    }
    copy_periodic_faces(mesh_, a, velocity_[a]);
  }
#pragma omp parallel for schedule(static) if (mesh_.cell_count >= k_worth_threads)
  for (Index c = 0; c < mesh_.cell_count; ++c) step.pressure[c] += increment_[u(c)];
  set_pressure_gradient(step.pressure);
  return {solved.iterations, throughput};
}

void FaceFlow::fill_velocity(const similitude_gas_step& step) const {
  for (std::size_t a = 0; a < 3; ++a) {
    double* const velocity = step.velocity + static_cast<Index>(a) * mesh_.cell_count;
    for_each_cell(mesh_, a, [&](std::size_t cell, std::size_t low, std::size_t high) {
      velocity[cell] = 0.5 * (velocity_[a][low] + velocity_[a][high]);
    });
    // An inlet face carries the superficial velocity of the empty duct outside; particles inside meet the same flux
    // between themselves. With the duct's value the lowest layer of a bed would feel half its drag.
    for (const PatchFace& inlet : tables_[a].velocity) {
      const double outside = velocity_[a][u(inlet.face)];
      velocity[inlet.cell] += 0.5 * (outside / step.gas_fraction[inlet.cell] - outside);
    }
  }
}

void FaceFlow::fill_flux(const similitude_gas_step& step) const {
  for (std::size_t a = 0; a < 3; ++a) {
    if (step.flux[a] != nullptr) std::copy_n(flux_[a].begin(), mesh_.face_count[a], step.flux[a]);
  }
}

void FaceFlow::fill_stress(const FaceFields& force, const similitude_gas_step& step) const {
  for (std::size_t a = 0; a < 3; ++a) {
    double* const stress = step.stress_force + static_cast<Index>(a) * mesh_.cell_count;
    for_each_cell(mesh_, a, [&](std::size_t cell, std::size_t low, std::size_t high) {
      stress[cell] = active_share_[a][cell] * (force[a][low] + force[a][high]);
    });
  }
}

void FaceFlow::fill_report(const similitude_gas_step& step, const Projected& projected, similitude_gas_report& report) {
  set_flux(fraction_);
  divergence_of(flux_, divergence_);
  double residual = 0, courant = 0;
  Index lost = mesh_.cell_count;  // first cell whose velocity is no number
#pragma omp parallel for schedule(static) reduction(max : residual, courant) reduction(min : lost) if (mesh_.cell_count >= k_worth_threads)
  for (Index k = 0; k < mesh_.cells[2]; ++k) {
    for (Index j = 0; j < mesh_.cells[1]; ++j) {
      for (Index i = 0; i < mesh_.cells[0]; ++i) {
        const Index cell = mesh_.cell({i, j, k});
        const double rate = (step.gas_fraction[cell] - step.gas_fraction_old[cell]) / step.dt;
        residual = std::max(residual, std::abs(divergence_[u(cell)] + rate));
        double crossings = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          const Index low = mesh_.face(a, {i, j, k}), high = low + mesh_.face_stride(a, a);
          crossings += std::max(std::abs(velocity_[a][u(low)]), std::abs(velocity_[a][u(high)])) * step.dt / mesh_.spacing[a];
        }
        courant = std::max(courant, crossings);
        if (!std::isfinite(divergence_[u(cell)])) lost = std::min(lost, cell);
      }
    }
  }
  if (lost < mesh_.cell_count) {
    throw std::runtime_error("the gas velocity is not finite in " + place_of(mesh_, lost) +
                             ": the step is too long for the flow, or a field from the particles is not finite.\n"
                             "  Use a smaller time.gas_dt.");
  }
  report.iterations = projected.iterations;
  report.mass_residual = residual / projected.throughput;
  report.courant = courant;
  report.inflow = report.outflow = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const FaceTable& table = tables_[a];
    for (const auto* patches : {&table.velocity, &table.pressure}) {
      for (const PatchFace& face : *patches) {
        const double mass = options_.density * mesh_.face_area(a) * face.inward(flux_[a][u(face.face)]);
        (mass > 0 ? report.inflow : report.outflow) += std::abs(mass);
      }
    }
  }
}

void FaceFlow::throw_not_converged(const SolveReport& solved) const {
  char text[400];
  std::snprintf(text, sizeof text,
                "the pressure equation did not converge: a cell's mass balance is off by %.2g of the throughput after %d "
                "iterations (wanted: %.2g). Usually the gas step is too long for the drag or the bed changed too much in it.\n"
                "  Use a smaller time.gas_dt, or raise models.fluid.iterations.",
                solved.residual, solved.iterations, options_.tolerance);
  throw std::runtime_error(text);
}

std::uint64_t FaceFlow::state_size() const {
  return static_cast<std::uint64_t>(mesh_.face_count[0] + mesh_.face_count[1] + mesh_.face_count[2]);
}

void FaceFlow::save(double* out) const {
  for (std::size_t a = 0; a < 3; ++a) out = std::copy_n(velocity_[a].begin(), mesh_.face_count[a], out);
}

void FaceFlow::load(const double* in) {
  for (std::size_t a = 0; a < 3; ++a) {
    std::copy_n(in, mesh_.face_count[a], velocity_[a].begin());
    in += mesh_.face_count[a];
  }
}

}  // namespace similitude::flow
