// The engine's forces against a sum over all pairs, images, walls and baffles, written without lists.

#include <gtest/gtest.h>

#include "beds.h"

namespace similitude {
namespace {
using namespace testing;

struct Loads {
  std::array<double, 3> force{}, torque{};
};

using Point = std::array<double, 3>;

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class AllPairs {
 public:
  AllPairs(const ParticleStore& store, const ModelScene& scene, const SpringLaw& law, double dt)
      : store_(store), scene_(scene), law_(law), dt_(dt), loads_(store.size()) {
    for (std::size_t i = 0; i < store.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) pair(i, j);
      walls(i);
      for (const Baffle& baffle : scene.baffles) plate(i, baffle);
    }
  }
  const Loads& of(std::size_t row) const { return loads_[row]; }
  std::size_t contacts() const { return contacts_; }

 private:
  Point at(std::size_t row) const { return {store_.position[row].x, store_.position[row].y, store_.position[row].z}; }
  Point speed(std::size_t row) const { return {store_.velocity[row].x, store_.velocity[row].y, store_.velocity[row].z}; }
  Point spin(std::size_t row) const {
    if (!law_.rotation) return {};
    const Row& w = store_.angular_velocity[row];
    return {w.x, w.y, w.z};
  }

  void pair(std::size_t i, std::size_t j) {
    for (int image = 0; image < 27; ++image) {
      const std::array<int, 3> turn{image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1};
      Point d = at(i);
      bool used = true;
      for (std::size_t a = 0; a < 3; ++a) {
        used = used && (turn[a] == 0 || scene_.periodic[a]);
        d[a] -= at(j)[a] + turn[a] * scene_.size[a];
      }
      const double distance = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      const double ri = store_.position[i].w, rj = store_.position[j].w;
      if (!used || ri + rj - distance <= -law_.reach) continue;
      const Point n{d[0] / distance, d[1] / distance, d[2] / distance};
      const double li = distance * ri / (ri + rj), lj = distance * rj / (ri + rj);
      const double mi = store_.velocity[i].w, mj = store_.velocity[j].w;
      const Point vi = speed(i), vj = speed(j), wi = cross(spin(i), n), wj = cross(spin(j), n);
      Point v;
      for (std::size_t a = 0; a < 3; ++a) v[a] = vi[a] - vj[a] - li * wi[a] - lj * wj[a];
      const Point f = push(n, ri + rj - distance, v, mi * mj / (mi + mj));
      const Point moment = cross(n, f);
      for (std::size_t a = 0; a < 3; ++a) {
        loads_[i].force[a] += f[a];
        loads_[j].force[a] -= f[a];
        loads_[i].torque[a] -= li * moment[a];
        loads_[j].torque[a] -= lj * moment[a];
      }
    }
  }

  void surface(std::size_t i, const Point& n, double distance) {
    const double r = store_.position[i].w;
    if (r - distance <= -law_.reach) return;
    const Point vi = speed(i), wi = cross(spin(i), n);
    Point v;
    for (std::size_t a = 0; a < 3; ++a) v[a] = vi[a] - distance * wi[a];
    const Point f = push(n, r - distance, v, store_.velocity[i].w);
    const Point moment = cross(n, f);
    for (std::size_t a = 0; a < 3; ++a) {
      loads_[i].force[a] += f[a];
      loads_[i].torque[a] -= distance * moment[a];
    }
  }

  void walls(std::size_t i) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (scene_.periodic[a]) continue;
      Point n{};
      n[a] = 1;
      surface(i, n, at(i)[a]);
      n[a] = -1;
      surface(i, n, scene_.size[a] - at(i)[a]);
    }
  }

  /// A thin box with rounded edges: all points within half a thickness of the shrunk mid-plane.
  void plate(std::size_t i, const Baffle& baffle) {
    const auto normal = static_cast<std::size_t>(baffle.normal);
    Point d{};
    double square = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      double low = baffle.position, high = baffle.position;
      if (a != normal) {
        low = baffle.extent[a].low == 0 ? -1 : baffle.extent[a].low + 0.5 * baffle.thickness;
        high = baffle.extent[a].high == scene_.size[a] ? 1 : baffle.extent[a].high - 0.5 * baffle.thickness;
      }
      d[a] = at(i)[a] - std::min(std::max(at(i)[a], low), high);
      square += d[a] * d[a];
    }
    const double distance = std::sqrt(square);
    surface(i, {d[0] / distance, d[1] / distance, d[2] / distance}, distance - 0.5 * baffle.thickness);
  }

  Point push(const Point& n, double overlap, const Point& v, double effective_mass) {
    ++contacts_;
    SpringLaw::Contact c{dt_, {n[0], n[1], n[2]}, overlap, {v[0], v[1], v[2]}, effective_mass, {}};
    const SpringLaw::Force f = law_.force(c);
    return {f.total[0], f.total[1], f.total[2]};
  }

  const ParticleStore& store_;
  const ModelScene& scene_;
  const SpringLaw law_;
  const double dt_;
  std::vector<Loads> loads_;
  std::size_t contacts_ = 0;
};

