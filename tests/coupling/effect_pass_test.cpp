/// An effect's forces reach particles and come back to the gas: parcel weight, implicit part, accounts.

#include <gtest/gtest.h>

#include <similitude/effect.h>

#include "bed.h"
#include "coupling/effect_pass.h"
#include "particles/errors.h"

namespace similitude::testing {
namespace {

constexpr double k_push = 1e-6;     // [N], along x
constexpr double k_linear = 2e-5;   // [kg/s]

/// A steady push and an extra resistance, on every particle alike.
struct Push {
  template <class V>
  Addition<V> particles(const Particle<V>&) const {
    return {.force = {V(k_push), V(0), V(0)}, .linear_coefficient = V(k_linear)};
  }
};

/// Shows what it is told of a particle.
struct Echo {
  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    return {.force = {p.mass, V(0), V(0)}, .linear_coefficient = p.diameter};
  }
};

struct Refusal {
  template <class V>
  Addition<V> particles(const Particle<V>&) const {
    throw std::runtime_error("no such particle was foreseen.");
  }
};

template <class Effect>
struct EffectInHand {
  similitude_descriptor descriptor = effect<Effect>({.id = "org.example.push", .version = "1.0.0", .title = "Push"});
  EffectModel model = create_model<similitude_effect_functions>(
      PluginEntry{.descriptor = &descriptor, .file = {}, .level = {}, .hides = {}}, similitude_bed{}, {});
};

constexpr double k_gas_dt = 1e-4;   // [s]

TEST(EffectPass, AddsForceAndResistanceOfAllParticlesOfAParcel) {
  ModelScene scene = small_scene();
  scene.particles[0].weight = 8;
  const Grid grid(scene);
  const EffectInHand<Push> push;
  ParticleStore particles = scattered(scene, 300);   // more than one block, and not a whole number of them
  const ParticleStore before = particles;
  EffectPass(scene, grid, push.model).apply(particles, Column<double>(grid.cell_count(), 0.7), k_gas_dt);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    EXPECT_DOUBLE_EQ(particles.stress_force[p].x, before.stress_force[p].x + 8 * k_push);
    EXPECT_EQ(particles.stress_force[p].z, before.stress_force[p].z);
    EXPECT_DOUBLE_EQ(particles.gas[p].w, before.gas[p].w + 8 * k_linear);
  }
}

// A bed from a file gives every row a size and a density: twice the size of its class and three times its density.
TEST(EffectPass, SeesAParticlesOwnDiameterAndMass) {
  ModelScene scene = small_scene();
  scene.particles[0].weight = 8;
  scene.particles[0].drag_diameter = scene.particles[0].diameter / 2;
  const Grid grid(scene);
  const EffectInHand<Echo> echo;
  ParticleStore particles = scattered(scene, 10);
  const double mass = particles.velocity[4].w;
  particles.position[4].w *= 2;
  particles.velocity[4].w *= 24;
  const ParticleStore before = particles;
  EffectPass(scene, grid, echo.model).apply(particles, Column<double>(grid.cell_count(), 0.7), k_gas_dt);
  const auto mass_seen = [&](std::size_t p) { return (particles.stress_force[p].x - before.stress_force[p].x) / 8; };
  const auto diameter_seen = [&](std::size_t p) { return (particles.gas[p].w - before.gas[p].w) / 8; };
  EXPECT_DOUBLE_EQ(mass_seen(3), mass / 8);
  EXPECT_DOUBLE_EQ(mass_seen(4), 24 * mass / 8);
  EXPECT_DOUBLE_EQ(diameter_seen(3), scene.particles[0].diameter / 2);
  EXPECT_DOUBLE_EQ(diameter_seen(4), scene.particles[0].diameter);
}

// What the gas was not charged for stands in drag_impulse after the sub-steps, and settle_accounts() makes it a debt.
TEST(EffectPass, LeavesTheForceAsADebtOfTheGas) {
  const ModelScene scene = small_scene();
  const Grid grid(scene);
  const DragFromFunctions drag;
  const EffectInHand<Push> push;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 300);
  const GasFields gas = rough_gas(grid);
  coupling.start(particles);
  coupling.deposit(particles, gas, k_gas_dt);
  coupling.interpolate(particles, gas, k_gas_dt);
  const std::vector<Row> charged(particles.drag_impulse.begin(), particles.drag_impulse.end());
  EffectPass(scene, grid, push.model).apply(particles, coupling.fields().gas_fraction, k_gas_dt);
  // As if the sub-steps had delivered exactly what the drag was charged for, so that only the effect's part is left.
  for (std::size_t p = 0; p < particles.size(); ++p) {
    particles.drag_impulse[p].x -= charged[p].x;
    particles.drag_impulse[p].y -= charged[p].y;
    particles.drag_impulse[p].z -= charged[p].z;
  }
  coupling.settle_accounts(particles);
  const double owed = -300 * k_push * k_gas_dt;
  EXPECT_NEAR(coupling.pending_momentum()[0], owed, 1e-12 * std::abs(owed));
  EXPECT_NEAR(coupling.pending_momentum()[2], 0, 1e-12 * std::abs(owed));
}

TEST(EffectPass, StopsTheRunInTheEffectsOwnWords) {
  const ModelScene scene = small_scene();
  const Grid grid(scene);
  const EffectInHand<Refusal> refusal;
  ParticleStore particles = scattered(scene, 10);
  EffectPass pass(scene, grid, refusal.model);
  try {
    pass.apply(particles, Column<double>(grid.cell_count(), 0.7), k_gas_dt);
    FAIL() << "nothing was said";
  } catch (const SimulationError& error) {
    EXPECT_STREQ(error.what(), "the effect \"org.example.push\" failed: no such particle was foreseen.\n"
                               "  Leave it out of models.effects, or ask its author.");
  }
}

}  // namespace
}  // namespace similitude::testing
