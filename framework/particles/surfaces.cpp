#include "particles/surfaces.h"

#include <algorithm>
#include <cmath>

namespace similitude {

namespace {

double coordinate(const Row& row, std::size_t axis) { return axis == 0 ? row.x : axis == 1 ? row.y : row.z; }

bool same_place(double a, double b, double size) { return std::fabs(a - b) <= 1e-9 * size; }

/// What is left of the intervals where `taken` is not.
std::vector<Interval> without(const std::vector<Interval>& intervals, const Interval& taken) {
  std::vector<Interval> left;
  for (const Interval& interval : intervals) {
    if (taken.low > interval.low) left.push_back({interval.low, std::min(interval.high, taken.low)});
    if (taken.high < interval.high) left.push_back({std::max(interval.low, taken.high), interval.high});
  }
  return left;
}

}  // namespace

Surfaces::Surfaces(const ModelScene& scene) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (scene.periodic[axis]) {
      period_[axis] = scene.size[axis];
      continue;
    }
    for (const Side side : {Side::low, Side::high}) {
      Surface surface = face_surface(scene, Face{static_cast<Axis>(axis), side});
      if (surface.kind != Kind::wall) {
        outlet_faces_.push_back(surface);
        has_outlets_ = true;
      }
      if (surface.kind == Kind::islands && surface.rectangles.empty()) continue;
      surfaces_.push_back(std::move(surface));
    }
  }
  for (const Baffle& baffle : scene.baffles) surfaces_.push_back(baffle_surface(scene, baffle));
}

Surfaces::Rectangle Surfaces::rectangle(const ModelScene& scene, const std::array<Interval, 3>& extent,
                                        std::size_t first, std::size_t second, double shrink) const {
  Rectangle out{};
  const std::array<std::size_t, 2> axes{first, second};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t axis = axes[side];
    const double size = scene.size[axis];
    const Interval& interval = extent[axis];
    // A side on the domain's edge goes on beyond it: the wall there, or the periodic image, closes the corner.
    out.low[side] = same_place(interval.low, 0, size) ? -k_open_end : interval.low + shrink;
    out.high[side] = same_place(interval.high, size, size) ? k_open_end : interval.high - shrink;
    if (out.low[side] > out.high[side]) out.low[side] = out.high[side] = 0.5 * (interval.low + interval.high);
  }
  return out;
}

void Surfaces::join(std::vector<Rectangle>& holes, const std::array<double, 2>& size) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<double> places;
    for (Rectangle& hole : holes) {
      for (double* side : {&hole.low[axis], &hole.high[axis]}) {
        const auto known = std::ranges::find_if(places, [&](double place) { return same_place(place, *side, size[axis]); });
        if (known != places.end()) {
          *side = *known;
        } else {
          places.push_back(*side);
        }
      }
    }
  }
}

std::vector<Surfaces::Rectangle> Surfaces::rim_of(const std::vector<Rectangle>& holes) {
  std::vector<Rectangle> rim;
  for (const Rectangle& hole : holes) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (const Side side : {Side::low, Side::high}) {
        const double at = side == Side::low ? hole.low[axis] : hole.high[axis];
        if (std::isinf(at)) continue;
        const std::size_t along = 1 - axis;
        std::vector<Interval> left{{hole.low[along], hole.high[along]}};
        for (const Rectangle& other : holes) {
          const bool goes_on = side == Side::low ? other.low[axis] < at && other.high[axis] >= at : other.high[axis] > at && other.low[axis] <= at;
          if (goes_on) left = without(left, {other.low[along], other.high[along]});
        }
        for (const Interval& part : left) {
          Rectangle segment{};
          segment.low[axis] = segment.high[axis] = at;
          segment.low[along] = part.low;
          segment.high[along] = part.high;
          rim.push_back(segment);
        }
      }
    }
  }
  return rim;
}

Surfaces::Surface Surfaces::face_surface(const ModelScene& scene, Face face) {
  Surface out{};
  out.axis = static_cast<std::size_t>(face.axis);
  out.first = (out.axis + 1) % 3;
  out.second = (out.axis + 2) % 3;
  out.position = face.side == Side::low ? 0 : scene.size[out.axis];
  out.inward = face.side == Side::low ? 1 : -1;
  out.name = "the " + face_name(face) + " wall";
  out.kind = Kind::wall;

  std::vector<Rectangle> outlets, inlets;
  bool rest_is_outlet = false;
  for (const Patch& patch : scene.patches) {
    if (!(patch.face == face)) continue;
    if (patch.rest) {
      rest_is_outlet = patch.kind == PatchKind::pressure;
    } else {
      auto& same_kind = patch.kind == PatchKind::pressure ? outlets : inlets;
      same_kind.push_back(rectangle(scene, patch.extent, out.first, out.second, 0));
    }
  }
  if (rest_is_outlet) {
    out.kind = Kind::islands;   // velocity patches are walls for particles
    out.rectangles = inlets;
  } else if (!outlets.empty()) {
    join(outlets, {scene.size[out.first], scene.size[out.second]});
    out.rim = rim_of(outlets);
    const bool whole = out.rim.empty();
    out.kind = whole ? Kind::islands : Kind::wall_with_holes;
    if (!whole) out.rectangles = outlets;
  }
  return out;
}

