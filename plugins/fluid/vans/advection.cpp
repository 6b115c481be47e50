#include "advection.h"

namespace similitude::vans {

namespace {

template <Advection scheme>
void carry_with(const Component& component, std::size_t direction, const double* velocity, const double* flux, double* out) {
  const Site* const sites = component.sites[direction].data();
  const Index count = static_cast<Index>(component.sites[direction].size());
#pragma omp parallel for simd schedule(static) if (parallel : count >= k_worth_threads)
  for (Index n = 0; n < count; ++n) {
    const Site& s = sites[n];
    const double mean_flux = 0.5 * (flux[s.flux[0]] + flux[s.flux[1]]);
    const double below = velocity[s.below], above = velocity[s.above];
    const double across = above - below;
    const bool upward = mean_flux > 0;
    double carried = upward ? below : above;
    if constexpr (scheme == Advection::tvd) {
      const double back = carried - velocity[upward ? s.far_below : s.far_above];
      carried += limited_half_step(back, upward ? across : -across);
    }
    out[n] = mean_flux * carried;
  }
}

}  // namespace

void carry(const Component& component, std::size_t direction, Advection scheme, const std::vector<double>& velocity,
           const std::vector<double>& flux, std::vector<double>& transported) {
  if (scheme == Advection::tvd) {
    carry_with<Advection::tvd>(component, direction, velocity.data(), flux.data(), transported.data());
  } else {
    carry_with<Advection::upwind>(component, direction, velocity.data(), flux.data(), transported.data());
  }
}

void collect(const Component& component, std::size_t direction, double spacing, const std::vector<double>& transported,
             std::vector<double>& gain) {
  const Index count = static_cast<Index>(component.sides.size());
  const double whole = 1 / spacing;
  const double half_box = direction == component.axis ? 2 / spacing : whole;
#pragma omp parallel for schedule(static) if (count >= k_worth_threads)
  for (Index n = 0; n < count; ++n) {
    const Sides& face = component.sides[u(n)];
    const double per_length = n < component.open_count ? whole : half_box;
    gain[u(n)] -= (transported[u(face.high[direction])] - transported[u(face.low[direction])]) * per_length;
  }
}

}  // namespace similitude::vans
