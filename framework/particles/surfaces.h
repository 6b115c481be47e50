#pragma once
/// What stands still: the walls of the domain with their outlets, and the baffles. Answers "how far is the nearest point,
/// and which way", as one smooth contact per surface.

#include <array>
#include <limits>
#include <vector>

#include "particles/store.h"
#include "scene/scene.h"

namespace similitude {

/// The nearest point of a surface, seen from a particle's centre.
struct SurfaceTouch {
  double distance = 0;             // [m], centre to surface
  std::array<double, 3> normal{};  // [-], from the surface toward the centre
};

class Surfaces {
 public:
  explicit Surfaces(const ModelScene& scene);

  std::size_t count() const { return surfaces_.size(); }
  /// False where the surface has no point that could touch (the middle of an opening).
  bool nearest(std::size_t surface, const Row& centre, SurfaceTouch& out) const;
  /// May any point within `margin` [m] of the box [low, high] feel the surface? Never false wrongly.
  bool near_box(std::size_t surface, const std::array<double, 3>& low, const std::array<double, 3>& high,
                double margin) const;
  bool is_baffle(std::size_t surface) const { return surfaces_[surface].kind == Kind::plate; }
  /// Does the straight line between two points pass through the baffle's mid-plane?
  bool separates(std::size_t surface, const Row& a, const Row& b) const;

  /// Has this centre left the domain through an outlet?
  bool has_left(const Row& centre) const;
  bool has_outlets() const { return has_outlets_; }
  /// "the bottom wall", "baffle plates.left", for messages.
  const std::string& name(std::size_t surface) const { return surfaces_[surface].name; }

 private:
  static constexpr double k_open_end = std::numeric_limits<double>::infinity();
  enum class Kind {
    wall,             // a whole face
    wall_with_holes,  // a face but for rectangles
    islands,          // rectangles of a face, the rest is open
    plate             // a baffle
  };
  struct Rectangle {
    std::array<double, 2> low, high;  // [m], along the surface's first and second axis; infinite where a side goes on
    bool contains(double u, double v) const { return u > low[0] && u < high[0] && v > low[1] && v < high[1]; }
    bool reaches(double u, double v) const { return u >= low[0] && u <= high[0] && v >= low[1] && v <= high[1]; }
  };
  struct Surface {
    Kind kind;
    std::string name;
    std::size_t axis, first, second;
    double position;     // [m], of the plane
    double inward;       // +1 on a low face, -1 on a high face, 0 for a baffle
    double half_width;   // [m], of a baffle: what its rounded edges add to the rectangle
    std::vector<Rectangle> rectangles;
    std::vector<Rectangle> rim;   // of holes: their sides where no other hole goes on, each without width
  };

  Surface face_surface(const ModelScene& scene, Face face);
  Surface baffle_surface(const ModelScene& scene, const Baffle& baffle) const;
  Rectangle rectangle(const ModelScene& scene, const std::array<Interval, 3>& extent, std::size_t first,
                      std::size_t second, double shrink) const;
  /// Moves a coordinate to the image nearest to the interval's middle.
  double nearest_image(std::size_t axis, double coordinate, double low, double high) const;
  /// Gives sides that differ by rounding alone one place.
  static void join(std::vector<Rectangle>& holes, const std::array<double, 2>& size);
  /// Sides inside the plane of what the holes are together.
  static std::vector<Rectangle> rim_of(const std::vector<Rectangle>& holes);
  static bool open_at(const Surface& face, double u, double v);

  std::array<double, 3> period_{};  // [m], 0 where not periodic
  std::vector<Surface> surfaces_;
  std::vector<Surface> outlet_faces_;
  bool has_outlets_ = false;
};

}  // namespace similitude
