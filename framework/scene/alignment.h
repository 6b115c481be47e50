#pragma once
/// Do lengths fall on cell faces, and what to say if they do not.

#include <string>

#include "scene/scene.h"

namespace similitude {

/// Faces on both sides of a coordinate; equal to each other if it lies on a face to a millionth of a cell.
struct Aligned {
  bool ok = false;
  double low = 0, high = 0;   // [m]
};

/// `coordinate` and `cell` in metres, faces at whole multiples of `cell`.
Aligned align(double coordinate, double cell);

/// "67.5 mm"
std::string in_mm(double length);

/// "67.5 mm is not on a cell face (cells of 5 mm, faces at 65 mm and 70 mm)."
std::string off_face_text(double coordinate, double cell);

/// "Use [65 mm, 80 mm] or [70 mm, 80 mm], or set scene.domain.cell: 2.5 mm." The last part only if a whole fraction of the
/// cell, not below `least` [m], fits both ends: cells smaller than the particles in them are no advice.
std::string off_face_fix(Interval wanted, double cell, double least = 0);
/// The same for one coordinate: "Use 65 mm or 70 mm, or set scene.domain.cell: 2.5 mm."
std::string off_face_fix(double wanted, double cell, double least = 0);

}  // namespace similitude
