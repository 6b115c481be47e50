#pragma once
/// The gradient of the gas velocity in cells, from cell velocities: differences across a cell between the means on its
/// faces. On a no-slip wall or baffle the gas rests, along a slip wall it keeps the cell's velocity, a patch of given
/// velocity brings its own, an opening lets it out unchanged. Exact for velocities that are linear in space.

#include <array>
#include <cstddef>

#include "fluid/staggered.h"

namespace similitude {

/// gradient[a][b] [1/s]: d(u_a)/d(x_b).
using VelocityGradient = std::array<std::array<double, 3>, 3>;

/// `velocity` [m/s]: 3 x cells. `time` [s]: of inlets' ramps.
VelocityGradient velocity_gradient(const Staggered& mesh, const double* velocity, const Triple& cell, double time);

/// [1/s], sqrt(2 S:S), S = (G + G^T)/2: |du/dy| in a simple shear.
double strain_rate(const VelocityGradient& gradient);
/// [1/s], curl u.
std::array<double, 3> vorticity(const VelocityGradient& gradient);

}  // namespace similitude
