#include "viscous.h"

#include <algorithm>

namespace similitude::vans {

namespace {

template <class ViscosityOfSite>
void stretch(const Component& component, double spacing, const double* velocity, const double* divergence, double* tension,
             ViscosityOfSite&& viscosity) {
  const Site* const sites = component.sites[component.axis].data();
  const Row* const cells = component.cell_of_site.data();
  const double twice_per_length = 2 / spacing;
  const auto tension_of = [twice_per_length](double mu, double below, double above, double div) {
    return mu * (twice_per_length * (above - below) - 2.0 / 3.0 * div);
  };
  for_each_streak(component.site_streaks[component.axis], [&](const Streak& streak) {
    if (streak.course == Course::along) {
      const Row cell = cells[streak.begin];
      const double *const below = velocity + sites[streak.begin].below, *const above = velocity + sites[streak.begin].above;
      const double* const div = divergence + cell;
      double* const to = tension + streak.begin;
      const Row count = streak.end - streak.begin;
#pragma omp simd
      for (Row i = 0; i < count; ++i) to[i] = tension_of(viscosity(cell + i), below[i], above[i], div[i]);
      return;
    }
    for (Row n = streak.begin; n < streak.end; ++n) {
      const Row cell = cells[n];
      tension[n] = cell < 0 ? 0 : tension_of(viscosity(cell), velocity[sites[n].below], velocity[sites[n].above], divergence[cell]);
    }
  });
}

/// `viscosity(below, above)`: rows of the component around a site.
template <class ViscosityOfSite>
void shear(const Component& component, std::size_t direction, const std::array<double, 3>& spacing, const double* velocity,
           const double* crossing, double* tension, ViscosityOfSite&& viscosity) {
  const Site* const sites = component.sites[direction].data();
  const double per_length = 1 / spacing[direction], per_length_along = 1 / spacing[component.axis];
  const auto tension_of = [=](double mu, double share, double cross, double below, double above, double crossing_0, double crossing_1) {
    return mu * (share * ((above - below) * per_length) + cross * ((crossing_1 - crossing_0) * per_length_along));
  };
  for_each_streak(component.site_streaks[direction], [&](const Streak& streak) {
    if (streak.course != Course::mixed) {
      const Site& first = sites[streak.begin];
      const double *const below = velocity + first.below, *const above = velocity + first.above;
      const double *const crossing_0 = crossing + first.flux[0], *const crossing_1 = crossing + first.flux[1];
      const double share = first.shear, cross = first.cross;
      double* const to = tension + streak.begin;
      const Row count = streak.end - streak.begin;
      along_course(streak.course, [&](auto below_moves, auto above_moves) {
#pragma omp simd
        for (Row i = 0; i < count; ++i) {
          const Row b = below_moves ? i : 0, a = above_moves ? i : 0;
          to[i] = tension_of(viscosity(first.below + b, first.above + a), share, cross, below[b], above[a], crossing_0[i], crossing_1[i]);
        }
      });
      return;
    }
    for (Row n = streak.begin; n < streak.end; ++n) {
      const Site& s = sites[n];
      tension[n] = tension_of(viscosity(s.below, s.above), s.shear, s.cross, velocity[s.below], velocity[s.above], crossing[s.flux[0]],
                              crossing[s.flux[1]]);
    }
  });
}

void tension_along(const Component& component, const Viscosity& viscosity, double spacing, const double* velocity,
                   const double* divergence, double* tension) {
  const double molecular = viscosity.molecular;
  if (const double* const added = viscosity.added_in_cells) {
    stretch(component, spacing, velocity, divergence, tension, [=](Row cell) { return molecular + added[cell]; });
  } else {
    stretch(component, spacing, velocity, divergence, tension, [=](Row) { return molecular; });
  }
}

void tension_across(const Component& component, std::size_t direction, const Viscosity& viscosity,
                    const std::array<double, 3>& spacing, const double* velocity, const double* crossing, double* tension) {
  const double molecular = viscosity.molecular;
  if (viscosity.added_on_faces == nullptr) {
    shear(component, direction, spacing, velocity, crossing, tension, [=](Row, Row) { return molecular; });
    return;
  }
  // An edge between two faces has the mean of their cells; at a wall, where one of the two is a slot, the other's alone.
  const double* const added = viscosity.added_on_faces->data();
  const auto faces = static_cast<Row>(viscosity.added_on_faces->size());
  shear(component, direction, spacing, velocity, crossing, tension, [=](Row below, Row above) {
    return molecular + 0.5 * (added[below < faces ? below : above] + added[above < faces ? above : below]);
  });
}

void pull(const Component& component, const std::array<double, 3>& spacing, const SiteFields& tension, double* force) {
  const std::array<const double*, 3> at{tension[0].data(), tension[1].data(), tension[2].data()};
  const std::array<double, 3> per_length{1 / spacing[0], 1 / spacing[1], 1 / spacing[2]};
  for_each_streak(component.side_streaks, [&](const Streak& streak) {
    const bool on_patch = streak.begin >= component.open_count;   // nothing pulls along the axis
    const Sides& first = component.sides[u(streak.begin)];
    const Row count = streak.end - streak.begin;
    double* const to = force + streak.begin;
    std::fill(to, to + count, 0.0);
    for (std::size_t b = 0; b < 3; ++b) {
      if (on_patch && b == component.axis) continue;
      const double factor = per_length[b];
      if (streak.course == Course::along) {
        const double *const low = at[b] + first.low[b], *const high = at[b] + first.high[b];
#pragma omp simd
        for (Row i = 0; i < count; ++i) to[i] += (high[i] - low[i]) * factor;
      } else {
        for (Row n = streak.begin; n < streak.end; ++n) {
          const Sides& face = component.sides[u(n)];
          force[n] += (at[b][face.high[b]] - at[b][face.low[b]]) * factor;
        }
      }
    }
  });
}

}  // namespace

void viscous_force_on(const Component& component, const Viscosity& viscosity, const std::array<double, 3>& spacing,
                      const FaceFields& velocity, const std::vector<double>& divergence, SiteFields& tension,
                      std::vector<double>& force) {
  const std::size_t axis = component.axis;
#pragma omp parallel if (component.side_streaks.worth_threads())
  {
    for (std::size_t b = 0; b < 3; ++b) {
      if (b == axis) {
        tension_along(component, viscosity, spacing[axis], velocity[axis].data(), divergence.data(), tension[b].data());
      } else {
        tension_across(component, b, viscosity, spacing, velocity[axis].data(), velocity[b].data(), tension[b].data());
      }
    }
#pragma omp barrier
    pull(component, spacing, tension, force.data());
  }
}

double viscous_limit(double density, double viscosity, const std::array<double, 3>& spacing) {
  double squares = 0;
  for (const double h : spacing) squares += 1 / (h * h);
  return density / (2 * (4.0 / 3.0) * viscosity * squares);
}

}  // namespace similitude::vans
