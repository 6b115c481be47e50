#pragma once
/// Transport of momentum by the gas: div(F u) in conservative form, upwind with Koren's limiter (fluid/limiter.h).

#include "fluid/limiter.h"
#include "stencils.h"

namespace similitude::vans {

enum class Advection { tvd, upwind };

/// Whether what is gained comes on top of what there was.
enum class Gain { first, more };

/// gain[active face] [m/s^2] = or += -div(F u) of one component. `flux` [m/s] is eps u on the faces of each direction; `sites`
/// is room for [m^2/s^2] on its sites. At a pressure patch half a box gains along the axis.
void transport(const Component& component, Advection scheme, const std::array<double, 3>& spacing, const std::vector<double>& velocity,
               const FaceFields& flux, SiteFields& sites, Gain kind, std::vector<double>& gain);

}  // namespace similitude::vans