Surfaces::Surface Surfaces::baffle_surface(const ModelScene& scene, const Baffle& baffle) const {
  Surface out{};
  out.kind = Kind::plate;
  out.name = "baffle " + baffle.name;
  out.axis = static_cast<std::size_t>(baffle.normal);
  out.first = (out.axis + 1) % 3;
  out.second = (out.axis + 2) % 3;
  out.position = baffle.position;
  out.half_width = 0.5 * baffle.thickness;
  out.rectangles.push_back(rectangle(scene, baffle.extent, out.first, out.second, out.half_width));
  return out;
}

double Surfaces::nearest_image(std::size_t axis, double at, double low, double high) const {
  const double period = period_[axis];
  if (period == 0 || std::isinf(low) || std::isinf(high)) return at;
  const double offset = at - 0.5 * (low + high);
  return at - period * std::nearbyint(offset / period);
}

bool Surfaces::nearest(std::size_t index, const Row& centre, SurfaceTouch& out) const {
  const Surface& s = surfaces_[index];
  std::array<double, 3> to_centre{};   // [m], from the nearest point of the plane's solid part
  const double height = coordinate(centre, s.axis) - s.position;
  const double u = coordinate(centre, s.first), v = coordinate(centre, s.second);

  if (s.kind == Kind::plate) {
    const Rectangle& r = s.rectangles.front();
    const double u_near = nearest_image(s.first, u, r.low[0], r.high[0]);
    const double v_near = nearest_image(s.second, v, r.low[1], r.high[1]);
    to_centre[s.axis] = nearest_image(s.axis, coordinate(centre, s.axis), s.position, s.position) - s.position;
    to_centre[s.first] = u_near - std::clamp(u_near, r.low[0], r.high[0]);
    to_centre[s.second] = v_near - std::clamp(v_near, r.low[1], r.high[1]);
  } else {
    // Facing the solid part of a wall the distance is signed, so that nothing slips through.
    out.distance = s.inward * height;
    out.normal = {};
    out.normal[s.axis] = s.inward;
    if (s.kind == Kind::wall) return true;
    to_centre[s.axis] = height;
    if (s.kind == Kind::wall_with_holes) {
      if (!open_at(s, u, v)) return true;
      // Over a hole the nearest solid is its rim.
      double best = k_open_end;
      for (const Rectangle& side : s.rim) {
        const double du = u - std::clamp(u, side.low[0], side.high[0]), dv = v - std::clamp(v, side.low[1], side.high[1]);
        if (du * du + dv * dv >= best) continue;
        best = du * du + dv * dv;
        to_centre[s.first] = du;
        to_centre[s.second] = dv;
      }
    } else {
      double best = k_open_end;
      for (const Rectangle& r : s.rectangles) {
        const double du = u - std::clamp(u, r.low[0], r.high[0]), dv = v - std::clamp(v, r.low[1], r.high[1]);
        if (du == 0 && dv == 0) return true;
        if (du * du + dv * dv < best) {
          best = du * du + dv * dv;
          to_centre[s.first] = du;
          to_centre[s.second] = dv;
        }
      }
    }
  }
  const double distance = std::sqrt(to_centre[0] * to_centre[0] + to_centre[1] * to_centre[1] + to_centre[2] * to_centre[2]);
  for (std::size_t axis = 0; axis < 3; ++axis) out.normal[axis] = to_centre[axis] / distance;
  out.distance = distance - s.half_width;
  return true;
}

bool Surfaces::near_box(std::size_t index, const std::array<double, 3>& low, const std::array<double, 3>& high,
                        double margin) const {
  const Surface& s = surfaces_[index];
  const double reach = margin + s.half_width;
  if (s.kind != Kind::plate) {
    return (s.inward > 0 ? low[s.axis] - s.position : s.position - high[s.axis]) <= reach;
  }
  const auto beside = [&](std::size_t axis, double from, double to) {
    return period_[axis] == 0 && (low[axis] > to + reach || high[axis] < from - reach);
  };
  const Rectangle& r = s.rectangles.front();
  return !beside(s.axis, s.position, s.position) && !beside(s.first, r.low[0], r.high[0]) &&
         !beside(s.second, r.low[1], r.high[1]);
}

bool Surfaces::separates(std::size_t index, const Row& a, const Row& b) const {
  const Surface& s = surfaces_[index];
  const Rectangle& r = s.rectangles.front();
  const double height_a = coordinate(a, s.axis) - s.position, height_b = coordinate(b, s.axis) - s.position;
  if (!(height_a * height_b < 0)) return false;
  const double along = height_a / (height_a - height_b);
  const double u = coordinate(a, s.first) + along * (coordinate(b, s.first) - coordinate(a, s.first));
  const double v = coordinate(a, s.second) + along * (coordinate(b, s.second) - coordinate(a, s.second));
  return r.contains(u, v);
}

bool Surfaces::open_at(const Surface& face, double u, double v) {
  const auto inside = [&](const Rectangle& r) { return r.contains(u, v); };
  const auto reached = [&](const Rectangle& r) { return r.reaches(u, v); };
  if (face.kind == Kind::islands) return std::ranges::none_of(face.rectangles, inside);
  // A point on the seam of two holes is inside neither.
  return std::ranges::any_of(face.rectangles, reached) && std::ranges::none_of(face.rim, reached);
}

bool Surfaces::has_left(const Row& centre) const {
  for (const Surface& face : outlet_faces_) {
    const double height = face.inward * (coordinate(centre, face.axis) - face.position);
    if (height < 0 && open_at(face, coordinate(centre, face.first), coordinate(centre, face.second))) return true;
  }
  return false;
}

}  // namespace similitude
