#include <gtest/gtest.h>

#include "beds.h"

namespace similitude {
namespace {
using namespace testing;

// The dashpot's restitution is exp(-pi zeta / sqrt(1 - zeta^2)), force let go when the overlap ends. At t_c/200 the
// scheme's error in e is below 1 %.
TEST(Walls, ReturnTheRestitutionOfTheDashpot) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double toward : {-1.0, 1.0}) {
      const ModelScene scene = box(0.02, 0.02, 0.02);
      ParticleStore store;
      add_sphere(store, 0.01, 0.01, 0.01);
      (&store.position[0].x)[axis] = toward < 0 ? 0.6e-3 : 0.02 - 0.6e-3;
      (&store.velocity[0].x)[axis] = 0.5 * toward;
      const ContactModel law = make_law({.damping_ratio = damping_ratio_of(0.74)});
      const double contact_time =
          law.functions().contact_time(law.instance(), 0, store.velocity[0].w, 0.5 * k_diameter, 0.5);
      Engine engine(store, scene, law, options(contact_time / 200));
      engine.advance(1000);
      EXPECT_NEAR((&store.velocity[0].x)[axis], -0.74 * 0.5 * toward, 0.01 * 0.5) << "axis " << axis << " toward " << toward;
    }
  }
}

// A heap at rest: the floor carries its weight.
TEST(Walls, TheFloorCarriesTheWeightOfAHeap) {
  const ModelScene scene = box(0.006, 0.006, 0.05);
  ParticleStore store = spinning_store();
  fill_lattice(store, scene, 100, 0.5 * k_diameter, 1.05e-3, 0.02e-3);
  const ContactModel law = make_law({.damping_ratio = 0.3, .friction = 0.3, .rotation = true});
  EngineOptions settle = options(5e-6, 9.81);
  settle.velocity_damping = 30;
  Engine engine(store, scene, law, settle);
  engine.advance(60'000);
  engine.set_options(options(5e-6, 9.81));
  engine.advance(2'000);
  // Contact forces between particles cancel, so their sum over particles is what walls do; side walls have friction, and
  // all forces together hold the weight up.
  double up = 0, weight = 0;
  for (std::size_t row = 0; row < store.size(); ++row) {
    up += store.force[row].z;
    weight += 9.81 * store.velocity[row].w;
  }
  EXPECT_NEAR(up, weight, 1e-4 * weight);   // what is left moves at a few micrometres per second
  EXPECT_LT(engine.report().largest_speed, 1e-4);
}

// A sphere with spin w touching a wall slips there with v + w x (-l n).
TEST(Walls, SpinAloneDrivesASphereAlongTheFloor) {
  const ModelScene scene = box(0.1, 0.1, 0.1);
  ParticleStore store = spinning_store();
  add_sphere(store, 0.05, 0.05, 0.5 * k_diameter);
  store.angular_velocity[0].y = 100;   // rolls toward +x
  const ContactModel law = make_law({.damping_ratio = 0.5, .friction = 0.4, .rotation = true});
  Engine engine(store, scene, law, options(2e-6, 9.81));
  engine.advance(50'000);
  // Sliding ends in rolling v = w r with 2/7 of the first surface speed (solid sphere, friction of any size).
  const double surface_speed = 100 * 0.5 * k_diameter;
  EXPECT_NEAR(store.velocity[0].x, 2.0 / 7.0 * surface_speed, 0.01 * surface_speed);
  EXPECT_NEAR(store.angular_velocity[0].y * 0.5 * k_diameter, store.velocity[0].x, 0.005 * surface_speed);
}

TEST(Walls, ThePushOfACornerComesFromEveryWall) {
  const ModelScene scene = box(0.1, 0.1, 0.1);
  ParticleStore store;
  add_sphere(store, 0.45e-3, 0.4e-3, 0.48e-3);
  const ContactModel law = make_law({.stiffness = 1000});
  Engine engine(store, scene, law, options(1e-9));
  engine.advance(1);
  EXPECT_NEAR(store.force[0].x, 0.05, 1e-12);
  EXPECT_NEAR(store.force[0].y, 0.10, 1e-12);
  EXPECT_NEAR(store.force[0].z, 0.02, 1e-12);
  EXPECT_EQ(engine.report().contacts, 3u);
}

// 16 spheres side by side between four walls and 4 in the hollows between them: held by friction, nothing may creep. A
// loose sphere would roll on for ever, so none is loose.
TEST(Walls, AHeapWithFrictionDoesNotCreep) {
  const double pitch = 0.998e-3;
  const ModelScene scene = box(4 * pitch, 4 * pitch, 0.02);
  ParticleStore store = spinning_store();
  for (int n = 0; n < 16; ++n) add_sphere(store, (n % 4 + 0.5) * pitch, (0.5 + n / 4) * pitch, 0.5e-3);
  for (int n = 0; n < 4; ++n) add_sphere(store, (n % 2 == 0 ? 1 : 3) * pitch, (n / 2 == 0 ? 1 : 3) * pitch, 1.21e-3);
  const ContactModel law = make_law({.damping_ratio = 0.3, .friction = 0.4, .rotation = true});
  Engine engine(store, scene, law, options(2.5e-6, 9.81));
  engine.advance(40'000);
  std::map<std::uint64_t, Row> before;
  for (std::size_t row = 0; row < store.size(); ++row) before[store.id[row]] = store.position[row];
  engine.advance(10'000);
  for (std::size_t row = 0; row < store.size(); ++row) {
    const Row &now = store.position[row], &then = before[store.id[row]];
    EXPECT_LT(std::hypot(now.x - then.x, now.y - then.y, now.z - then.z), 1e-10 * k_diameter);
  }
}

}  // namespace
}  // namespace similitude
