#pragma once
/// Which faces a solver with velocities on faces solves for, and what patches prescribe on the others. Worked out once
/// from the face kinds, so that a step runs over flat tables without asking what a face is.

#include <array>
#include <cstdint>
#include <vector>

#include "fluid/staggered.h"

namespace similitude::flow {

using Row = std::int32_t;

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

/// A face whose velocity is solved for: open, or on a pressure patch.
struct ActiveFace {
  Row face;
  Row below, above;   // cells; the same one twice at a pressure patch
};

struct PatchFace {
  Row face, cell;
  int side;           // 0: the cell lies above the face, 1: below
  int patch;

  /// [m/s], into the domain.
  double inward(double velocity) const { return side == 0 ? velocity : -velocity; }
};

/// The faces normal to one axis.
struct FaceTable {
  std::vector<ActiveFace> faces;               // open ones first
  Index open_count = 0;
  std::vector<PatchFace> pressure, velocity;   // `pressure` in the order of the faces from open_count on
};

FaceTable make_face_table(const Staggered& mesh, std::size_t axis);

/// [-], how far a patch's velocity has grown: linearly from rest.
inline double ramp_factor(const similitude_patch& patch, double time) {
  return time < patch.ramp ? time / patch.ramp : 1.0;
}

/// Sets the faces of velocity patches. The gas outside is pure, so that the velocity there is the superficial one.
void set_inlets(const Staggered& mesh, const FaceTable& table, std::size_t axis, double time, std::vector<double>& velocity);

}  // namespace similitude::flow
