#include "fluid/velocity_gradient.h"

#include <cmath>

#include "fluid/face_tables.h"

namespace similitude {
namespace {

/// [m/s], component `of` on a face normal to `along` that is not open, of a cell whose gas has the velocity `here`.
double on_closed_face(const Staggered& mesh, std::size_t of, std::size_t along, Index face, double here, double time) {
  if (const similitude_patch* const patch = mesh.patch(along, face)) {
    return patch->kind == SIMILITUDE_PATCH_VELOCITY ? patch->velocity[of] * flow::ramp_factor(*patch, time) : here;
  }
  return mesh.kind(along, face) == SIMILITUDE_FACE_SLIP && of != along ? here : 0;
}

}  // namespace

VelocityGradient velocity_gradient(const Staggered& mesh, const double* velocity, const Triple& cell, double time) {
  const std::array<const double*, 3> component{velocity, velocity + mesh.cell_count, velocity + 2 * mesh.cell_count};
  const Index row = mesh.cell(cell);
  const std::array<Index, 3> stride{1, mesh.cells[0], mesh.cells[0] * mesh.cells[1]};
  VelocityGradient gradient{};
  for (std::size_t b = 0; b < 3; ++b) {
    std::array<std::array<double, 3>, 2> on_face;   // [m/s], lower and upper
    const Index lower = mesh.face(b, cell);
    for (std::size_t side = 0; side < 2; ++side) {
      const Index face = side == 0 ? lower : lower + mesh.face_stride(b, b);
      if (mesh.is_open(b, face)) {
        const bool wraps = cell[b] == (side == 0 ? 0 : mesh.cells[b] - 1);
        const Index step = stride[b] * (wraps ? 1 - mesh.cells[b] : 1);
        const Index other = side == 0 ? row - step : row + step;
        for (std::size_t a = 0; a < 3; ++a) on_face[side][a] = 0.5 * (component[a][row] + component[a][other]);
      } else {
        for (std::size_t a = 0; a < 3; ++a) on_face[side][a] = on_closed_face(mesh, a, b, face, component[a][row], time);
      }
    }
    for (std::size_t a = 0; a < 3; ++a) gradient[a][b] = (on_face[1][a] - on_face[0][a]) / mesh.spacing[b];
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
