#include <gtest/gtest.h>
#include <omp.h>

#include "beds.h"
#include "bits.h"

namespace similitude {
namespace {
using namespace testing;

struct Restore {
  int threads = omp_get_max_threads();
  ~Restore() { omp_set_num_threads(threads); }
};

/// What MovingBed comes to.
Bits moving_bed(int threads, std::int64_t at_a_time, std::uint64_t* rebuilds = nullptr, std::uint64_t* removed = nullptr) {
  const Restore restore;
  omp_set_num_threads(threads);
  const MovingBed bed({.damping_ratio = 0.1, .friction = 0.3, .rotation = true});
  ParticleStore store = bed.filled();
  Engine engine(store, bed.scene, bed.law, options(2.5e-6, 9.81));
  for (std::int64_t done = 0; done < 2000; done += at_a_time) engine.advance(at_a_time);
  if (rebuilds) *rebuilds = engine.report().rebuilds;
  if (removed) *removed = engine.report().removed;
  return bits_of(store);
}

TEST(SameBits, ForOneTwoAndThreeThreads) {
  std::uint64_t rebuilds = 0, removed = 0;
  const Bits one = moving_bed(1, 2000, &rebuilds, &removed);
  EXPECT_GT(rebuilds, 20u);
  EXPECT_GT(removed, 0u);
  EXPECT_EQ(moving_bed(2, 2000), one);
  EXPECT_EQ(moving_bed(3, 2000), one);
}

TEST(SameBits, HoweverManyStepsAreAskedForAtATime) { EXPECT_EQ(moving_bed(2, 10), moving_bed(1, 2000)); }

// Lengths / 4, times / 2, masses / 64 and stiffness / 16 are powers of two: the scaled bed computes the same bits.
TEST(SameBits, ForABedScaledByPowersOfTwo) {
  const auto bed = [](double length) {
    const double time = std::sqrt(length), mass = length * length * length, speed = length / time;
    const double d = length * k_diameter;
    ModelScene scene = box(0.02 * length, 0.01 * length, 0.03 * length, {false, true, false});
    ParticleStore store = spinning_store();
    fill_lattice(store, scene, 1000, 0.5 * d, 1.1 * d, 0.02 * d);
    stir(store, 0.3 * speed);
    for (std::size_t row = 0; row < store.size(); ++row) {
      store.velocity[row].w = mass * sphere_mass(0.5 * k_diameter);
      store.angular_velocity[row].w = 0.4 * store.velocity[row].w * (0.5 * d) * (0.5 * d);
    }
    const ContactModel law =
        make_law({.stiffness = 1000 * mass / (time * time), .damping_ratio = 0.1, .friction = 0.3, .rotation = true});
    Engine engine(store, scene, law, options(2e-6 * time, 9.81));
    engine.advance(1000);
    for (std::size_t row = 0; row < store.size(); ++row) {
      Row &x = store.position[row], &v = store.velocity[row], &w = store.angular_velocity[row];
      x = {x.x / length, x.y / length, x.z / length, 0};
      v = {v.x / speed, v.y / speed, v.z / speed, 0};
      w = {w.x * time, w.y * time, w.z * time, 0};
    }
    return bits_of(store);
  };
  EXPECT_EQ(bed(0.25), bed(1));
}

}  // namespace
}  // namespace similitude
