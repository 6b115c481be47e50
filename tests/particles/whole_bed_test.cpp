#include <gtest/gtest.h>

#include "beds.h"

namespace similitude {
namespace {
using namespace testing;

struct Bed {
  ModelScene scene = box(0.02, 0.01, 0.05);
  ParticleStore store = spinning_store();
  ContactModel law = make_law({.damping_ratio = 0.1, .friction = 0.3, .rotation = true});
  Bed() {
    fill_lattice(store, scene, 1000, 0.5 * k_diameter, 1.1e-3, 0.02e-3);
    stir(store, 0.2);
  }
};

TEST(WholeBed, ReportsWhatItDid) {
  Bed bed;
  Engine engine(bed.store, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.advance(500);
  EXPECT_EQ(engine.report().particle_steps, 500'000u);
  EXPECT_GE(engine.report().rebuilds, 2u);
  EXPECT_GT(engine.report().contacts, 0u);
  double fastest = 0;
  for (const Row& v : bed.store.velocity) fastest = std::max(fastest, std::hypot(v.x, v.y, v.z));
  EXPECT_DOUBLE_EQ(engine.report().largest_speed, fastest);
}

// A cubic metre has half a million bricks of these cells, at four bytes each for who is where. Lists themselves belong to bricks
// with particles: a dozen here, of some kilobytes for their cells.
TEST(WholeBed, TakesMemoryForItsParticlesAndNotForEmptySpace) {
  const ModelScene scene = box(1, 1, 1);
  ParticleStore store = spinning_store();
  fill_lattice(store, scene, 100, 0.5 * k_diameter, 1.1e-3, 0.02e-3);
  const ContactModel law = make_law({.damping_ratio = 0.1, .friction = 0.3, .rotation = true});
  Engine engine(store, scene, law, options(2.5e-6, 9.81));
  engine.advance(1);
  EXPECT_LT(engine.list_bytes(), 4'000'000u);
}

TEST(WholeBed, NamesItsStagesAndTheirTimes) {
  Bed bed;
  Engine engine(bed.store, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.advance(200);
  std::vector<std::string> names;
  for (const StageTime& stage : engine.stage_times()) {
    names.push_back(stage.name);
    EXPECT_GE(stage.seconds, 0);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"neighbour list", "contacts", "walls", "exchange", "integrate",
                                             "waiting for threads"}));
  EXPECT_GT(engine.stage_times()[1].seconds, 0);
  EXPECT_EQ(engine.passes()[1], "contacts (test_spring, 3 history values, with rotation)");
  EXPECT_EQ(engine.passes()[2], "walls (6 surfaces)");
}

TEST(WholeBed, ALawWithoutHistoryKeepsNone) {
  Bed bed;
  const ContactModel smooth = make_law({.damping_ratio = 0.1});
  ParticleStore store;
  fill_lattice(store, bed.scene, 1000, 0.5 * k_diameter, 1.0e-3, 0.02e-3);
  Engine engine(store, bed.scene, smooth, options(2.5e-6, 9.81));
  engine.advance(100);
  EXPECT_LT(engine.history_bytes(), 10'000u);   // an index, no springs
  EXPECT_GT(engine.list_bytes(), 0u);
  EXPECT_EQ(engine.passes()[1], "contacts (test_spring, 0 history values, without rotation)");
}

TEST(WholeBed, ParticlesMayBeAddedBetweenAdvances) {
  Bed bed;
  Engine engine(bed.store, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.advance(100);
  bed.store.add(5000, 0, 0.01, 0.005, 0.04, 0.5e-3, sphere_mass(0.5e-3));
  engine.advance(100);
  EXPECT_EQ(bed.store.size(), 1001u);
  const std::size_t row = row_of(bed.store, 5000);
  EXPECT_NEAR(bed.store.velocity[row].z, -9.81 * 100 * 2.5e-6, 1e-15);
}

// Whoever moves particles between advances must not meet an old list.
TEST(WholeBed, ParticlesMayBeMovedBetweenAdvances) {
  const ModelScene scene = box(0.02, 0.02, 0.02);
  ParticleStore store;
  add_sphere(store, 0.002, 0.002, 0.002);
  add_sphere(store, 0.018, 0.018, 0.018);
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-6));
  engine.advance(1);
  EXPECT_EQ(engine.report().contacts, 0u);
  store.position[row_of(store, 1)] = {0.0029, 0.002, 0.002, 0.5e-3};
  engine.advance(1);
  EXPECT_EQ(engine.report().contacts, 1u);
}

}  // namespace
}  // namespace similitude
