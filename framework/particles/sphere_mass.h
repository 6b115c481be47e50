#pragma once
#include <numbers>

namespace similitude {

/// [kg], of a particle as it is put into the store. Its last bits are in every bed that was ever hashed: the order of the
/// factors stays.
inline double sphere_mass(double density, double diameter) {
  return density * std::numbers::pi / 6 * (diameter * diameter * diameter);
}

}  // namespace similitude
