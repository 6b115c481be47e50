#include "fluid/grid.h"

#include "fluid/face_ruler.h"
#include "scene/messages.h"

namespace similitude {

namespace {

constexpr std::size_t k_most_patches = 255 - SIMILITUDE_FACE_PATCH;  // a face kind is one byte

/// Box of faces of one axis, half open: every index triple in it is a face of that axis.
struct FaceBox {
  int axis;
  std::array<int, 3> low, high;
};

template <class Visit>
void for_each_face(const FaceBox& box, Visit&& visit) {
  for (int k = box.low[2]; k < box.high[2]; ++k) {
    for (int j = box.low[1]; j < box.high[1]; ++j) {
      for (int i = box.low[0]; i < box.high[0]; ++i) visit(i, j, k);
    }
  }
}

std::string axis_name(int axis) { return std::string(1, "xyz"[axis]); }

FaceBox whole_side(const FaceRuler& ruler, int axis, int face) {
  FaceBox box{axis, {}, {ruler.cells(0), ruler.cells(1), ruler.cells(2)}};
  box.low[static_cast<std::size_t>(axis)] = face;
  box.high[static_cast<std::size_t>(axis)] = face + 1;
  return box;
}

FaceBox patch_faces(const FaceRuler& ruler, const Patch& patch) {
  const int axis = static_cast<int>(patch.face.axis);
  FaceBox box = whole_side(ruler, axis, patch.face.side == Side::low ? 0 : ruler.cells(axis));
  if (patch.rest) return box;
  for (int across = 0; across < 3; ++across) {
    if (across == axis) continue;
    const std::size_t c = static_cast<std::size_t>(across);
    const CellRange range =
        ruler.range(across, patch.extent[c], patch.mark, "scene.patches." + patch.name + "." + axis_name(across),
                    "the " + face_name(patch.face) + " face");
    box.low[c] = range.low;
    box.high[c] = range.high;
  }
  return box;
}

FaceBox baffle_faces(const FaceRuler& ruler, const Baffle& baffle) {
  const int axis = static_cast<int>(baffle.normal);
  const std::string path = "scene.baffles." + baffle.name;
  FaceBox box =
      whole_side(ruler, axis, ruler.interior_face(axis, baffle.position, baffle.mark, path + ".at_" + axis_name(axis)));
  for (int across = 0; across < 3; ++across) {
    if (across == axis) continue;
    const std::size_t c = static_cast<std::size_t>(across);
    const CellRange range =
        ruler.range(across, baffle.extent[c], baffle.mark, path + "." + axis_name(across), "the domain");
    box.low[c] = range.low;
    box.high[c] = range.high;
  }
  return box;
}

similitude_patch patch_row(const Patch& patch, const std::string& name) {
  similitude_patch row{};
  row.struct_size = sizeof(similitude_patch);
  row.kind = patch.kind == PatchKind::velocity ? SIMILITUDE_PATCH_VELOCITY : SIMILITUDE_PATCH_PRESSURE;
  row.name = name.c_str();
  row.velocity[static_cast<int>(patch.face.axis)] = patch.face.side == Side::low ? patch.velocity : -patch.velocity;
  row.pressure = patch.pressure;
  row.ramp = patch.ramp;
  return row;
}

[[noreturn]] void throw_overlap(const Patch& patch, const Patch& other) {
  const std::string face = face_name(patch.face);
  if (patch.rest && other.rest) {
    throw InputError(patch.mark, "scene.patches." + patch.name,
                     "both it and " + other.name + " take the rest of the " + face + " face.",
                     "Give one of them an extent.");
  }
  throw InputError(patch.mark, "scene.patches." + patch.name, "overlaps " + other.name + " on the " + face + " face.",
                   "Shrink one of them, or let one take what is left: rest: true.");
}

}  // namespace

template <class Bed>
Grid::Grid(const Scene<Bed>& scene) {
  const FaceRuler ruler(scene.size, scene.cell, largest_diameter(scene));
  table_.struct_size = sizeof(similitude_grid);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t a = static_cast<std::size_t>(axis);
    table_.cells[axis] = ruler.cells(axis);
    table_.periodic[axis] = scene.periodic[a] ? 1 : 0;
    table_.spacing[axis] = scene.size[a] / ruler.cells(axis);
    table_.gravity[axis] = scene.gravity[a];
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t a = static_cast<std::size_t>(axis);
    faces_[a].assign(cell_count() / static_cast<std::size_t>(cells(axis)) * static_cast<std::size_t>(cells(axis) + 1),
                     SIMILITUDE_FACE_OPEN);
    if (periodic(axis)) continue;
    for (const Side side : {Side::low, Side::high}) {
      const bool slip = scene.walls[a][static_cast<std::size_t>(side)] == WallKind::slip;
      for_each_face(whole_side(ruler, axis, side == Side::low ? 0 : cells(axis)), [&](int i, int j, int k) {
        faces_[a][face(axis, i, j, k)] = slip ? SIMILITUDE_FACE_SLIP : SIMILITUDE_FACE_NO_SLIP;
      });
    }
  }

