#include <gtest/gtest.h>

#include "beds.h"

namespace similitude {
namespace {
using namespace testing;

struct Totals {
  std::array<double, 3> momentum{}, spin{};   // [kg m/s], [kg m^2/s] about the origin
  double energy = 0;                          // [J], kinetic
};

Totals totals(const ParticleStore& store) {
  Totals out;
  for (std::size_t row = 0; row < store.size(); ++row) {
    const Row &x = store.position[row], &v = store.velocity[row];
    const double m = v.w;
    out.momentum = {out.momentum[0] + m * v.x, out.momentum[1] + m * v.y, out.momentum[2] + m * v.z};
    out.spin = {out.spin[0] + m * (x.y * v.z - x.z * v.y), out.spin[1] + m * (x.z * v.x - x.x * v.z),
                out.spin[2] + m * (x.x * v.y - x.y * v.x)};
    out.energy += 0.5 * m * (v.x * v.x + v.y * v.y + v.z * v.z);
    if (store.fields.rotation) {
      const Row& w = store.angular_velocity[row];
      out.spin = {out.spin[0] + w.w * w.x, out.spin[1] + w.w * w.y, out.spin[2] + w.w * w.z};
      out.energy += 0.5 * w.w * (w.x * w.x + w.y * w.y + w.z * w.z);
    }
  }
  return out;
}

TEST(Pairs, HeadOnSpheresPartWithTheRestitution) {
  const ModelScene scene = box(0.02, 0.02, 0.02);
  ParticleStore store;
  add_sphere(store, 0.0094, 0.01, 0.01, 0.5e-3);
  add_sphere(store, 0.0106, 0.01, 0.01, 0.4e-3);
  store.velocity[0].x = 0.3;
  store.velocity[1].x = -0.7;
  const double before = totals(store).momentum[0];
  const ContactModel law = make_law({.damping_ratio = damping_ratio_of(0.6)});
  Engine engine(store, scene, law, options(2e-7));
  engine.advance(3000);
  const Row &a = store.velocity[row_of(store, 0)], &b = store.velocity[row_of(store, 1)];
  EXPECT_NEAR(b.x - a.x, 0.6 * 1.0, 0.006);   // the scheme's error at t_c/250
  EXPECT_NEAR(totals(store).momentum[0], before, 1e-15 * a.w);
}

// Frictionless: only the normal part of the velocity turns round. Equal elastic spheres exchange it.
TEST(Pairs, ObliqueSmoothSpheresExchangeTheNormalVelocity) {
  const ModelScene scene = box(0.02, 0.02, 0.02);
  ParticleStore store;
  add_sphere(store, 0.01, 0.01, 0.01);
  const double angle = 0.6;   // of the line of centres, at the moment they touch
  add_sphere(store, 0.01 + k_diameter * std::cos(angle), 0.01 + k_diameter * std::sin(angle), 0.01);
  store.velocity[0].x = 0.5;
  const ContactModel law = make_law({.stiffness = 1e6});   // stiff: the line of centres hardly turns
  Engine engine(store, scene, law, options(1e-8));
  engine.advance(500);
  const Row &a = store.velocity[row_of(store, 0)], &b = store.velocity[row_of(store, 1)];
  const double normal = 0.5 * std::cos(angle);
  EXPECT_NEAR(b.x, normal * std::cos(angle), 0.005);
  EXPECT_NEAR(b.y, normal * std::sin(angle), 0.005);
  EXPECT_NEAR(a.x, 0.5 - normal * std::cos(angle), 0.005);
  EXPECT_NEAR(a.y, -normal * std::sin(angle), 0.005);
}

// Walton (1993): in gross sliding the tangential velocity of the contact falls by (7/2) mu (1 + e) v_n.
TEST(Pairs, ObliqueRoughSpheresSlideWithCoulombFriction) {
  const ModelScene scene = box(0.02, 0.02, 0.02);
  ParticleStore store = spinning_store();
  add_sphere(store, 0.01, 0.01, 0.01);
  add_sphere(store, 0.01 + k_diameter, 0.01, 0.01);
  store.velocity[0] = {0.2, 1.0, 0, store.velocity[0].w};
  const double friction = 0.1;
  const ContactModel law = make_law({.stiffness = 1e6, .friction = friction, .rotation = true});
  Engine engine(store, scene, law, options(1e-8));
  engine.advance(600);
  const std::size_t a = row_of(store, 0), b = row_of(store, 1);
  const double slip = store.velocity[a].y - store.velocity[b].y +
                      (store.angular_velocity[a].z + store.angular_velocity[b].z) * 0.5 * k_diameter;
  EXPECT_NEAR(slip, 1.0 - 3.5 * friction * 2 * 0.2, 0.002);
}

/// Spheres of three sizes that spin and collide in a box without walls.
ParticleStore periodic_crowd(ModelScene& scene) {
  scene = box(0.012, 0.010, 0.011, {true, true, true});
  ParticleStore store = spinning_store();
  Random random(5);
  fill_lattice(store, scene, 600, 0.45e-3, 1.0e-3, 0.05e-3);
  for (std::size_t row = 0; row < store.size(); ++row) {
    const double radius = random.within(0.35e-3, 0.44e-3), mass = sphere_mass(radius);
    store.position[row].w = radius;
    store.velocity[row].w = mass;
    store.angular_velocity[row] = {random.within(-200, 200), random.within(-200, 200), random.within(-200, 200),
                                   0.4 * mass * radius * radius};
  }
  stir(store, 0.5);
  return store;
}

TEST(Pairs, MomentumIsConservedToRoundingInAPeriodicBox) {
  ModelScene scene;
  ParticleStore store = periodic_crowd(scene);
  const Totals before = totals(store);
  const ContactModel law = make_law({.damping_ratio = 0.1, .friction = 0.3, .rotation = true, .rolling = 1e-5});
  Engine engine(store, scene, law, options(2e-6));
  engine.advance(2000);
  const Totals after = totals(store);
  EXPECT_LT(after.energy, 0.9 * before.energy);   // they did collide
  EXPECT_GT(engine.report().rebuilds, 5u);
  const double scale = 600 * sphere_mass(0.5e-3) * 0.5;
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(after.momentum[axis], before.momentum[axis], 1e-14 * scale);
}

// Positions move after forces were taken, which keeps x cross m v of a pair force exactly; no wall, so no torque.
TEST(Pairs, AngularMomentumIsConservedToRoundingInAFreeCloud) {
  ModelScene scene;
  ParticleStore store = periodic_crowd(scene);
  scene = box(1, 1, 1);
  for (Row& x : store.position) x = {x.x + 0.5, x.y + 0.5, x.z + 0.5, x.w};
  const Totals before = totals(store);
  const ContactModel law = make_law({.damping_ratio = 0.1, .friction = 0.3, .rotation = true, .rolling = 1e-5});
  Engine engine(store, scene, law, options(2e-6));
  engine.advance(1000);
  const Totals after = totals(store);
  EXPECT_LT(after.energy, 0.95 * before.energy);
  const double scale = 600 * sphere_mass(0.5e-3) * 0.5 * 0.5;   // m v x
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(after.spin[axis], before.spin[axis], 1e-13 * scale);
}

// A granular gas without loss: 195 smooth spheres at a solids fraction of 0.05 keep their kinetic energy. Spheres in
// contact hold some of it as spring energy, so the mean over a while is compared.
TEST(Pairs, ElasticSpheresKeepTheirEnergy) {
  const ModelScene scene = box(0.0127, 0.0127, 0.0127, {true, true, true});
  ParticleStore store;
  fill_lattice(store, scene, 195, 0.5 * k_diameter, 2.0e-3, 0.3e-3);
  stir(store, 0.1);
  const double before = totals(store).energy;
  const ContactModel law = make_law({.stiffness = 1000});
  Engine engine(store, scene, law, options(1e-6));
  engine.advance(50'000);
  double mean = 0;
  for (int sample = 0; sample < 20; ++sample) {
    engine.advance(500);
    mean += totals(store).energy / 20;
  }
  EXPECT_NEAR(mean, before, 0.01 * before);
}

TEST(Pairs, TheLawSeesPairsWithinItsReach) {
  const ModelScene scene = box(0.02, 0.02, 0.02);
  ParticleStore store;
  add_sphere(store, 0.01, 0.01, 0.01);
  add_sphere(store, 0.01 + 1.1 * k_diameter, 0.01, 0.01);
  const ContactModel near = make_law({.reach = 0.09 * k_diameter});
  Engine short_of_it(store, scene, near, options(1e-6));
  short_of_it.advance(1);
  EXPECT_EQ(short_of_it.report().contacts, 0u);
  const ContactModel far = make_law({.reach = 0.11 * k_diameter});
  Engine within(store, scene, far, options(1e-6));
  within.advance(1);
  EXPECT_EQ(within.report().contacts, 1u);
}

}  // namespace
}  // namespace similitude
