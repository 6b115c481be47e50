#pragma once
/// What gas and effects see of a row of the particle store: one of the physical particles that it stands for.

#include <cstddef>

#include "particles/store.h"
#include "scene/scene.h"

namespace similitude {

/// [m], its class's drag diameter; a particle that is larger or smaller than its class scales with it.
inline double drag_diameter(const ParticleClass& type, const ParticleStore& particles, std::size_t row) {
  return type.drag_diameter * (2 * particles.position[row].w / type.diameter);
}

/// [kg], of one; it may have a density of its own.
inline double physical_mass(const ParticleClass& type, const ParticleStore& particles, std::size_t row) {
  return particles.velocity[row].w / type.weight;
}

}  // namespace similitude
