#include <gtest/gtest.h>

#include "beds.h"

namespace similitude {
namespace {
using namespace testing;

// Semi-implicit Euler under constant g: v_n = -g n dt, z_n = z_0 - g dt^2 n (n + 1) / 2, exactly but for rounding.
TEST(Motion, FreeFallFollowsTheSumOfTheScheme) {
  const ModelScene scene = box(0.1, 0.1, 10);
  ParticleStore store;
  add_sphere(store, 0.05, 0.05, 9);
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-4, 9.81));
  engine.advance(1000);
  EXPECT_NEAR(store.velocity[0].z, -9.81 * 0.1, 1e-13);
  EXPECT_NEAR(store.position[0].z, 9 - 9.81 * 1e-8 * 1000 * 1001 / 2, 1e-12);
  EXPECT_EQ(store.position[0].x, 0.05);
  EXPECT_EQ(store.position[0].w, 0.5 * k_diameter);
  EXPECT_EQ(store.velocity[0].w, sphere_mass(0.5 * k_diameter));
  EXPECT_EQ(engine.report().particle_steps, 1000u);
  EXPECT_DOUBLE_EQ(engine.report().largest_speed, std::fabs(store.velocity[0].z));
}

// v' = (v + a dt u) / (1 + a dt) with a = K/m: closed form (u - v_n) = (u - v_0) / (1 + a dt)^n.
TEST(Motion, DragIsImplicitAndItsImpulseIsWhatTheParticleGained) {
  const ModelScene scene = box(0.1, 0.1, 1);
  ParticleStore store({.rotation = false, .coupling = true});
  add_sphere(store, 0.05, 0.05, 0.5);
  const double mass = store.velocity[0].w, gas_speed = 2, rate = 300;   // [kg], [m/s], [1/s]
  store.gas[0] = {gas_speed, 0, 0, rate * mass};
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-3));
  engine.advance(5);
  EXPECT_NEAR(store.velocity[0].x, gas_speed * (1 - std::pow(1.3, -5)), 1e-14);
  EXPECT_NEAR(store.drag_impulse[0].x, mass * store.velocity[0].x, 1e-15 * mass * gas_speed * 10);
  EXPECT_EQ(store.drag_impulse[0].w, 0);
}

TEST(Motion, DragOfAnyStrengthIsStable) {
  const ModelScene scene = box(0.1, 0.1, 1);
  ParticleStore store({.rotation = false, .coupling = true});
  add_sphere(store, 0.05, 0.05, 0.5);
  store.gas[0] = {0.1, 0, 0, 1e12 * store.velocity[0].w};
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-3));
  engine.advance(10);
  EXPECT_NEAR(store.velocity[0].x, 0.1, 1e-9);
}

TEST(Motion, HeldStressForceAcceleratesWithoutDragImpulse) {
  const ModelScene scene = box(0.1, 0.1, 1);
  ParticleStore store({.rotation = false, .coupling = true});
  add_sphere(store, 0.05, 0.05, 0.5);
  store.stress_force[0] = {0, 3 * store.velocity[0].w, 0, 0};
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-4));
  engine.advance(100);
  EXPECT_NEAR(store.velocity[0].y, 3 * 1e-2, 1e-15);
  EXPECT_EQ(store.drag_impulse[0].y, 0);
}

TEST(Motion, SettlingDampsVelocityAndSpinImplicitly) {
  const ModelScene scene = box(0.1, 0.1, 1);
  ParticleStore store = spinning_store();
  add_sphere(store, 0.05, 0.05, 0.5);
  store.velocity[0].x = 1;
  store.angular_velocity[0].y = 8;
  const double inertia = store.angular_velocity[0].w;
  const ContactModel law = make_law({.friction = 0.3, .rotation = true});
  EngineOptions damped = options(1e-3);
  damped.velocity_damping = 1000;
  Engine engine(store, scene, law, damped);
  engine.advance(3);
  EXPECT_DOUBLE_EQ(store.velocity[0].x, 1.0 / 8);
  EXPECT_DOUBLE_EQ(store.angular_velocity[0].y, 1);
  EXPECT_EQ(store.angular_velocity[0].w, inertia);
  engine.set_options(options(1e-3));
  engine.advance(1);
  EXPECT_DOUBLE_EQ(store.velocity[0].x, 1.0 / 8);
}

TEST(Motion, PeriodicDirectionsBringParticlesBack) {
  const ModelScene scene = box(0.01, 0.01, 0.01, {true, true, true});
  ParticleStore store;
  add_sphere(store, 0.0099, 0.005, 0.0001);
  store.velocity[0] = {1, 0, -2, store.velocity[0].w};
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-4));
  engine.advance(150);   // 15 mm and 30 mm: one and a half and three turns
  engine.advance(0);
  const double skin = 0.1 * k_diameter;   // positions are brought back when the lists are rebuilt
  EXPECT_NEAR(std::remainder(store.position[0].x - (0.0099 + 0.015), 0.01), 0, 1e-15);
  EXPECT_NEAR(std::remainder(store.position[0].z - (0.0001 - 0.030), 0.01), 0, 1e-15);
  EXPECT_GT(store.position[0].x, -skin);
  EXPECT_LT(store.position[0].x, 0.01 + skin);
}

TEST(Motion, AnEmptyBedAdvances) {
  const ModelScene scene = box(0.1, 0.1, 1);
  ParticleStore store;
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-4, 9.81));
  engine.advance(10);
  EXPECT_EQ(engine.report().particle_steps, 0u);
  add_sphere(store, 0.05, 0.05, 0.5);   // and takes particles later
  engine.advance(10);
  EXPECT_EQ(engine.report().particle_steps, 10u);
  EXPECT_NEAR(store.velocity[0].z, -9.81e-3, 1e-15);
}

}  // namespace
}  // namespace similitude
