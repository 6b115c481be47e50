#pragma once
/// What walls and mirror images prescribe, at a time.

#include "stencils.h"

namespace similitude::vans {

/// Sets the slots of walls' velocities.
inline void set_walls(const Staggered& mesh, const Component& component, double time, std::vector<double>& velocity) {
  for (const WallSlot& wall : component.walls) {
    double sum = 0;
    for (const int p : wall.patch) {
      if (p >= 0) sum += mesh.grid->patches[p].velocity[component.axis] * flow::ramp_factor(mesh.grid->patches[p], time);
    }
    velocity[u(wall.slot)] = 0.5 * sum;
  }
}

/// Sets the slots of mirror images, from faces and walls.
inline void set_mirrors(const Component& component, std::vector<double>& velocity) {
  for (const MirrorSlot& mirror : component.mirrors) {
    velocity[u(mirror.slot)] = 2 * velocity[u(mirror.wall)] - velocity[u(mirror.inner)];
  }
}

/// All of them, once the faces between cells are known.
inline void set_boundaries(const Staggered& mesh, const FaceTable& table, const Component& component, double time,
                           std::vector<double>& velocity) {
  flow::set_inlets(mesh, table, component.axis, time, velocity);
  set_walls(mesh, component, time, velocity);
  set_mirrors(component, velocity);
}

}  // namespace similitude::vans
