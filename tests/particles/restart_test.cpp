#include <bit>

#include <gtest/gtest.h>
#include <omp.h>

#include "beds.h"

namespace similitude {
namespace {
using namespace testing;

struct Threads {
  int before = omp_get_max_threads();
  explicit Threads(int wanted) { omp_set_num_threads(wanted); }
  ~Threads() { omp_set_num_threads(before); }
};

/// Everything that may tell two beds apart: rows in their order, and the engine's own memory.
struct Bits {
  std::vector<std::uint64_t> rows, history;
  std::vector<std::uint32_t> touching;
  std::uint64_t rebuilds = 0, removed = 0, contacts = 0;
  std::uint64_t contact_work = 0;
  bool operator==(const Bits&) const = default;
};

void add(std::vector<std::uint64_t>& bits, const Column<Row>& rows) {
  for (const Row& r : rows) {
    for (const double number : {r.x, r.y, r.z, r.w}) bits.push_back(std::bit_cast<std::uint64_t>(number));
  }
}

Bits bits_of(const ParticleStore& store, const Engine& engine) {
  EngineState state;
  engine.save(state);
  Bits bits;
  add(bits.rows, store.position);
  add(bits.rows, store.velocity);
  add(bits.rows, store.angular_velocity);
  add(bits.rows, state.reference);
  for (const std::uint64_t id : store.id) bits.rows.push_back(id);
  add(bits.history, state.touching.history);
  bits.touching = state.touching.place;
  bits.rebuilds = state.report.rebuilds;
  bits.removed = state.report.removed;
  bits.contacts = state.report.contacts;
  bits.contact_work = std::bit_cast<std::uint64_t>(state.report.budget.contact_work);
  return bits;
}

constexpr int k_before = 611, k_after = 500;   // sub-steps; lists are some steps old in between

Bits undisturbed(const MovingBed& bed) {
  ParticleStore store = bed.filled();
  Engine engine(store, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.advance(k_before);
  engine.advance(k_after);
  EXPECT_GT(engine.report().rebuilds, 10u);
  return bits_of(store, engine);
}

Bits restarted(const MovingBed& bed, int threads_after) {
  ParticleStore saved = spinning_store();
  EngineState state;
  {
    ParticleStore store = bed.filled();
    Engine engine(store, bed.scene, bed.law, options(2.5e-6, 9.81));
    engine.advance(k_before);
    engine.save(state);
    saved.copy_rows(store);
  }
  EXPECT_GT(state.touching.place.size(), 100u);
  const Threads threads(threads_after);
  Engine engine(saved, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.restore(state);
  engine.advance(k_after);
  return bits_of(saved, engine);
}

TEST(Restart, GoesOnWithTheSameBitsUnderALawWithHistory) {
  const MovingBed bed({.damping_ratio = 0.1, .friction = 0.3, .rotation = true});
  const Bits expected = undisturbed(bed);
  EXPECT_FALSE(expected.history.empty());
  EXPECT_GT(expected.removed, 0u);
  EXPECT_EQ(restarted(bed, 1), expected);
  EXPECT_EQ(restarted(bed, 3), expected);
}

TEST(Restart, GoesOnWithTheSameBitsUnderALawWithoutHistory) {
  const MovingBed bed({.damping_ratio = 0.1});
  const Bits expected = undisturbed(bed);
  EXPECT_TRUE(expected.history.empty());
  EXPECT_EQ(restarted(bed, 2), expected);
}

TEST(Restart, BeforeTheFirstStepIsAFreshStart) {
  const MovingBed bed({.damping_ratio = 0.1, .friction = 0.3, .rotation = true});
  ParticleStore store = bed.filled();
  EngineState state;
  Engine engine(store, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.save(state);
  EXPECT_FALSE(state.listed);
  engine.advance(300);   // dirt that restore() must not be led by
  store.copy_rows(bed.filled());
  engine.restore(state);
  engine.advance(k_before);
  engine.advance(k_after);
  EXPECT_EQ(bits_of(store, engine), undisturbed(bed));
}

TEST(Restart, InTheSameEngineGoesBackInTime) {
  const MovingBed bed({.damping_ratio = 0.1, .friction = 0.3, .rotation = true});
  ParticleStore store = bed.filled(), then = spinning_store();
  EngineState state;
  Engine engine(store, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.advance(k_before);
  engine.save(state);
  then.copy_rows(store);
  engine.advance(900);
  store.copy_rows(then);
  engine.restore(state);
  engine.advance(k_after);
  EXPECT_EQ(bits_of(store, engine), undisturbed(bed));
}

TEST(Restart, RefusesRowsInAnotherOrder) {
  const MovingBed bed({.damping_ratio = 0.1, .friction = 0.3, .rotation = true});
  ParticleStore store = bed.filled();
  EngineState state;
  Engine engine(store, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.advance(k_before);
  engine.save(state);
  std::swap(state.reference[0], state.reference[1000]);
  EXPECT_THROW(engine.restore(state), std::invalid_argument);
}

TEST(Restart, RefusesAContactThatIsNotInTheLists) {
  const MovingBed bed({.damping_ratio = 0.1, .friction = 0.3, .rotation = true});
  ParticleStore store = bed.filled();
  EngineState state;
  Engine engine(store, bed.scene, bed.law, options(2.5e-6, 9.81));
  engine.advance(k_before);
  engine.save(state);
  ++state.touching.partner[7];
  EXPECT_THROW(engine.restore(state), std::invalid_argument);
}

}  // namespace
}  // namespace similitude
