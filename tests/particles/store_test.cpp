#include <gtest/gtest.h>

#include "particles/store.h"

namespace similitude {
namespace {

TEST(ParticleStore, HasOnlyTheRowsThatWereAskedFor) {
  ParticleStore plain;
  plain.add(7, 0, 1, 2, 3, 0.5, 2);
  EXPECT_TRUE(plain.angular_velocity.empty());
  EXPECT_TRUE(plain.gas.empty());
  ParticleStore full({.rotation = true, .coupling = true});
  full.add(7, 0, 1, 2, 3, 0.5, 2);
  EXPECT_EQ(full.torque.size(), 1u);
  EXPECT_EQ(full.drag_impulse.size(), 1u);
}

TEST(ParticleStore, AddsAParticleAtRestWithTheInertiaOfASolidSphere) {
  ParticleStore store({.rotation = true, .coupling = false});
  const std::size_t row = store.add(7, 3, 1, 2, 3, 0.5, 2);
  EXPECT_EQ(row, 0u);
  EXPECT_EQ(store.id[0], 7u);
  EXPECT_EQ(store.species[0], 3u);
  EXPECT_EQ(store.position[0].w, 0.5);
  EXPECT_EQ(store.velocity[0].x, 0);
  EXPECT_EQ(store.velocity[0].w, 2);
  EXPECT_DOUBLE_EQ(store.angular_velocity[0].w, 0.4 * 2 * 0.5 * 0.5);
}

TEST(ParticleStore, ReordersEveryColumnAndLeavesRowsOut) {
  ParticleStore store({.rotation = true, .coupling = true});
  for (std::uint32_t n = 0; n < 4; ++n) {
    store.add(10 + n, n, n, 0, 0, 1, 1);
    for (Column<Row>* column : {&store.velocity, &store.force, &store.angular_velocity, &store.torque, &store.gas,
                                &store.stress_force, &store.drag_impulse}) {
      (*column)[n].y = n;
    }
  }
  store.reorder({3, 1, 0});
  ASSERT_EQ(store.size(), 3u);
  const std::array<std::uint32_t, 3> expected{3, 1, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(store.id[k], 10 + expected[k]);
    EXPECT_EQ(store.species[k], expected[k]);
    EXPECT_EQ(store.position[k].x, expected[k]);
    for (const Column<Row>* column : {&store.velocity, &store.force, &store.angular_velocity, &store.torque, &store.gas,
                                      &store.stress_force, &store.drag_impulse}) {
      EXPECT_EQ((*column)[k].y, expected[k]);
    }
  }
}

TEST(ParticleStore, KeepsRowsOnCacheLines) {
  ParticleStore store;
  store.reserve(3);
  store.add(0, 0, 0, 0, 0, 1, 1);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(store.position.data()) % 64, 0u);
  EXPECT_EQ(sizeof(Row), 32u);
}

}  // namespace
}  // namespace similitude
