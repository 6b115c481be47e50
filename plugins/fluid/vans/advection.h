#pragma once
/// Transport of momentum by the gas: div(F u) in conservative form, upwind with Koren's limiter (Koren 1993, in Numerical
/// Methods for Advection-Diffusion Problems, Vieweg, 117): the third-order upwind-biased value where smooth, and no new
/// extremes.

#include <algorithm>

#include "stencils.h"

namespace similitude::vans {

enum class Advection { tvd, upwind };

/// [m/s], from the upwind velocity to the one carried across a face: (back + 2 ahead) / 6, but not more than `back`, than
/// `ahead`, or against either. `back` is the difference behind the upwind velocity, `ahead` the one in front of it.
inline double limited_half_step(double back, double ahead) {
  const double low = std::min({back, (back + 2 * ahead) / 6, ahead});
  const double high = std::max({back, (back + 2 * ahead) / 6, ahead});
  return low > 0 ? low : high < 0 ? high : 0;
}

/// transported[site] [m^2/s^2]: mean flux times the velocity it carries, for sites of one direction.
/// `flux` [m/s] is eps u on the faces of that direction.
void carry(const Component& component, std::size_t direction, Advection scheme, const std::vector<double>& velocity,
           const std::vector<double>& flux, std::vector<double>& transported);

/// gain[active face] [m/s^2] += -d(transported)/d(direction). At a pressure patch half a box gains along the axis.
void collect(const Component& component, std::size_t direction, double spacing, const std::vector<double>& transported,
             std::vector<double>& gain);

}  // namespace similitude::vans
