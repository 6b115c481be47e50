#include <algorithm>
#include <cmath>
#include <numbers>

#include "particles/fill.h"

namespace similitude {

namespace {

/// [m^3], of a sphere the part below a plane.
double volume_below(const Row& sphere, double height) {
  const double r = sphere.w;
  const double depth = std::clamp(height - (sphere.z - r), 0.0, 2 * r);   // of the cap
  return std::numbers::pi * depth * depth * (r - depth / 3);
}

double largest_diameter(const ParticleStore& particles) {
  double radius = 0;
  for (const Row& p : particles.position) radius = std::max(radius, p.w);
  return 2 * radius;
}

}  // namespace

double bed_height(const ParticleStore& particles, const ModelScene& scene) {
  return bed_height(particles, scene, {0, scene.size[0]});
}

double bed_height(const ParticleStore& particles, const ModelScene& scene, const Interval& x) {
  if (particles.size() == 0) return 0;
  const double width = 3 * largest_diameter(particles);
  const auto columns = [&](double length) { return std::max(1, static_cast<int>(length / width)); };
  const int nx = columns(x.high - x.low), ny = columns(scene.size[1]);
  std::vector<double> top(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), 0.0);
  for (const Row& p : particles.position) {
    if (p.x < x.low || p.x > x.high) continue;
    const int i = std::min(nx - 1, static_cast<int>((p.x - x.low) / (x.high - x.low) * nx));
    const int j = std::clamp(static_cast<int>(p.y / scene.size[1] * ny), 0, ny - 1);
    double& highest = top[static_cast<std::size_t>(i) + static_cast<std::size_t>(nx) * static_cast<std::size_t>(j)];
    highest = std::max(highest, p.z + p.w);
  }
  double sum = 0;
  for (const double z : top) sum += z;
  return sum / static_cast<double>(top.size());
}

double solids_fraction_below(const ParticleStore& particles, const ModelScene& scene, double height) {
  if (!(height > 0)) return 0;
  double room = scene.size[0] * scene.size[1] * height;
  for (const Baffle& baffle : scene.baffles) {
    double body = baffle.thickness;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (static_cast<Axis>(axis) == baffle.normal) continue;
      const double high = axis == 2 ? std::min(height, baffle.extent[axis].high) : baffle.extent[axis].high;
      body *= std::max(0.0, high - baffle.extent[axis].low);
    }
    if (baffle.normal != Axis::z || baffle.position < height) room -= body;
  }
  double solids = 0;
  for (const Row& p : particles.position) solids += volume_below(p, height);
  return solids / room;
}

}  // namespace similitude
