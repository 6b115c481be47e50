#pragma once
#include <similitude/restitution.h>

namespace similitude {

/// pi d^3 / 6 [m^3]
template <class V>
V sphere_volume(const V& diameter) {
  return k_pi / 6 * (diameter * diameter * diameter);
}

}  // namespace similitude
