// A close-packed packing of spheres, sheared by gravity that tilts. Each sphere lies in the pocket of three; layers stay where they are
// until gravity leaves the cone of the three normals. That is a tetrahedron's geometry and knows no stiffness, damping or mass: towards
// the saddle between two of the three tan(theta) = 1/sqrt(8), 19.47 deg; over the top of one of them tan(theta) = 1/sqrt(2), 35.26 deg.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "record.h"
#include "spheres.h"

namespace similitude::test {
namespace {

constexpr Sphere k_sphere{0.5e-3, 2000};
constexpr double k_diameter = 2 * k_sphere.radius, k_gravity = 9.81;   // [m], [m/s^2]
constexpr int k_per_row = 4;
constexpr double k_degree = k_pi / 180;   // [rad]

enum class Towards { saddle, top };

struct Packing {
  const char* law;
  Values values;
  int layers;       // that may move
  int in_layer;     // spheres of each: all places, or one alone in its pocket
  Towards towards;
  double limit() const { return std::atan(towards == Towards::saddle ? 1 / std::sqrt(8.0) : 1 / std::sqrt(2.0)); }   // [rad]
};

/// Whether a packing on a layer that does not move stays where it is when gravity tilts by `angle` [rad].
bool holds(const Packing& packing, double angle) {
  const double row = k_diameter * std::sqrt(3.0) / 2, height = k_diameter * std::sqrt(2.0 / 3);
  const ContactModel law = make_law(packing.law, packing.values);
  ModelScene scene;
  scene.size = {k_per_row * k_diameter, k_per_row * row, 10 * k_diameter};
  scene.periodic = {true, true, false};
  ParticleStore store({.rotation = true, .coupling = true});
  const auto add = [&](double x, double y, double z, double mass) {
    const std::size_t at = store.add(store.size(), 0, std::fmod(x, scene.size[0]), std::fmod(y, scene.size[1]), z, k_sphere.radius, mass);
    store.angular_velocity[at].w = 0.4 * mass * k_sphere.radius * k_sphere.radius;
  };
  constexpr double k_immovable = 1e12;   // [-], masses of the lowest layer, which nothing pulls
  for (int layer = 0; layer <= packing.layers; ++layer) {
    const double dx = layer * k_diameter / 2, dy = layer * row / 3, z = 3 * k_diameter + layer * height;
    for (int j = 0, n = 0; j < k_per_row; ++j) {
      for (int i = 0; i < k_per_row; ++i, ++n) {
        if (layer > 0 && n >= packing.in_layer) continue;
        add(k_diameter * (i + 0.5 * (j % 2) + 0.25) + dx, row * (j + 0.25) + dy, z, k_sphere.mass() * (layer == 0 ? k_immovable : 1));
      }
    }
  }
  const Column<Row> start = store.position;
  EngineOptions options;
  options.dt = law.functions().contact_time(law.instance(), 0, k_sphere.mass() / 2, k_sphere.radius / 2, 1e-3) / 25;
  Engine engine(store, scene, law, options);
  // Weight comes gradually: a packing that is dropped into its pockets bounces, and a bounce of 1e-5 diameters lifts it over the last
  // half degree. What moves then has time to fall by its diameter a hundred times.
  constexpr int k_parts = 1000, k_rising = 300;
  const double time = 20 * std::sqrt(k_diameter / k_gravity), side = packing.towards == Towards::saddle ? -1 : 1;   // [s], [-]
  for (int part = 1; part <= k_parts; ++part) {
    const double pull = k_sphere.mass() * k_gravity * std::min(1.0, static_cast<double>(part) / k_rising);   // [N]
    for (std::size_t at = 0; at < store.size(); ++at) {
      if (store.velocity[at].w < 2 * k_sphere.mass()) store.stress_force[at] = {0, side * pull * std::sin(angle), -pull * std::cos(angle), 0};
    }
    engine.advance(std::max<std::int64_t>(1, std::llround(time / k_parts / options.dt)));
    for (std::size_t at = 0; at < store.size(); ++at) {
      if (std::abs(store.position[at].z - start[store.id[at]].z) > 0.1 * k_diameter) return false;
    }
  }
  return true;
}

/// [rad], by halving an interval of two degrees around the limit.
double steepest(const Packing& packing) {
  double low = packing.limit() - k_degree, high = packing.limit() + k_degree;
  if (!holds(packing, low)) return low;
  if (holds(packing, high)) return high;
  while (high - low > 0.02 * k_degree) {
    const double middle = (low + high) / 2;
    (holds(packing, middle) ? low : high) = middle;
  }
  return (low + high) / 2;
}

void compare(const char* feature, const std::vector<Packing>& packings) {
  Worst worst;   // [deg]
  for (const Packing& packing : packings) {
    const double ours = steepest(packing) / k_degree, exact = packing.limit() / k_degree;
    std::printf("  %s: %.3f deg, geometry says %.3f deg\n", feature, ours, exact);
    EXPECT_NEAR(ours, exact, 0.05);   // [deg], of a tetrahedron pressed in by 1e-4 of a diameter, and the search's last interval
    worst.see(ours - exact);
  }
  record({feature, fmt::format("a tetrahedron's geometry, {:.2f} deg", packings.front().limit() / k_degree),
          fmt::format("{:.2g} deg, half the search's last interval", worst.value), ""});
}

const Values k_smooth{{"stiffness", 500}, {"restitution", 0.3}, {"friction", 0}};
const Values k_rough{{"stiffness", 500}, {"restitution", 0.3}, {"friction", 0.5}};
const Values k_rough_hertz{{"youngs_modulus", 5e7}, {"poisson_ratio", 0.25}, {"restitution", 0.3}, {"friction", 0.5}};

}  // namespace

TEST(ShearedPacking, OfSmoothSpheresYieldsTowardsTheSaddles) {
  compare("yield of a close packing, three layers, towards the saddles", {{LINEAR_SPRING, k_smooth, 3, k_per_row * k_per_row, Towards::saddle}});
}

TEST(ShearedPacking, OfSmoothSpheresYieldsOverTheTops) {
  compare("yield of a close packing, three layers, over the tops", {{LINEAR_SPRING, k_smooth, 3, k_per_row * k_per_row, Towards::top}});
}

// A single sphere rolls out of its pocket over the two contacts that are left: friction does not hold it below 1.93, where the line
// from the third contact to those two would lie within the cone of friction.
TEST(ShearedPacking, ARoughSphereRollsOutOfItsPocketAtTheSameAngle) {
  compare("a rough sphere leaves its pocket, linear spring and Hertz-Mindlin",
          {{LINEAR_SPRING, k_rough, 1, 1, Towards::saddle}, {HERTZ_MINDLIN, k_rough_hertz, 1, 1, Towards::saddle}});
}

}  // namespace similitude::test
