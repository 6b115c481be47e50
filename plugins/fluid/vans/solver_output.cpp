// What a step tells its host: cell fields, balances, and what went wrong.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "fluid/regions.h"
#include "solver.h"

namespace similitude::vans {

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

/// [m/s], into the domain.
double inward(const PatchFace& face, double velocity) { return face.side == 0 ? velocity : -velocity; }

}  // namespace

void GasSolver::refuse_inlets_without_outlet() const {
  const multigrid::Regions regions(mesh_);
  std::vector<double> net(regions.reaches_outlet.size(), 0.0), gross(net.size(), 0.0);
  for (std::size_t a = 0; a < 3; ++a) {
    for (const PatchFace& inlet : components_[a].velocity) {
      const similitude_patch& patch = mesh_.grid->patches[inlet.patch];
      const double volume = inward(inlet, patch.velocity[a]) * mesh_.face_area(a);
      const std::size_t region = regions.label[u(inlet.cell)];
      net[region] += volume;
      gross[region] += std::abs(volume);
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (const PatchFace& inlet : components_[a].velocity) {
      const std::size_t region = regions.label[u(inlet.cell)];
      if (regions.reaches_outlet[region] || std::abs(net[region]) <= k_balanced * gross[region]) continue;
      throw std::invalid_argument(std::string("patch ") + mesh_.grid->patches[inlet.patch].name +
                                  " blows into a region without an opening: the gas has nowhere to go.\n  Add a patch of "
                                  "given pressure, e.g. outlet: {face: top, pressure: 0 Pa}.");
    }
  }
}

void GasSolver::set_active_shares(std::size_t axis) {
  std::vector<double>& share = active_share_[axis];
  const Component& component = components_[axis];
  for (std::size_t n = 0; n < component.faces.size(); ++n) {
    const ActiveFace& face = component.faces[n];
    share[u(face.below)] += 1;
    if (static_cast<Index>(n) < component.open_count) share[u(face.above)] += 1;
  }
  for (double& value : share) value = value > 0 ? 1 / value : 0;
}

double GasSolver::measure_throughput(const similitude_gas_step& step) const {
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
    for (const PatchFace& inlet : components_[a].velocity) {
      inflow += std::max(0.0, inward(inlet, velocity_[a][u(inlet.face)])) / mesh_.spacing[a];
    }
  }
  return std::max(largest, inflow);
}

void GasSolver::fill_cells(const similitude_gas_step& step) {
  const bool reaches_particles = options_.momentum == Momentum::model_a;
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    const Index count = static_cast<Index>(component.faces.size());
    std::vector<double>& force = gradient_[a];  // faces; zero where nothing is active
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
    for (Index n = 0; n < count; ++n) {
      const std::size_t f = u(component.faces[u(n)].face);
      force[f] = viscous_[a][u(n)] - force[f];
    }
    copy_periodic_faces(mesh_, a, force);
    double* const velocity = step.velocity + static_cast<Index>(a) * mesh_.cell_count;
    double* const stress = step.stress_force + static_cast<Index>(a) * mesh_.cell_count;
    const Index stride = mesh_.face_stride(a, a);
#pragma omp parallel for schedule(static) if (mesh_.cell_count >= k_worth_threads)
    for (Index k = 0; k < mesh_.cells[2]; ++k) {
      for (Index j = 0; j < mesh_.cells[1]; ++j) {
        for (Index i = 0; i < mesh_.cells[0]; ++i) {
          const Index cell = mesh_.cell({i, j, k}), low = mesh_.face(a, {i, j, k}), high = low + stride;
          velocity[cell] = 0.5 * (velocity_[a][u(low)] + velocity_[a][u(high)]);
          stress[cell] = reaches_particles ? active_share_[a][u(cell)] * (force[u(low)] + force[u(high)]) : 0;
        }
      }
    }
    // An inlet face carries the superficial velocity of the empty duct outside; particles inside meet the same flux
    // between themselves. With the duct's value the lowest layer of a bed would feel half its drag.
    for (const PatchFace& inlet : component.velocity) {
      const double outside = velocity_[a][u(inlet.face)];
      velocity[inlet.cell] += 0.5 * (outside / step.gas_fraction[inlet.cell] - outside);
    }
  }
}

void GasSolver::fill_report(const similitude_gas_step& step, double throughput, similitude_gas_report& report) {
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
  report.mass_residual = residual / throughput;
  report.courant = courant;
  report.inflow = report.outflow = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const Component& component = components_[a];
    for (const auto* patches : {&component.velocity, &component.pressure}) {
      for (const PatchFace& face : *patches) {
        const double mass = options_.density * mesh_.face_area(a) * inward(face, flux_[a][u(face.face)]);
        (mass > 0 ? report.inflow : report.outflow) += std::abs(mass);
      }
    }
    double whole_boxes = 0, half_boxes = 0;
    const Index count = static_cast<Index>(component.faces.size());
    for (Index n = 0; n < component.open_count; ++n) whole_boxes += flux_[a][u(component.faces[u(n)].face)];
    for (Index n = component.open_count; n < count; ++n) half_boxes += flux_[a][u(component.faces[u(n)].face)];
    report.momentum[a] = options_.density * mesh_.cell_volume() * (whole_boxes + 0.5 * half_boxes);
  }
}

void GasSolver::throw_not_converged(const SolveReport& solved) const {
  char text[400];
  std::snprintf(text, sizeof text,
                "the pressure equation did not converge: a cell's mass balance is off by %.2g of the throughput after %d "
                "iterations (wanted: %.2g). Usually the gas step is too long for the drag or the bed changed too much in it.\n"
                "  Use a smaller time.gas_dt, or raise models.fluid.iterations.",
                solved.residual, solved.iterations, options_.tolerance);
  throw std::runtime_error(text);
}

std::uint64_t GasSolver::state_size() const {
  return static_cast<std::uint64_t>(mesh_.face_count[0] + mesh_.face_count[1] + mesh_.face_count[2]);
}

void GasSolver::save(double* out) const {
  for (std::size_t a = 0; a < 3; ++a) out = std::copy_n(velocity_[a].begin(), mesh_.face_count[a], out);
}

void GasSolver::load(const double* in) {
  for (std::size_t a = 0; a < 3; ++a) {
    std::copy_n(in, mesh_.face_count[a], velocity_[a].begin());
    in += mesh_.face_count[a];
  }
}

}  // namespace similitude::vans