  if (scene.patches.size() > k_most_patches) {
    throw InputError(scene.patches[k_most_patches].mark, "scene.patches",
                     "there are " + std::to_string(scene.patches.size()) + " patches, at most " +
                         std::to_string(k_most_patches) + " are possible.",
                     "Merge patches of equal velocity.");
  }
  patch_names_.reserve(scene.patches.size());
  for (const Patch& patch : scene.patches) {
    patch_names_.push_back(patch.name);
    patches_.push_back(patch_row(patch, patch_names_.back()));
    if (scene.periodic[static_cast<std::size_t>(patch.face.axis)]) {
      throw InputError(patch.mark, "scene.patches." + patch.name,
                       "the " + face_name(patch.face) + " face is periodic and cannot carry a patch.",
                       "Remove the patch, or the direction from scene.periodic.");
    }
  }
  for (const bool rest : {false, true}) {  // patches with an extent first, then those that take what is left
    for (std::size_t p = 0; p < scene.patches.size(); ++p) {
      const Patch& patch = scene.patches[p];
      if (patch.rest != rest) continue;
      const FaceBox box = patch_faces(ruler, patch);
      std::vector<std::uint8_t>& kinds = faces_[static_cast<std::size_t>(box.axis)];
      bool covers = false;
      for_each_face(box, [&](int i, int j, int k) {
        std::uint8_t& kind = kinds[face(box.axis, i, j, k)];
        if (kind >= SIMILITUDE_FACE_PATCH) {
          const Patch& other = scene.patches[kind - SIMILITUDE_FACE_PATCH];
          if (!rest || other.rest) throw_overlap(patch, other);
          return;
        }
        kind = static_cast<std::uint8_t>(SIMILITUDE_FACE_PATCH + p);
        covers = true;
      });
      if (!covers) {
        throw InputError(patch.mark, "scene.patches." + patch.name,
                         "nothing is left of the " + face_name(patch.face) + " face for it.", "Remove it, or shrink the others.");
      }
    }
  }
  for (const Baffle& baffle : scene.baffles) {
    const FaceBox box = baffle_faces(ruler, baffle);
    for_each_face(box, [&](int i, int j, int k) {
      faces_[static_cast<std::size_t>(box.axis)][face(box.axis, i, j, k)] = SIMILITUDE_FACE_NO_SLIP;
    });
  }

  for (int axis = 0; axis < 3; ++axis) table_.face_kind[axis] = faces_[static_cast<std::size_t>(axis)].data();
  table_.patch_count = static_cast<std::uint32_t>(patches_.size());
  table_.patches = patches_.data();
}

template Grid::Grid(const Scene<RealBed>&);
template Grid::Grid(const Scene<ModelBed>&);

}  // namespace similitude
