#include <gtest/gtest.h>

#include "beds.h"

namespace similitude {
namespace {
using namespace testing;

struct Motion3 {
  Row velocity, spin;
};

/// Two spheres pressed together and sheared while both drift across many cells; the tangential spring holds throughout.
std::map<std::uint64_t, Motion3> sheared_pair(double skin, double drift, std::uint64_t* rebuilds, bool swap_ids = false) {
  const ModelScene scene = box(0.05, 0.05, 0.05);
  ParticleStore store = spinning_store();
  store.add(swap_ids ? 1 : 0, 0, 0.020, 0.02, 0.02, 0.5e-3, sphere_mass(0.5e-3));
  store.add(swap_ids ? 0 : 1, 0, 0.020 + 0.97e-3, 0.02, 0.02, 0.5e-3, sphere_mass(0.5e-3));
  for (std::size_t row = 0; row < 2; ++row) {
    const bool first = store.position[row].x < 0.0205;
    // The pair turns about its middle as it goes, so that now one, now the other stands in the lower cell.
    store.velocity[row] = {drift, drift + (first ? -0.02 : 0.02), 0.3 * drift + (first ? 0.01 : -0.01), store.velocity[row].w};
  }
  // Springs that never let go: reach beyond contact, no damping.
  const ContactModel law = make_law({.stiffness = 500, .friction = 0.9, .rotation = true, .reach = 0.1e-3});
  EngineOptions o = options(2e-6);
  o.skin = skin;
  Engine engine(store, scene, law, o);
  engine.advance(4000);
  if (rebuilds) *rebuilds = engine.report().rebuilds;
  std::map<std::uint64_t, Motion3> out;
  for (std::size_t row = 0; row < 2; ++row) {
    const bool swapped = swap_ids;
    out[swapped ? 1 - store.id[row] : store.id[row]] = {store.velocity[row], store.angular_velocity[row]};
  }
  return out;
}

TEST(History, SurvivesRebuildsAndSortsToRounding) {
  std::uint64_t many = 0, few = 0;
  const auto often = sheared_pair(0.02e-3, 0.4, &many);
  const auto once = sheared_pair(20e-3, 0.4, &few);
  EXPECT_GT(many, 100u);
  EXPECT_EQ(few, 1u);
  for (const std::uint64_t id : {0u, 1u}) {
    const Motion3 &a = often.at(id), &b = once.at(id);
    // Where the pair is sorted the other way round, the same numbers come with the other sign and other rounding.
    EXPECT_NEAR(a.velocity.x, b.velocity.x, 1e-12);
    EXPECT_NEAR(a.velocity.y, b.velocity.y, 1e-12);
    EXPECT_NEAR(a.velocity.z, b.velocity.z, 1e-12);
    EXPECT_NEAR(a.spin.z, b.spin.z, 1e-9);
  }
}

TEST(History, DoesNotDependOnWhichPartnerOwnsThePair) {
  const auto straight = sheared_pair(0.1e-3, 0.4, nullptr), swapped = sheared_pair(0.1e-3, 0.4, nullptr, true);
  for (const std::uint64_t id : {0u, 1u}) {
    EXPECT_NEAR(straight.at(id).velocity.y, swapped.at(id).velocity.y, 1e-12);
    EXPECT_NEAR(straight.at(id).spin.z, swapped.at(id).spin.z, 1e-9);
  }
}

// A block pressed on the floor and pushed sideways below the friction limit stays on its springs, however often lists
// are rebuilt: with history lost at every rebuild it would creep away.
TEST(History, OfAWallContactSurvivesRebuilds) {
  const auto place = [](double skin, std::uint64_t* rebuilds) {
    ModelScene scene = box(0.05, 0.05, 0.05);
    ParticleStore store = spinning_store();
    // A pair lying in the corner of the floor and the left wall, and a stirrer far away that forces rebuilds.
    store.add(0, 0, 0.0005 - 1e-6, 0.01, 0.0005 - 1e-6, 0.5e-3, sphere_mass(0.5e-3));
    const std::size_t stirrer = store.add(7, 0, 0.03, 0.03, 0.03, 0.5e-3, sphere_mass(0.5e-3));
    store.velocity[stirrer] = {0.5, 0.3, 0, store.velocity[stirrer].w};
    store.angular_velocity[0].y = 20;
    store.velocity[0].y = 0.01;
    const ContactModel law = make_law({.stiffness = 500, .damping_ratio = 0.05, .friction = 0.5, .rotation = true});
    EngineOptions o = options(2e-6, 9.81);
    o.gravity[0] = -3;
    o.skin = skin;
    Engine engine(store, scene, law, o);
    engine.advance(3000);
    *rebuilds = engine.report().rebuilds;
    const std::size_t row = row_of(store, 0);
    return std::pair(store.position[row], store.angular_velocity[row]);
  };
  std::uint64_t many = 0, few = 0;
  const auto often = place(0.02e-3, &many), once = place(20e-3, &few);
  EXPECT_GT(many, 100u);
  EXPECT_EQ(few, 1u);
  EXPECT_EQ(often.first.x, once.first.x);
  EXPECT_EQ(often.first.y, once.first.y);
  EXPECT_EQ(often.first.z, once.first.z);
  EXPECT_EQ(often.second.y, once.second.y);
}

// A contact that ended starts again from nothing.
TEST(History, IsForgottenWhenAContactEnds) {
  const auto tangential = [](bool earlier_contact) {
    const ModelScene scene = box(0.05, 0.05, 0.05);
    ParticleStore store = spinning_store();
    add_sphere(store, 0.01, 0.01, 0.01);
    add_sphere(store, 0.01 + 0.98e-3, 0.01, 0.01);
    const ContactModel law = make_law({.stiffness = 1000, .friction = 10, .rotation = true});
    EngineOptions o = options(1e-7);
    o.skin = 1e-3;
    Engine engine(store, scene, law, o);
    if (earlier_contact) {
      store.velocity[0].y = 1;
      engine.advance(20);   // stretches the spring
      store.position[row_of(store, 1)].x += 0.1e-3;
      engine.advance(1);    // parted
    }
    for (std::size_t row = 0; row < 2; ++row) {
      const bool first = store.id[row] == 0;
      store.position[row] = {first ? 0.01 : 0.01 + 0.98e-3, 0.01, 0.01, 0.5e-3};
      store.velocity[row] = {0, first ? 1.0 : 0.0, 0, store.velocity[row].w};
      store.angular_velocity[row] = {0, 0, 0, store.angular_velocity[row].w};
    }
    engine.advance(1);
    EXPECT_EQ(engine.report().contacts, 1u);
    return store.force[row_of(store, 0)].y;
  };
  EXPECT_NE(tangential(false), 0);
  EXPECT_EQ(tangential(true), tangential(false));
}

// A sheared, moving bed: lists rebuilt at every few steps and lists rebuilt never must hold the same springs. Chaos makes
// beds part in time, so the comparison is early and close.
TEST(History, OfAWholeBedDoesNotDependOnTheSkin) {
  const auto bed = [](double skin, std::uint64_t* rebuilds) {
    const ModelScene scene = box(0.012, 0.008, 0.05, {false, true, false});
    ParticleStore store = spinning_store();
    fill_lattice(store, scene, 500, 0.5 * k_diameter, 1.0e-3, 0.03e-3);
    stir(store, 0.2);
    const ContactModel law = make_law({.damping_ratio = 0.1, .friction = 0.5, .rotation = true});
    EngineOptions o = options(2e-6, 9.81);
    o.skin = skin;
    Engine engine(store, scene, law, o);
    engine.advance(400);
    *rebuilds = engine.report().rebuilds;
    std::map<std::uint64_t, Row> out;
    for (std::size_t row = 0; row < store.size(); ++row) out[store.id[row]] = store.velocity[row];
    return out;
  };
  std::uint64_t many = 0, few = 0;
  const auto often = bed(0.01e-3, &many), seldom = bed(0.8e-3, &few);
  EXPECT_GT(many, 20u);
  EXPECT_LT(few, 5u);
  for (const auto& [id, v] : seldom) {
    EXPECT_NEAR(often.at(id).x, v.x, 1e-10);
    EXPECT_NEAR(often.at(id).y, v.y, 1e-10);
    EXPECT_NEAR(often.at(id).z, v.z, 1e-10);
  }
}

}  // namespace
}  // namespace similitude
