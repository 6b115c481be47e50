#include <gtest/gtest.h>

#include "beds.h"
#include "particles/errors.h"
#include "scene/messages.h"

namespace similitude {
namespace {
using namespace testing;

template <class Error, class Work>
std::string message_of(Work&& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Guards, ANumberThatIsNotFiniteStopsTheRunWithIdPlaceAndStep) {
  const ModelScene scene = box(0.01, 0.01, 0.01);
  ParticleStore store;
  for (int n = 0; n < 3; ++n) add_sphere(store, 0.002 + 0.003 * n, 0.005, 0.004);
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-6));
  engine.advance(4);
  store.velocity[row_of(store, 1)].y = std::nan("");
  EXPECT_EQ(message_of<SimulationError>([&] { engine.advance(1); }),
            "Particle 1 has a position or velocity that is not a finite number after sub-step 5; it was last listed at "
            "(0.005, 0.005, 0.004) m.\n"
            "  Usually the time step is too long for the contact stiffness, or particles overlap at the start: compare time.dt "
            "with the limits that `similitude check` prints.");
}

TEST(Guards, AForceThatIsNotANumberStopsTheRun) {
  const ModelScene scene = box(0.01, 0.01, 0.01);
  ParticleStore store;
  add_sphere(store, 0.005, 0.005, 0.005);
  add_sphere(store, 0.0059, 0.005, 0.005);
  const ContactModel law = make_law({.poison = true});
  Engine engine(store, scene, law, options(1e-6));
  EXPECT_THROW(engine.advance(1), SimulationError);
}

TEST(Guards, WhatALawSaysReachesTheUser) {
  const ModelScene scene = box(0.01, 0.01, 0.01);
  ParticleStore store;
  add_sphere(store, 0.005, 0.005, 0.005);
  add_sphere(store, 0.0059, 0.005, 0.005);
  const ContactModel law = make_law({.refuse = true});
  Engine engine(store, scene, law, options(1e-6));
  EXPECT_EQ(message_of<SimulationError>([&] { engine.advance(1); }),
            "The contact law test_spring stopped the run for particle 0 at (0.005, 0.005, 0.005) m in sub-step 1: this law "
            "refuses everything");
}

TEST(Guards, TheDeepestContactIsNamedWithIdsAndPlace) {
  const ModelScene scene = box(0.01, 0.01, 0.01);
  ParticleStore store;
  add_sphere(store, 0.005, 0.005, 0.005, 0.5e-3);
  add_sphere(store, 0.0055, 0.005, 0.005, 0.1e-3);   // overlap 0.1 mm, half of the smaller diameter
  add_sphere(store, 0.002, 0.002, 0.00035, 0.5e-3);  // 0.15 of a diameter in the floor
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-9));
  engine.advance(1);
  const ContactExtreme deepest = engine.report().largest_overlap;
  EXPECT_NEAR(deepest.overlap_ratio, 0.5, 1e-9);
  EXPECT_EQ(deepest.particle + deepest.partner, 1u);
  EXPECT_NEAR(deepest.place[1], 0.005, 1e-12);
}

TEST(Guards, TheDeepestContactMayBeAWallAndIsForgottenByTheNextAdvance) {
  const ModelScene scene = box(0.01, 0.01, 0.01);
  ParticleStore store;
  add_sphere(store, 0.002, 0.002, 0.00035, 0.5e-3);
  store.velocity[0].z = 1;
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-6));
  engine.advance(1);
  EXPECT_NEAR(engine.report().largest_overlap.overlap_ratio, 0.15, 1e-9);
  EXPECT_EQ(engine.report().largest_overlap.particle, 0u);
  EXPECT_EQ(engine.report().largest_overlap.partner, ~std::uint64_t{0});
  engine.advance(500);
  engine.advance(1);
  EXPECT_EQ(engine.report().largest_overlap.overlap_ratio, 0);
}

TEST(Guards, APeriodicDirectionNarrowerThanTwoContactDistancesIsRefused) {
  const ModelScene scene = box(0.01, 0.0015, 0.01, {false, true, false});
  ParticleStore store;
  add_sphere(store, 0.005, 0.001, 0.005);
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-6));
  EXPECT_EQ(message_of<InputError>([&] { engine.advance(1); }),
            "scene.domain: the periodic direction y is 1.36 contact distances wide; a particle would meet its own image.\n"
            "  Make it at least two contact distances wide, or give it walls.");
}

TEST(Guards, ALawThatTurnsParticlesNeedsAStoreWithRotation) {
  const ModelScene scene = box(0.01, 0.01, 0.01);
  ParticleStore store;
  const ContactModel law = make_law({.rotation = true});
  EXPECT_EQ(message_of<std::invalid_argument>([&] { Engine(store, scene, law, options(1e-6)); }),
            "the contact law needs angular velocities: make the ParticleStore with fields.rotation");
}

}  // namespace
}  // namespace similitude
