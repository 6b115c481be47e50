#include "particles/lattice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <similitude/sphere.h>

#include "particles/surfaces.h"

namespace similitude {

namespace {

constexpr double k_lattice_clearance = 0.02;   // [-], of the diameter, between neighbours of the lattice
constexpr double k_crowded_fraction = 0.56;    // [-], of the start: denser, and arches stay wound up between the walls
constexpr double k_crowded_jitter = 0.15;      // [-], of the distance between neighbours
constexpr double k_loose_at_wall = 0.25;       // [-], of a diameter: what a wall's looser packing costs, so that levels agree

std::uint64_t mixed_bits(std::uint64_t x) {   // splitmix64, Steele, Lea & Flood (2014), OOPSLA 453
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

ModelScene without_openings(const ModelScene& scene) {
  ModelScene closed = scene;
  closed.patches.clear();
  return closed;
}

/// Stretches of a line along x that the plates standing across it leave free, less a margin on either side of every plate and
/// wall.
class FreeLine {
 public:
  FreeLine(const ModelScene& scene, double y, double z, double margin) : room_(scene.size[0]), length_(room_) {
    if (!scene.periodic[0]) {
      block({0, 0}, margin);
      length_ -= margin;
    }
    for (const Baffle& baffle : scene.baffles) {
      if (baffle.normal != Axis::x) continue;
      if (y < baffle.extent[1].low || y > baffle.extent[1].high || z < baffle.extent[2].low || z > baffle.extent[2].high) continue;
      block({baffle.position - baffle.thickness / 2, baffle.position + baffle.thickness / 2}, margin);
      room_ -= baffle.thickness;
    }
    std::sort(blocked_.begin(), blocked_.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
  }
  double room() const { return room_; }       // [m], between the plates
  double length() const { return length_; }   // [m], less the margins too
  /// The x of a point `along` [m] the free stretches, one after the other.
  double x(double along) const {
    for (const Interval& plate : blocked_) {
      if (along < plate.low) break;
      along += plate.high - plate.low;
    }
    return along;
  }

 private:
  void block(const Interval& body, double margin) {
    blocked_.push_back({std::max(0.0, body.low - margin), body.high + margin});
    length_ -= body.high + margin - blocked_.back().low;
  }

  double room_, length_;
  std::vector<Interval> blocked_;
};

/// Out of every surface it touches. Where two surfaces push against each other the last has its way.
void clear_of_surfaces(const Surfaces& surfaces, double radius, std::array<double, 3>& at) {
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t s = 0; s < surfaces.count(); ++s) {
      SurfaceTouch touch;
      if (!surfaces.nearest(s, {at[0], at[1], at[2], radius}, touch) || touch.distance >= radius) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += (radius - touch.distance) * touch.normal[axis];
    }
  }
}

}  // namespace

double counter_random(std::uint64_t seed, std::uint64_t counter, std::uint64_t draw) {
  const std::uint64_t bits = mixed_bits(mixed_bits(mixed_bits(seed) ^ counter) ^ draw);
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

std::vector<std::uint32_t> mixed_classes(const std::vector<std::int64_t>& counts, std::uint64_t seed) {
  std::vector<std::uint32_t> classes;
  for (std::size_t c = 0; c < counts.size(); ++c) {
    classes.insert(classes.end(), static_cast<std::size_t>(counts[c]), static_cast<std::uint32_t>(c));
  }
  if (counts.size() < 2) return classes;
  for (std::size_t n = classes.size(); n > 1; --n) {   // Fisher-Yates
    const auto other = static_cast<std::size_t>(counter_random(seed, n, 0) * static_cast<double>(n));
    std::swap(classes[n - 1], classes[other]);
  }
  return classes;
}

Places lattice_places(const ModelScene& scene, const std::vector<std::uint32_t>& classes) {
  double largest = 0;
  for (const std::uint32_t c : classes) largest = std::max(largest, scene.particles[c].diameter);
  const Surfaces surfaces(without_openings(scene));
  const double spacing = (1 + k_lattice_clearance) * largest, margin = spacing / 2;
  const double row = spacing * std::sqrt(3.0) / 2, layer = spacing * std::sqrt(2.0 / 3);
  const auto fits = [&](const std::array<double, 3>& at) {
    for (std::size_t s = 0; s < surfaces.count(); ++s) {
      SurfaceTouch touch;
      if (surfaces.nearest(s, {at[0], at[1], at[2], margin}, touch) && touch.distance < largest / 2) return false;
    }
    return true;
  };
  // A periodic direction must not see its first row again at less than a spacing.
  std::array<double, 3> limit;
  for (std::size_t axis = 0; axis < 3; ++axis) limit[axis] = scene.size[axis] - margin;

  Places places;
  for (int k = 0; margin + k * layer <= limit[2]; ++k) {
    for (int j = 0; margin + (j + (k % 2) / 3.0) * row <= limit[1]; ++j) {
      for (int i = 0; margin + (i + ((j + k) % 2) / 2.0) * spacing <= limit[0]; ++i) {
        if (places.size() == classes.size()) return places;
        const std::array<double, 3> at{margin + (i + ((j + k) % 2) / 2.0) * spacing, margin + (j + (k % 2) / 3.0) * row,
                                       margin + k * layer};
        if (fits(at)) places.push_back(at);
      }
    }
  }
  return places;
}

Places crowded_places(const ModelScene& scene, const std::vector<std::uint32_t>& classes) {
  double volume = 0;   // [m^3]
  for (const std::uint32_t c : classes) volume += sphere_volume(scene.particles[c].diameter);
  const double each = volume / static_cast<double>(classes.size()) / k_crowded_fraction;   // [m^3], room per particle
  const double spacing = std::cbrt(each);
  const int rows = std::max(1, static_cast<int>(std::lround(scene.size[1] / spacing)));
  const double row = scene.size[1] / rows;
  const double along = each / (row * spacing);   // [m], between neighbours of a row
  ModelScene tall = without_openings(scene);   // whoever asks finds out how high the bed would be
  tall.size[2] += 4 * static_cast<double>(classes.size()) * each / (scene.size[0] * scene.size[1]);
  const Surfaces surfaces(tall);
  const double margin = k_loose_at_wall * std::cbrt(each * k_crowded_fraction * 6 / std::numbers::pi);   // [m]

  Places places;
  places.reserve(classes.size());
  for (std::uint64_t layer = 0; places.size() < classes.size(); ++layer) {
    const double z = (static_cast<double>(layer) + 0.5) * spacing;
    Places of_layer;
    for (int j = 0; j < rows; ++j) {
      const double y = (j + 0.5) * row;
      const FreeLine line(scene, y, z, margin);
      const double step = along * line.length() / line.room();
      const double phase = counter_random(scene.bed.seed, layer * static_cast<std::uint64_t>(rows) + static_cast<std::uint64_t>(j), 1);
      for (double x = phase * step; x < line.length(); x += step) of_layer.push_back({line.x(x), y, z});
    }
    // The last layer is thinned evenly.
    const std::size_t wanted = std::min(of_layer.size(), classes.size() - places.size());
    for (std::size_t n = 0; n < wanted; ++n) places.push_back(of_layer[n * of_layer.size() / wanted]);
  }
  for (std::size_t id = 0; id < places.size(); ++id) {
    const double radius = scene.particles[classes[id]].diameter / 2;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double jitter = 2 * counter_random(scene.bed.seed, id, 2 + axis) - 1;
      places[id][axis] += k_crowded_jitter * spacing * jitter;
      if (!scene.periodic[axis]) {
        const double highest = axis == 2 ? HUGE_VAL : scene.size[axis] - radius;
        places[id][axis] = std::min(std::max(places[id][axis], radius), highest);
      }
    }
    clear_of_surfaces(surfaces, radius, places[id]);
  }
  return places;
}

}  // namespace similitude
