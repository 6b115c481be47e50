#pragma once
/// Transport of momentum by the gas: div(F u) in conservative form, upwind with van Leer's limiter (J. Comput. Phys. 14
/// (1974) 361): second order where smooth, no new extremes.

#include "stencils.h"

namespace similitude::vans {

enum class Advection { tvd, upwind };

/// [m/s], the velocity carried across a face: the upwind one plus the limited half step toward the downwind one. `back` is
/// the difference behind the upwind value, `ahead` the one in front of it.
inline double limited_half_step(double back, double ahead) {
  const double product = back * ahead;
  return product > 0 ? product / (back + ahead) : 0;
}

/// transported[site] [m^2/s^2]: mean flux times the velocity it carries, for sites of one direction.
/// `flux` [m/s] is eps u on the faces of that direction.
void carry(const Component& component, std::size_t direction, Advection scheme, const std::vector<double>& velocity,
           const std::vector<double>& flux, std::vector<double>& transported);

/// gain[active face] [m/s^2] += -d(transported)/d(direction). At a pressure patch half a box gains along the axis.
void collect(const Component& component, std::size_t direction, double spacing, const std::vector<double>& transported,
             std::vector<double>& gain);

}  // namespace similitude::vans
