#include "fluid/velocity_gradient.h"

#include <cmath>

#include "fluid/face_tables.h"

namespace similitude {
namespace {

/// [m/s], component `of` on a cell's lower (side 0) or upper (side 1) face normal to `along`.
double on_face(const Staggered& mesh, const double* velocity, std::size_t of, std::size_t along, const Triple& cell, int side,
               double time) {
  const double* const component = velocity + static_cast<Index>(of) * mesh.cell_count;
  const double here = component[mesh.cell(cell)];
  Triple at = cell, other = cell;
  at[along] += side;
  other[along] += side == 0 ? -1 : 1;
  const Index face = mesh.face(along, at);
  if (mesh.is_open(along, face)) {
    if (mesh.periodic[along]) other[along] = (other[along] + mesh.cells[along]) % mesh.cells[along];
    return 0.5 * (here + component[mesh.cell(other)]);
  }
  if (const similitude_patch* const patch = mesh.patch(along, face)) {
    return patch->kind == SIMILITUDE_PATCH_VELOCITY ? patch->velocity[of] * flow::ramp_factor(*patch, time) : here;
  }
  return mesh.kind(along, face) == SIMILITUDE_FACE_SLIP && of != along ? here : 0;
}

}  // namespace

VelocityGradient velocity_gradient(const Staggered& mesh, const double* velocity, const Triple& cell, double time) {
  VelocityGradient gradient{};
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      gradient[a][b] = (on_face(mesh, velocity, a, b, cell, 1, time) - on_face(mesh, velocity, a, b, cell, 0, time)) / mesh.spacing[b];
    }
  }
  return gradient;
}

double strain_rate(const VelocityGradient& gradient) {
  double squares = 0;   // 2 S:S
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      const double s = 0.5 * (gradient[a][b] + gradient[b][a]);
      squares += 2 * s * s;
    }
  }
  return std::sqrt(squares);
}

std::array<double, 3> vorticity(const VelocityGradient& gradient) {
  return {gradient[2][1] - gradient[1][2], gradient[0][2] - gradient[2][0], gradient[1][0] - gradient[0][1]};
}

}  // namespace similitude
