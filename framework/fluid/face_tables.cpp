#include "fluid/face_tables.h"

namespace similitude::flow {

FaceTable make_face_table(const Staggered& mesh, std::size_t axis) {
  FaceTable made;
  std::vector<ActiveFace> pressure_faces;
  Triple at{};
  Triple extent = mesh.face_extent[axis];
  extent[axis] = mesh.distinct_faces(axis);
  for (at[2] = 0; at[2] < extent[2]; ++at[2]) {
    for (at[1] = 0; at[1] < extent[1]; ++at[1]) {
      for (at[0] = 0; at[0] < extent[0]; ++at[0]) {
        const Row face = static_cast<Row>(mesh.face(axis, at));
        const auto [below, above] = mesh.cells_of_face(axis, at);
        const ActiveFace active{face, static_cast<Row>(below >= 0 ? below : above), static_cast<Row>(above >= 0 ? above : below)};
        if (mesh.is_open(axis, face)) {
          made.faces.push_back(active);
        } else if (mesh.patch(axis, face)) {
          const PatchFace patch{face, active.below, below >= 0 ? 1 : 0, mesh.kind(axis, face) - SIMILITUDE_FACE_PATCH};
          if (mesh.is_pressure(axis, face)) {
            made.pressure.push_back(patch);
            pressure_faces.push_back(active);
          } else {
            made.velocity.push_back(patch);
          }
        }
      }
    }
  }
  made.open_count = static_cast<Index>(made.faces.size());
  made.faces.insert(made.faces.end(), pressure_faces.begin(), pressure_faces.end());
  return made;
}

void set_inlets(const Staggered& mesh, const FaceTable& table, std::size_t axis, double time, std::vector<double>& velocity) {
  for (const PatchFace& face : table.velocity) {
    const similitude_patch& patch = mesh.grid->patches[face.patch];
    velocity[u(face.face)] = patch.velocity[axis] * ramp_factor(patch, time);
  }
}

void copy_periodic_faces(const Staggered& mesh, std::size_t axis, std::vector<double>& faces) {
  if (!mesh.periodic[axis]) return;
  const std::size_t v = (axis + 1) % 3, w = (axis + 2) % 3;
  const Index from_first_to_last = mesh.cells[axis] * mesh.face_stride(axis, axis);
  for (Index q = 0; q < mesh.cells[w]; ++q) {
    for (Index p = 0; p < mesh.cells[v]; ++p) {
      const Index first = p * mesh.face_stride(axis, v) + q * mesh.face_stride(axis, w);
      faces[u(first + from_first_to_last)] = faces[u(first)];
    }
  }
}

}  // namespace similitude::flow
