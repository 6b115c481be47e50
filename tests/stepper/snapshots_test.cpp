#include <gtest/gtest.h>

#include <memory>
#include <new>

#include "stepper/checkpoints.h"

namespace similitude::test {

TEST(Snapshots, KeepTheLastCopyWhenThereIsNoMemoryForTheNext) {
  Snapshots snapshots;
  for (const double wall_s : {1.0, 2.0}) snapshots.take([&](RunState& state) { state.wall_s = wall_s; });
  EXPECT_THROW(snapshots.take([](RunState& state) {
    state.wall_s = 3;
    throw std::bad_alloc();
  }),
               std::bad_alloc);
  EXPECT_EQ(snapshots.last()->wall_s, 2);
}

TEST(Snapshots, LeaveACopyAloneThatIsStillBeingWritten) {
  Snapshots snapshots;
  const auto take = [&](double wall_s) { snapshots.take([&](RunState& state) { state.wall_s = wall_s; }); };
  take(1);
  const std::shared_ptr<const RunState> held = snapshots.last();
  take(2);
  take(3);
  EXPECT_EQ(held->wall_s, 1);
  EXPECT_EQ(snapshots.last()->wall_s, 3);
}

}  // namespace similitude::test
