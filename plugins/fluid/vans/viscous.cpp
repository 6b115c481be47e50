#include "viscous.h"

namespace similitude::vans {

namespace {

template <class ViscosityOfSite>
void stretch(const Component& component, double spacing, const std::vector<double>& velocity, const std::vector<double>& divergence,
             std::vector<double>& tension, ViscosityOfSite&& viscosity) {
  const std::vector<Site>& sites = component.sites[component.axis];
  const Index count = static_cast<Index>(sites.size());
  const double twice_per_length = 2 / spacing;
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
  for (Index n = 0; n < count; ++n) {
    const Row cell = component.cell_of_site[u(n)];
    const Site& s = sites[u(n)];
    tension[u(n)] = cell < 0 ? 0
                             : viscosity(cell) * (twice_per_length * (velocity[u(s.above)] - velocity[u(s.below)]) -
                                                  2.0 / 3.0 * divergence[u(cell)]);
  }
}

template <class ViscosityOfSite>
void shear(const Component& component, std::size_t direction, const std::array<double, 3>& spacing,
           const std::vector<double>& velocity, const std::vector<double>& crossing, std::vector<double>& tension,
           ViscosityOfSite&& viscosity) {
  const std::vector<Site>& sites = component.sites[direction];
  const Index count = static_cast<Index>(sites.size());
  const double per_length = 1 / spacing[direction], per_length_along = 1 / spacing[component.axis];
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
  for (Index n = 0; n < count; ++n) {
    const Site& s = sites[u(n)];
    tension[u(n)] = viscosity(s) * (s.shear * ((velocity[u(s.above)] - velocity[u(s.below)]) * per_length) +
                                    s.cross * ((crossing[u(s.flux[1])] - crossing[u(s.flux[0])]) * per_length_along));
  }
}

}  // namespace

void tension_along(const Component& component, const Viscosity& viscosity, double spacing, const std::vector<double>& velocity,
                   const std::vector<double>& divergence, std::vector<double>& tension) {
  const double molecular = viscosity.molecular;
  if (const double* const added = viscosity.added_in_cells) {
    stretch(component, spacing, velocity, divergence, tension, [=](Row cell) { return molecular + added[cell]; });
  } else {
    stretch(component, spacing, velocity, divergence, tension, [=](Row) { return molecular; });
  }
}

void tension_across(const Component& component, std::size_t direction, const Viscosity& viscosity,
                    const std::array<double, 3>& spacing, const std::vector<double>& velocity, const std::vector<double>& crossing,
                    std::vector<double>& tension) {
  const double molecular = viscosity.molecular;
  if (viscosity.added_on_faces == nullptr) {
    shear(component, direction, spacing, velocity, crossing, tension, [=](const Site&) { return molecular; });
    return;
  }
  // An edge between two faces has the mean of their cells; at a wall, where one of the two is a slot, the other's alone.
  const std::vector<double>& added = *viscosity.added_on_faces;
  const auto faces = static_cast<Row>(added.size());
  shear(component, direction, spacing, velocity, crossing, tension, [&added, faces, molecular](const Site& s) {
    const double below = added[u(s.below < faces ? s.below : s.above)];
    const double above = added[u(s.above < faces ? s.above : s.below)];
    return molecular + 0.5 * (below + above);
  });
}

void pull(const Component& component, std::size_t direction, double spacing, const std::vector<double>& tension,
          std::vector<double>& force) {
  const bool along = direction == component.axis;
  const Index count = along ? component.open_count : static_cast<Index>(component.sides.size());
  const double per_length = 1 / spacing;
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
  for (Index n = 0; n < count; ++n) {
    const Sides& face = component.sides[u(n)];
    force[u(n)] += (tension[u(face.high[direction])] - tension[u(face.low[direction])]) * per_length;
  }
}

double viscous_limit(double density, double viscosity, const std::array<double, 3>& spacing) {
  double squares = 0;
  for (const double h : spacing) squares += 1 / (h * h);
  return density / (2 * (4.0 / 3.0) * viscosity * squares);
}

}  // namespace similitude::vans
