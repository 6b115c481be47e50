#include "output/progress.h"

#include <gmock/gmock.h>

#include <sstream>

using namespace similitude;

namespace {

/// A clock that stands until it is told.
struct Bench {
  double now = 100;
  std::ostringstream out;
  Progress progress;
  Bench(Progress::Screen screen, double end) : progress(out, screen, end, [this] { return now; }) {}

  std::string after(double wall, const ProgressState& state) {
    now = 100 + wall;
    out.str("");
    progress.update(state);
    return out.str();
  }
};

ProgressState at(double time) {
  return {.time = time,
          .particle_steps = static_cast<std::uint64_t>(time * 1e8),
          .particles = 20'000,
          .largest_overlap = 0.004};
}

}  // namespace

TEST(Progress, PrintsAPlainLineEveryTenPercent) {
  Bench bench(Progress::Screen::plain, 2);
  EXPECT_EQ(bench.after(0, at(0)), "");
  EXPECT_EQ(bench.after(1, at(0.1)), "");
  EXPECT_EQ(bench.after(2, at(0.2)),
            "0.2 of 2 s  10 %  ETA 18 s  10 M particle-steps/s  20000 particles  overlap 0.4 % of d\n");
  EXPECT_EQ(bench.after(3, at(0.3)), "");
}

TEST(Progress, PrintsAPlainLineEveryFiveSecondsOfASlowRun) {
  Bench bench(Progress::Screen::plain, 1000);
  bench.after(0, at(0));
  EXPECT_EQ(bench.after(4.9, at(0.1)), "");
  EXPECT_NE(bench.after(5, at(0.1)), "");
  EXPECT_EQ(bench.after(9.9, at(0.2)), "");
  EXPECT_NE(bench.after(10, at(0.2)), "");
}

TEST(Progress, PrintsALineAMinuteInARunOfHours) {
  Bench bench(Progress::Screen::plain, 1000);
  bench.after(0, at(0));
  EXPECT_THAT(bench.after(7200, at(1)), testing::HasSubstr("ETA 1998 h 0 min"));
  EXPECT_EQ(bench.after(7259, at(1.01)), "");
  EXPECT_NE(bench.after(7260, at(1.01)), "");
}

TEST(Progress, DrawsABarInPlaceFiveTimesASecond) {
  Bench bench(Progress::Screen::terminal, 2);
  bench.after(0, at(0));
  EXPECT_EQ(bench.after(0.1, at(0.25)), "");
  EXPECT_EQ(
      bench.after(10, at(0.5)),
      "\r[#####---------------] 0.5 of 2 s  25 %  ETA 30 s  5 M particle-steps/s  20000 particles  overlap 0.4 % of d");
}

TEST(Progress, WipesTheRestOfALongerLine) {
  Bench bench(Progress::Screen::terminal, 2);
  bench.after(0, at(0));
  const std::string longer =
      bench.after(10, {.time = 0.5, .particle_steps = 0, .particles = 1'000'000, .largest_overlap = 0});
  const std::string shorter = bench.after(20, {.time = 0.5, .particle_steps = 0, .particles = 1, .largest_overlap = 0});
  EXPECT_GE(shorter.size(), longer.size());
}

TEST(Progress, EstimatesFromWhereThisRunBegan) {
  Bench bench(Progress::Screen::plain, 10);
  bench.after(0, at(8));  // resumed
  EXPECT_THAT(bench.after(6, at(9)), testing::HasSubstr("9 of 10 s  90 %  ETA 6 s"));
}

TEST(Progress, LeavesTheLastStateStanding) {
  Bench bench(Progress::Screen::terminal, 2);
  bench.after(0, at(0));
  bench.now = 110;
  bench.out.str("");
  bench.progress.finish(at(2));
  EXPECT_EQ(bench.out.str(),
            "\r[####################] 2 of 2 s  100 %  20 M particle-steps/s  20000 particles  overlap 0.4 % of d\n");
}
