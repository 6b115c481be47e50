#pragma once
/// Transport of momentum by the gas: div(F u) in conservative form, upwind with Koren's limiter (fluid/limiter.h).

#include "fluid/limiter.h"
#include "stencils.h"

namespace similitude::vans {

enum class Advection { tvd, upwind };

/// transported[site] [m^2/s^2]: mean flux times the velocity it carries, for sites of one direction.
/// `flux` [m/s] is eps u on the faces of that direction.
void carry(const Component& component, std::size_t direction, Advection scheme, const std::vector<double>& velocity,
           const std::vector<double>& flux, std::vector<double>& transported);

/// gain[active face] [m/s^2] += -d(transported)/d(direction). At a pressure patch half a box gains along the axis.
void collect(const Component& component, std::size_t direction, double spacing, const std::vector<double>& transported,
             std::vector<double>& gain);

}  // namespace similitude::vans
