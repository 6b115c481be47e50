#include <gtest/gtest.h>

#include "beds.h"

// The books of the particles: every push is entered once, and the sum is what they have.
namespace similitude::testing {
namespace {

struct Held {
  std::array<double, 3> momentum{};
  double energy = 0;
};

Held held_by(const ParticleStore& store) {
  Held held;
  for (std::size_t row = 0; row < store.size(); ++row) {
    const Row& v = store.velocity[row];
    held.momentum[0] += v.w * v.x;
    held.momentum[1] += v.w * v.y;
    held.momentum[2] += v.w * v.z;
    held.energy += 0.5 * v.w * (v.x * v.x + v.y * v.y + v.z * v.z);
    if (!store.fields.rotation) continue;
    const Row& w = store.angular_velocity[row];
    held.energy += 0.5 * w.w * (w.x * w.x + w.y * w.y + w.z * w.z);
  }
  return held;
}

/// A stirred bed that falls onto its floor, in an upward gas if it is coupled.
struct Falling {
  ModelScene scene = box(0.01, 0.01, 0.03);
  ParticleStore store;
  SpringLaw law{.stiffness = 1000, .damping_ratio = 0.1, .friction = 0.3, .rotation = true};

  explicit Falling(bool coupled) : store({.rotation = true, .coupling = coupled}) {
    fill_lattice(store, scene, 800, 0.5e-3, 1.1e-3, 0.04e-3);
    stir(store, 0.5);
    for (std::size_t row = 0; coupled && row < store.size(); ++row) {
      store.gas[row] = {0.3, -0.2, 1.5, 2e-6};
      store.stress_force[row] = {1e-7, 0, 3e-6, 0};
    }
  }
};

void expect_closed(const ParticleBudget& b, const Held& before, const Held& after, double allowed) {
  double moved = 0;
  for (std::size_t a = 0; a < 3; ++a) moved += std::abs(b.gravity_impulse[a]) + std::abs(b.wall_impulse[a]);
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_NEAR(after.momentum[a] - before.momentum[a] + b.removed_momentum[a],
                b.gravity_impulse[a] + b.drag_impulse[a] + b.stress_impulse[a] + b.wall_impulse[a], allowed * moved)
        << "axis " << a;
  }
  EXPECT_NEAR(after.energy - before.energy + b.removed_energy, b.gravity_work + b.drag_work + b.stress_work + b.contact_work,
              allowed * (before.energy + std::abs(b.gravity_work) + std::abs(b.contact_work)));
}

}  // namespace

TEST(ParticleBudget, OfABedThatFallsOnItsFloorClosesToRounding) {
  Falling bed(false);
  const Held before = held_by(bed.store);
  const ContactModel law = make_law(bed.law);
  Engine engine(bed.store, bed.scene, law, options(2e-6, 9.81));
  engine.advance(5000);
  const ParticleBudget& budget = engine.report().budget;
  EXPECT_GT(budget.wall_impulse[2], 0.2 * std::abs(budget.gravity_impulse[2]));   // it lies on the floor
  EXPECT_LT(budget.contact_work, 0);                                              // and has lost energy in contacts
  EXPECT_EQ(budget.drag_work, 0);
  expect_closed(budget, before, held_by(bed.store), 1e-12);
}

TEST(ParticleBudget, EntersDragAndHeldForces) {
  Falling bed(true);
  const Held before = held_by(bed.store);
  const ContactModel law = make_law(bed.law);
  Engine engine(bed.store, bed.scene, law, options(2e-6, 9.81));
  engine.advance(3000);
  const ParticleBudget& budget = engine.report().budget;
  EXPECT_GT(budget.drag_impulse[2], 0);
  EXPECT_NEAR(budget.stress_impulse[2], 800 * 3e-6 * 3000 * 2e-6, 1e-12 * budget.stress_impulse[2] * 800);
  expect_closed(budget, before, held_by(bed.store), 1e-12);
}

TEST(ParticleBudget, EntersWhatLeavesThroughAnOutlet) {
  Falling bed(false);
  Patch top;
  top.face = {Axis::z, Side::high};
  top.kind = PatchKind::pressure;
  top.extent = {Interval{0, 0.01}, Interval{0, 0.01}, Interval{0.03, 0.03}};
  bed.scene.patches.push_back(top);
  for (Row& v : bed.store.velocity) v.z += 3;
  const Held before = held_by(bed.store);
  const ContactModel law = make_law(bed.law);
  Engine engine(bed.store, bed.scene, law, options(2e-6));
  engine.advance(4000);
  ASSERT_GT(engine.report().removed, 50u);
  EXPECT_GT(engine.report().budget.removed_energy, 0);
  expect_closed(engine.report().budget, before, held_by(bed.store), 1e-12);
}

// Elastic spheres in an elastic box: what contacts take while spheres are pressed together they give back.
TEST(ParticleBudget, OfElasticContactsReturnsWhatTheyTook) {
  Falling bed(false);
  bed.law = {.stiffness = 1000};
  const double energy = held_by(bed.store).energy;
  const ContactModel law = make_law(bed.law);
  Engine engine(bed.store, bed.scene, law, options(1e-6));
  engine.advance(10000);
  EXPECT_NEAR(engine.report().budget.contact_work, 0, 0.05 * energy);   // a few are pressed together at any moment
}

}  // namespace similitude::testing
