#pragma once
/// The state of a bed, bit by bit and by particle id.

#include <array>
#include <bit>
#include <cstdint>
#include <map>

#include "particles/store.h"

namespace similitude::testing {

using Bits = std::map<std::uint64_t, std::array<std::uint64_t, 9>>;

inline Bits bits_of(const ParticleStore& store) {
  Bits out;
  for (std::size_t row = 0; row < store.size(); ++row) {
    const Row &x = store.position[row], &v = store.velocity[row], &w = store.angular_velocity[row];
    std::array<std::uint64_t, 9> all{};
    const std::array<double, 9> numbers{x.x, x.y, x.z, v.x, v.y, v.z, w.x, w.y, w.z};
    for (std::size_t n = 0; n < 9; ++n) all[n] = std::bit_cast<std::uint64_t>(numbers[n]);
    out[store.id[row]] = all;
  }
  return out;
}

}  // namespace similitude::testing
