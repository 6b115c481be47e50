/// Several materials: each pair meets by its own parameters. The shipped spring, compiled in as its plugin is.

#include <stdexcept>

#include <gtest/gtest.h>
#include <omp.h>

#include "beds.h"
#include "bits.h"
#include "scene/material_pairs.h"

extern "C" {
extern const similitude_entry similitude_plugin;
}

namespace similitude {
namespace {
using namespace testing;

struct PairValues {
  double stiffness = 1000, restitution = 0.9, friction = 0;
};

ContactModel spring_of(const std::vector<PairValues>& sets) {
  const similitude_descriptor& spring = *similitude_plugin.descriptors[0];
  std::vector<similitude_value> values;
  for (const PairValues& set : sets) {
    const std::map<std::string, double> given{{"stiffness", set.stiffness}, {"restitution", set.restitution}, {"friction", set.friction}};
    for (std::uint32_t p = 0; p < spring.parameter_count; ++p) {
      const auto it = given.find(spring.parameters[p].name);
      values.push_back({it == given.end() ? spring.parameters[p].default_value : it->second, nullptr});
    }
  }
  similitude_bed bed{};
  bed.struct_size = sizeof bed;
  similitude_status status{};
  const auto count = static_cast<std::uint32_t>(sets.size());
  void* instance = spring.create(nullptr, &bed, values.data(), count, &status);
  if (instance == nullptr) throw std::runtime_error(status.text);
  return ContactModel(spring, instance, count);
}

ModelScene box_of(std::size_t classes, double x, double y, double z) {
  ModelScene scene = box(x, y, z);
  scene.particles.resize(classes);
  return scene;
}

/// A restitution of its own for each of the nine pairs of three materials and the wall.
std::vector<PairValues> nine_pairs(double friction) {
  std::vector<PairValues> sets;
  for (int p = 0; p < 9; ++p) sets.push_back({.restitution = 0.5 + 0.05 * p, .friction = friction});
  return sets;
}

std::size_t add_grain(ParticleStore& store, std::uint32_t species, double x, double y, double z) {
  const double radius = 0.5 * k_diameter;
  return store.add(store.size(), species, x, y, z, radius, sphere_mass(radius));
}

TEST(MaterialPairs, StandInTheOrderOfTheirPlaces) {
  for (std::size_t classes = 1; classes < 6; ++classes) {
    const std::vector<MaterialPair> pairs = material_pairs(classes);
    ASSERT_EQ(pairs.size(), classes * (classes + 3) / 2);
    for (std::size_t place = 0; place < pairs.size(); ++place) {
      EXPECT_EQ(pair_place(classes, pairs[place].first, pairs[place].second), place);
      EXPECT_EQ(pair_place(classes, pairs[place].second, pairs[place].first), place);
    }
  }
}

// All six impacts at once: they lie in one block, and the law sees rows of different pairs in one pack.
TEST(Materials, EachPairOfThreePartsWithItsOwnRestitution) {
  const ModelScene scene = box_of(3, 0.1, 0.1, 0.1);
  ParticleStore store = spinning_store();
  std::vector<std::size_t> place;
  for (std::uint32_t one = 0; one < 3; ++one) {
    for (std::uint32_t other = 0; other < 3; ++other) {
      const double y = 0.02 + 0.003 * static_cast<double>(place.size());
      store.velocity[add_grain(store, one, 0.05 - 0.505 * k_diameter, y, 0.05)].x = 0.2;
      store.velocity[add_grain(store, other, 0.05 + 0.505 * k_diameter, y, 0.05)].x = -0.1;
      place.push_back(pair_place(3, one, other));
    }
  }
  const std::vector<PairValues> sets = nine_pairs(0.3);
  const ContactModel law = spring_of(sets);
  Engine engine(store, scene, law, options(1e-7));
  engine.advance(2500);
  EXPECT_EQ(engine.report().contacts, 0u);   // all have parted
  for (std::size_t n = 0; n < place.size(); ++n) {
    const double parting = store.velocity[row_of(store, 2 * n + 1)].x - store.velocity[row_of(store, 2 * n)].x;
    // Pairs differ by 0.05; the scheme's error at t_c/500 is a tenth of that.
    EXPECT_NEAR(parting / 0.3, sets[place[n]].restitution, 0.005) << n;
  }
}

TEST(Materials, EachMeetsTheWallsAndBafflesWithItsOwnRestitution) {
  ModelScene scene = box_of(3, 0.1, 0.1, 0.1);
  Baffle plate;
  plate.position = 0.05;
  plate.thickness = 1e-3;
  plate.extent = {Interval{0.05, 0.05}, Interval{0, 0.1}, Interval{0, 0.1}};
  scene.baffles.push_back(plate);
  Patch inlet;
  inlet.face = {Axis::z, Side::low};
  inlet.velocity = 1;
  inlet.extent = {Interval{0, 0.05}, Interval{0, 0.1}, Interval{0, 0}};
  scene.patches.push_back(inlet);
  ParticleStore store = spinning_store();
  for (std::uint32_t species = 0; species < 3; ++species) {
    const double y = 0.02 + 0.003 * species;
    store.velocity[add_grain(store, species, 0.505 * k_diameter, y, 0.05)].x = -0.3;               // the left wall
    store.velocity[add_grain(store, species, 0.05 - 1.005 * k_diameter, y, 0.05)].x = 0.3;         // the plate
    store.velocity[add_grain(store, species, 0.03, y, 0.505 * k_diameter)].z = -0.3;               // the inlet
  }
  const std::vector<PairValues> sets = nine_pairs(0.3);
  const ContactModel law = spring_of(sets);
  Engine engine(store, scene, law, options(1e-7));
  engine.advance(2500);
  EXPECT_EQ(engine.report().contacts, 0u);
  for (std::size_t species = 0; species < 3; ++species) {
    const double e = sets[pair_place(3, species, 3)].restitution;
    EXPECT_NEAR(store.velocity[row_of(store, 3 * species)].x, 0.3 * e, 0.3 * 0.005) << species;
    EXPECT_NEAR(store.velocity[row_of(store, 3 * species + 1)].x, -0.3 * e, 0.3 * 0.005) << species;
    EXPECT_NEAR(store.velocity[row_of(store, 3 * species + 2)].z, 0.3 * e, 0.3 * 0.005) << species;
  }
}

/// A stirred bed of three materials whose kinds stand side by side, so that blocks and packs are mixed.
Bits stirred_bed(int threads, const std::vector<PairValues>& sets) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  ModelScene scene = box_of(3, 0.04, 0.012, 0.02);
  scene.periodic[1] = true;
  ParticleStore store = spinning_store();
  fill_lattice(store, scene, 4000, 0.5 * k_diameter, 1.1e-3, 0.02e-3);
  Random random(7);
  for (std::uint32_t& species : store.species) species = static_cast<std::uint32_t>(random.within(0, 3));
  stir(store, 0.5);
  const ContactModel law = spring_of(sets);
  Engine engine(store, scene, law, options(2.5e-6, 9.81));
  engine.advance(1000);
  omp_set_num_threads(before);
  return bits_of(store);
}

TEST(Materials, OfMixedPairsHaveTheSameBitsForOneAndTwoThreads) {
  std::vector<PairValues> sets = nine_pairs(0.3);
  sets[4].friction = 0;   // a pair without friction among those that remember
  sets[7].stiffness = 2000;
  const Bits one = stirred_bed(1, sets);
  EXPECT_EQ(stirred_bed(2, sets), one);
  EXPECT_NE(stirred_bed(1, nine_pairs(0.3)), one);
}

TEST(Materials, ThatAreAllAlikeHaveTheBitsOfOne) {
  const PairValues alike{.restitution = 0.74, .friction = 0.3};
  EXPECT_EQ(stirred_bed(1, std::vector<PairValues>(9, alike)), stirred_bed(1, {alike}));
}

TEST(Materials, AreRefusedUnlessEachPairHasItsSet) {
  ModelScene scene = box_of(2, 0.02, 0.02, 0.02);
  ParticleStore store = spinning_store();
  const ContactModel nine = spring_of(nine_pairs(0.3)), one = spring_of({PairValues{}});
  const auto message = [&](const ContactModel& law) {
    try {
      Engine(store, scene, law, options(1e-6));
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(one), "");
  EXPECT_EQ(message(nine), "the contact law has 9 parameter sets for 5 pairs of materials");
  scene.models.contact_pairs.resize(5);
  EXPECT_EQ(message(one), "the scene has contact parameters for each pair of materials, the law was made without them");
}

}  // namespace
}  // namespace similitude
