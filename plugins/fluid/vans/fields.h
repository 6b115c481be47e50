#pragma once
/// Face and cell fields of the solver.

#include <array>
#include <cstdint>
#include <vector>

#include "fluid/staggered.h"

namespace similitude::vans {

/// A value per face and axis, in the grid's layout.
using FaceFields = std::array<std::vector<double>, 3>;

inline std::size_t u(Index row) { return static_cast<std::size_t>(row); }

inline FaceFields make_face_fields(const Staggered& mesh) {
  FaceFields made;
  for (std::size_t a = 0; a < 3; ++a) made[a].assign(u(mesh.face_count[a]), 0.0);
  return made;
}

/// The last face of a periodic direction is the first: copies its value.
void copy_periodic_faces(const Staggered& mesh, std::size_t axis, std::vector<double>& faces);

}  // namespace similitude::vans
