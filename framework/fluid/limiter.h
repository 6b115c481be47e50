#pragma once
/// Koren's limiter (Koren 1993, in Numerical Methods for Advection-Diffusion Problems, Vieweg, 117): the third-order
/// upwind-biased value where a field is smooth, and no new extremes. For momentum and for what the gas carries alike.

#include <algorithm>

namespace similitude {

/// From the upwind value to the one carried across a face, in the unit of the field: (back + 2 ahead) / 6, but not more than
/// `back`, than `ahead`, or against either. `back` is the difference behind the upwind value, `ahead` the one in front of it.
inline double limited_half_step(double back, double ahead) {
  const double low = std::min({back, (back + 2 * ahead) / 6, ahead});
  const double high = std::max({back, (back + 2 * ahead) / 6, ahead});
  return low > 0 ? low : high < 0 ? high : 0;
}

}  // namespace similitude