/// Overlapping spheres all over the box, also across every wall and plate.
ParticleStore dense_crowd(const ModelScene& scene, std::size_t count, double smallest, double largest, std::uint64_t seed) {
  ParticleStore store = spinning_store();
  Random random(seed);
  for (std::size_t n = 0; n < count; ++n) {
    const double radius = random.within(smallest, largest);
    const std::size_t row = add_sphere(store, random.within(0, scene.size[0]), random.within(0, scene.size[1]),
                                       random.within(0, scene.size[2]), radius);
    store.angular_velocity[row] = {random.within(-50, 50), random.within(-50, 50), random.within(-50, 50),
                                   store.angular_velocity[row].w};
  }
  stir(store, 0.3, seed + 1);
  return store;
}

void expect_same_loads(const ModelScene& scene, ParticleStore store, const SpringLaw& law, std::size_t least_contacts) {
  const double dt = 1e-7;
  const ParticleStore start = store;
  const AllPairs all(start, scene, law, dt);
  ASSERT_GT(all.contacts(), least_contacts);
  const ContactModel model = make_law(law);
  Engine engine(store, scene, model, options(dt));
  engine.advance(1);
  EXPECT_EQ(engine.report().contacts, all.contacts());
  double largest = 0;
  for (std::size_t row = 0; row < start.size(); ++row) {
    for (const double f : all.of(row).force) largest = std::max(largest, std::fabs(f));
  }
  // Sums of some tens of terms in another order.
  const double rounding = 1e-13 * largest;
  for (std::size_t row = 0; row < store.size(); ++row) {
    const Loads& expected = all.of(store.id[row]);
    EXPECT_NEAR(store.force[row].x, expected.force[0], rounding);
    EXPECT_NEAR(store.force[row].y, expected.force[1], rounding);
    EXPECT_NEAR(store.force[row].z, expected.force[2], rounding);
    const double lever = start.position[0].w * 10;
    EXPECT_NEAR(store.torque[row].x, expected.torque[0], rounding * lever);
    EXPECT_NEAR(store.torque[row].y, expected.torque[1], rounding * lever);
    EXPECT_NEAR(store.torque[row].z, expected.torque[2], rounding * lever);
  }
}

const SpringLaw k_smooth{.damping_ratio = 0.1};
const SpringLaw k_rough{.damping_ratio = 0.1, .friction = 0.3, .rotation = true};

TEST(EveryPair, IsFoundInABoxWithWalls) {
  const ModelScene scene = box(0.02, 0.013, 0.024);
  expect_same_loads(scene, dense_crowd(scene, 3000, 0.5e-3, 0.5e-3, 1), k_smooth, 3000);
  expect_same_loads(scene, dense_crowd(scene, 3000, 0.5e-3, 0.5e-3, 2), k_rough, 3000);
}

TEST(EveryPair, IsFoundAcrossPeriodicFaces) {
  const ModelScene all_round = box(0.011, 0.012, 0.013, {true, true, true});
  expect_same_loads(all_round, dense_crowd(all_round, 1500, 0.5e-3, 0.5e-3, 3), k_rough, 2000);
  const ModelScene tube = box(0.02, 0.004, 0.02, {false, true, false});
  expect_same_loads(tube, dense_crowd(tube, 1200, 0.5e-3, 0.5e-3, 4), k_rough, 1000);
}

TEST(EveryPair, IsFoundAcrossAPeriodicDirectionTwoSpheresWide) {
  const ModelScene scene = box(0.02, 0.0023, 0.02, {false, true, false});
  expect_same_loads(scene, dense_crowd(scene, 600, 0.5e-3, 0.5e-3, 5), k_rough, 500);
}

TEST(EveryPair, IsFoundAmongSizesOneToTen) {
  const ModelScene scene = box(0.02, 0.02, 0.02, {true, false, false});
  expect_same_loads(scene, dense_crowd(scene, 3000, 0.1e-3, 1e-3, 6), k_rough, 3000);
}

TEST(EveryPair, IsFoundWithinTheLawsReach) {
  const ModelScene scene = box(0.02, 0.02, 0.02);
  SpringLaw law = k_smooth;
  law.reach = 0.3e-3;
  expect_same_loads(scene, dense_crowd(scene, 2000, 0.4e-3, 0.5e-3, 7), law, 2000);
}

Baffle plate_at(double x, double thickness, Interval y, Interval z) {
  Baffle plate;
  plate.name = "plate";
  plate.position = x;
  plate.thickness = thickness;
  plate.extent = {Interval{x, x}, y, z};
  return plate;
}

/// Spheres of one half of the box, and no pair that the plate should keep apart.
TEST(EveryPair, IsFoundBesideAndAroundABaffle) {
  ModelScene scene = box(0.02, 0.012, 0.02);
  scene.baffles.push_back(plate_at(0.01, 2e-3, {0, 0.012}, {0.005, 0.015}));
  ParticleStore everywhere = dense_crowd(scene, 3000, 0.5e-3, 0.5e-3, 8), clear = spinning_store();
  for (std::size_t row = 0; row < everywhere.size(); ++row) {
    const Row& p = everywhere.position[row];
    const double beyond = std::max(std::max(0.006 - p.z, p.z - 0.014), 0.0);
    // Not deeper in the plate than a third of a radius.
    if (std::hypot(p.x - 0.01, beyond) - 1e-3 < 0.35e-3) continue;
    const std::size_t kept = add_sphere(clear, p.x, p.y, p.z, p.w);
    clear.velocity[kept] = everywhere.velocity[row];
    clear.angular_velocity[kept] = everywhere.angular_velocity[row];
  }
  expect_same_loads(scene, clear, k_rough, 2000);
}

}  // namespace
}  // namespace similitude
