#include "advection.h"

#include <algorithm>

namespace similitude::vans {

namespace {

/// [m^2/s^2], mean flux times the velocity it carries.
template <Advection scheme>
inline double carried(double mean_flux, double far_below, double below, double above, double far_above) {
  const double across = above - below;
  const bool upward = mean_flux > 0;
  double value = upward ? below : above;
  if constexpr (scheme == Advection::tvd) {
    const double back = value - (upward ? far_below : far_above);
    value += limited_half_step(back, upward ? across : -across);
  }
  return mean_flux * value;
}

template <Advection scheme>
void carry(const Component& component, std::size_t direction, const double* velocity, const double* flux, double* out) {
  const Site* const sites = component.sites[direction].data();
  for_each_streak(component.site_streaks[direction], [=](const Streak& streak) {
    const Site& first = sites[streak.begin];
    if (streak.course != Course::mixed) {
      const double *const far_below = velocity + first.far_below, *const below = velocity + first.below;
      const double *const above = velocity + first.above, *const far_above = velocity + first.far_above;
      const double *const flux_0 = flux + first.flux[0], *const flux_1 = flux + first.flux[1];
      double* const to = out + streak.begin;
      const Index count = streak.end - streak.begin;
      along_course(streak.course, [=](auto below_moves, auto above_moves) {
#pragma omp simd
        for (Index i = 0; i < count; ++i) {
          const Index b = below_moves ? i : 0, a = above_moves ? i : 0;
          to[i] = carried<scheme>(0.5 * (flux_0[i] + flux_1[i]), far_below[b], below[b], above[a], far_above[a]);
        }
      });
      return;
    }
#pragma omp simd
    for (Index n = streak.begin; n < streak.end; ++n) {
      const Site& s = sites[n];
      out[n] = carried<scheme>(0.5 * (flux[s.flux[0]] + flux[s.flux[1]]), velocity[s.far_below], velocity[s.below], velocity[s.above],
                               velocity[s.far_above]);
    }
  });
}

void collect(const Component& component, const std::array<double, 3>& spacing, const SiteFields& transported, Gain kind,
             std::vector<double>& gain) {
  const std::array<const double*, 3> at{transported[0].data(), transported[1].data(), transported[2].data()};
  for_each_streak(component.side_streaks, [&](const Streak& streak) {
    std::array<double, 3> per_length;   // [1/m]
    for (std::size_t b = 0; b < 3; ++b) per_length[b] = 1 / spacing[b];
    if (streak.begin >= component.open_count) per_length[component.axis] = 2 / spacing[component.axis];   // half a box
    const double px = per_length[0], py = per_length[1], pz = per_length[2];
    double* const to = gain.data() + streak.begin;
    if (kind == Gain::first) std::fill(to, to + (streak.end - streak.begin), 0.0);
    if (streak.course == Course::along) {
      const Sides& first = component.sides[u(streak.begin)];
      const double *const xl = at[0] + first.low[0], *const xh = at[0] + first.high[0], *const yl = at[1] + first.low[1];
      const double *const yh = at[1] + first.high[1], *const zl = at[2] + first.low[2], *const zh = at[2] + first.high[2];
      const Index count = streak.end - streak.begin;
#pragma omp simd
      for (Index i = 0; i < count; ++i) {
        double value = to[i];
        value -= (xh[i] - xl[i]) * px;
        value -= (yh[i] - yl[i]) * py;
        value -= (zh[i] - zl[i]) * pz;
        to[i] = value;
      }
      return;
    }
    for (Index n = streak.begin; n < streak.end; ++n) {
      const Sides& face = component.sides[u(n)];
      double& value = gain[u(n)];
      value -= (at[0][face.high[0]] - at[0][face.low[0]]) * px;
      value -= (at[1][face.high[1]] - at[1][face.low[1]]) * py;
      value -= (at[2][face.high[2]] - at[2][face.low[2]]) * pz;
    }
  });
}

}  // namespace

void transport(const Component& component, Advection scheme, const std::array<double, 3>& spacing, const std::vector<double>& velocity,
               const FaceFields& flux, SiteFields& sites, Gain kind, std::vector<double>& gain) {
#pragma omp parallel if (component.side_streaks.worth_threads())
  {
    for (std::size_t b = 0; b < 3; ++b) {
      if (scheme == Advection::tvd) {
        carry<Advection::tvd>(component, b, velocity.data(), flux[b].data(), sites[b].data());
      } else {
        carry<Advection::upwind>(component, b, velocity.data(), flux[b].data(), sites[b].data());
      }
    }
#pragma omp barrier
    collect(component, spacing, sites, kind, gain);
  }
}

}  // namespace similitude::vans
