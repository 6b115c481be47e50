#include <gtest/gtest.h>

#include "beds.h"
#include "particles/surfaces.h"

namespace similitude {
namespace {
using namespace testing;

ModelScene with_plate(double thickness, std::array<bool, 3> periodic = {}) {
  ModelScene scene = box(0.02, 0.01, 0.02, periodic);
  Baffle plate;
  plate.name = "plate";
  plate.normal = Axis::x;
  plate.position = 0.01;
  plate.thickness = thickness;
  plate.extent = {Interval{0.01, 0.01}, Interval{0, 0.01}, Interval{0.005, 0.015}};
  scene.baffles.push_back(plate);
  return scene;
}

double push_at(const ModelScene& scene, const ContactModel& law, double x, double y, double z, Row* force = nullptr) {
  ParticleStore store;
  add_sphere(store, x, y, z);
  Engine engine(store, scene, law, options(1e-9));
  engine.advance(1);
  if (force) *force = store.force[0];
  return std::hypot(store.force[0].x, store.force[0].y, store.force[0].z);
}

TEST(Baffles, HaveTheirThickness) {
  const ModelScene scene = with_plate(2e-3);
  const ContactModel law = make_law({.stiffness = 1000});
  Row force;
  EXPECT_NEAR(push_at(scene, law, 0.01 + 1e-3 + 0.4e-3, 0.005, 0.01, &force), 0.1, 1e-9);
  EXPECT_NEAR(force.x, 0.1, 1e-9);
  push_at(scene, law, 0.01 - 1e-3 - 0.4e-3, 0.005, 0.01, &force);
  EXPECT_NEAR(force.x, -0.1, 1e-9);
  EXPECT_EQ(push_at(scene, law, 0.01 + 1e-3 + 0.51e-3, 0.005, 0.01), 0);
  // The free end is where the case says, the rounding inside it.
  EXPECT_NEAR(push_at(scene, law, 0.01, 0.005, 0.015 + 0.4e-3, &force), 0.1, 1e-9);
  EXPECT_NEAR(force.z, 0.1, 1e-9);
  EXPECT_EQ(push_at(scene, law, 0.01, 0.005, 0.015 + 0.51e-3), 0);
}

TEST(Baffles, AnEdgeOnAWallIsNotRounded) {
  const ModelScene scene = with_plate(2e-3);
  const ContactModel law = make_law({.stiffness = 1000});
  Row force;
  push_at(scene, law, 0.01 + 1e-3 + 0.4e-3, 0.0005, 0.01, &force);   // touches plate and front wall, at no overlap there
  EXPECT_NEAR(force.x, 0.1, 1e-9);
  EXPECT_NEAR(force.y, 0, 1e-9);
}

// A sphere led round the end of the plate at a constant depth feels a constant push that turns without a jump.
TEST(Baffles, RollingOverTheRoundedEdgeFeelsAContinuousForce) {
  const ModelScene scene = with_plate(2e-3);
  const ContactModel law = make_law({.stiffness = 1000});
  const double depth = 0.1e-3, away = 1e-3 + 0.5e-3 - depth;
  Row before{};
  for (int n = 0; n <= 400; ++n) {
    const double along = -1e-3 + 5e-3 * n / 400;   // [m], path: up the right side, over the end, down the left side
    double x, z;
    const double turn = std::min(std::max(along / away, 0.0), k_pi);
    if (along < 0) {
      x = 0.01 + away, z = 0.014 + along;
    } else {
      x = 0.01 + away * std::cos(turn), z = 0.014 + away * std::sin(turn);
    }
    Row force;
    EXPECT_NEAR(push_at(scene, law, x, 0.005, z, &force), 1000 * depth, 1e-9);
    if (n > 0) {
      EXPECT_LT(std::hypot(force.x - before.x, force.z - before.z), 1000 * depth * (5e-3 / 400 / away) * 1.01);
    }
    before = force;
  }
}

TEST(Baffles, NoContactReachesThroughAThinPlate) {
  const ModelScene thin = with_plate(0.02e-3);
  const ContactModel law = make_law({.stiffness = 1000, .reach = 0.2e-3});
  ParticleStore store;
  add_sphere(store, 0.01 - 0.53e-3, 0.005, 0.01);
  add_sphere(store, 0.01 + 0.53e-3, 0.005, 0.01);
  Engine engine(store, thin, law, options(1e-9));
  engine.advance(1);
  EXPECT_EQ(engine.report().contacts, 2u);   // each with the plate, not with each other
  const ModelScene none = box(0.02, 0.01, 0.02);
  Engine open(store, none, law, options(1e-9));
  open.advance(1);
  EXPECT_EQ(open.report().contacts, 1u);
}

TEST(Baffles, SpheresBesideTheEndOfAPlateDoTouch) {
  const ModelScene thin = with_plate(0.02e-3);
  const ContactModel law = make_law({.stiffness = 1000});
  ParticleStore store;
  add_sphere(store, 0.01 - 0.49e-3, 0.005, 0.0156);
  add_sphere(store, 0.01 + 0.49e-3, 0.005, 0.0156);
  Engine engine(store, thin, law, options(1e-9));
  engine.advance(1);
  EXPECT_EQ(engine.report().contacts, 1u);
}

TEST(Baffles, ASphereThrownAtAThinPlateComesBack) {
  const ModelScene thin = with_plate(0.1e-3);
  const ContactModel law = make_law({.stiffness = 1000});
  ParticleStore store;
  add_sphere(store, 0.0085, 0.005, 0.01);
  store.velocity[0].x = 1;
  Engine engine(store, thin, law, options(2e-6));
  engine.advance(1000);
  EXPECT_LT(store.position[0].x, 0.0095);
  EXPECT_NEAR(store.velocity[0].x, -1, 0.01);
}

TEST(Baffles, AreSeenThroughPeriodicFaces) {
  ModelScene scene = with_plate(2e-3, {true, true, false});
  scene.baffles[0].position = 0.0005;   // at the left face: the particle at the right face touches its image
  scene.baffles[0].extent[0] = {0.0005, 0.0005};
  const ContactModel law = make_law({.stiffness = 1000});
  Row force;
  push_at(scene, law, 0.02 - 0.9e-3, 0.005, 0.01, &force);
  EXPECT_NEAR(force.x, -0.1, 1e-9);
}

TEST(Baffles, SeparateOnlyPointsOnBothSidesOfThePlate) {
  const Surfaces surfaces(with_plate(1e-3));
  const std::size_t plate = surfaces.count() - 1;
  ASSERT_TRUE(surfaces.is_baffle(plate));
  EXPECT_TRUE(surfaces.separates(plate, {0.009, 0.005, 0.01, 0}, {0.011, 0.005, 0.01, 0}));
  EXPECT_FALSE(surfaces.separates(plate, {0.009, 0.005, 0.01, 0}, {0.0095, 0.005, 0.01, 0}));
  EXPECT_FALSE(surfaces.separates(plate, {0.009, 0.005, 0.016, 0}, {0.011, 0.005, 0.016, 0}));
  EXPECT_EQ(surfaces.name(plate), "baffle plate");
  EXPECT_EQ(surfaces.name(0), "the left wall");
}

}  // namespace
}  // namespace similitude
