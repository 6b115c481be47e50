#pragma once
/// What patches and walls prescribe, at a time.

#include "stencils.h"

namespace similitude::vans {

/// [-], how far a patch's velocity has grown: linearly from rest.
inline double ramp_factor(const similitude_patch& patch, double time) {
  return time < patch.ramp ? time / patch.ramp : 1.0;
}

/// Sets the faces of velocity patches. The gas outside is pure, so that the velocity there is the superficial one.
inline void set_inlets(const Staggered& mesh, const Component& component, double time, std::vector<double>& velocity) {
  for (const PatchFace& face : component.velocity) {
    const similitude_patch& patch = mesh.grid->patches[face.patch];
    velocity[u(face.face)] = patch.velocity[component.axis] * ramp_factor(patch, time);
  }
}

/// Sets the slots of walls' velocities.
inline void set_walls(const Staggered& mesh, const Component& component, double time, std::vector<double>& velocity) {
  for (const WallSlot& wall : component.walls) {
    double sum = 0;
    for (const int p : wall.patch) {
      if (p >= 0) sum += mesh.grid->patches[p].velocity[component.axis] * ramp_factor(mesh.grid->patches[p], time);
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
inline void set_boundaries(const Staggered& mesh, const Component& component, double time, std::vector<double>& velocity) {
  set_inlets(mesh, component, time, velocity);
  set_walls(mesh, component, time, velocity);
  set_mirrors(component, velocity);
}

}  // namespace similitude::vans
