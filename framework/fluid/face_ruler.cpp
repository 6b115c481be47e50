#include "fluid/face_ruler.h"

#include <algorithm>
#include <cmath>

#include "scene/alignment.h"
#include "scene/messages.h"

namespace similitude {

namespace {

std::size_t at(int axis) { return static_cast<std::size_t>(axis); }

std::string interval_in_mm(Interval interval) { return "[" + in_mm(interval.low) + ", " + in_mm(interval.high) + "]"; }

int face_number(double position, double cell) { return static_cast<int>(std::lround(position / cell)); }

}  // namespace

FaceRuler::FaceRuler(const std::array<double, 3>& size, const std::array<double, 3>& cell, double diameter)
    : size_(size), cell_(cell), diameter_(diameter), cells_{} {
  for (int axis = 0; axis < 3; ++axis) {
    const double length = size_[at(axis)], spacing = cell_[at(axis)];
    const Aligned end = align(length, spacing);
    if (!end.ok || face_number(length, spacing) < 1) {
      throw InputError(SourceMark{}, "scene.domain.size",
                       in_mm(length) + " in " + "xyz"[axis] + " is not a whole number of cells of " + in_mm(spacing) + ".",
                       "Use " + (end.low > 0 ? in_mm(end.low) + " or " : "") + in_mm(end.ok ? spacing : end.high) +
                           ", or another scene.domain.cell.");
    }
    cells_[at(axis)] = face_number(length, spacing);
  }
}

CellRange FaceRuler::range(int axis, Interval interval, const SourceMark& mark, const std::string& path,
                           const std::string& owner) const {
  const double length = size_[at(axis)], cell = cell_[at(axis)];
  if (!(interval.low < interval.high)) {
    throw InputError(mark, path, interval_in_mm(interval) + " is empty.", "Write the smaller value first.");
  }
  const Aligned low = align(interval.low, cell), high = align(interval.high, cell);
  if (low.high < 0 || low.low < 0 || face_number(high.high, cell) > cells(axis)) {
    const Interval inside{std::max(interval.low, 0.0), std::min(interval.high, length)};
    throw InputError(mark, path, interval_in_mm(interval) + " sticks out of " + owner + " (0 mm to " + in_mm(length) + ").",
                     inside.low < inside.high ? "Use " + interval_in_mm(inside) + "." : "Move it inside.");
  }
  if (!low.ok || !high.ok) {
    throw InputError(mark, path, off_face_text(low.ok ? interval.high : interval.low, cell), off_face_fix(interval, cell, diameter_));
  }
  return {face_number(interval.low, cell), face_number(interval.high, cell)};
}

int FaceRuler::interior_face(int axis, double position, const SourceMark& mark, const std::string& path) const {
  const double length = size_[at(axis)], cell = cell_[at(axis)];
  const Aligned near = align(position, cell);
  if (face_number(near.high, cell) < 1 || face_number(near.low, cell) >= cells(axis)) {
    throw InputError(mark, path, in_mm(position) + " is not inside the domain (0 mm to " + in_mm(length) + ").",
                     "Move it inside: the sides of the domain are walls already.");
  }
  if (!near.ok) throw InputError(mark, path, off_face_text(position, cell), off_face_fix(position, cell, diameter_));
  return face_number(position, cell);
}

}  // namespace similitude
