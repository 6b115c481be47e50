#include "study/frontier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace similitude;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

namespace {

Estimate about(double value, double reach) {
  Estimate e = exactly(value);
  e.low = std::max(0.0, value - reach);
  e.high = value + reach;
  return e;
}

Contender contender(const std::string& name, double wall, const Estimate& error) { return {name, wall, error, false}; }
Contender reference(const std::string& name, double wall) { return {name, wall, exactly(0), true}; }

/// The exact bed and three laws: one good and cheap, one cheaper and bad, one that is beaten in both.
std::vector<Contender> clear_study() {
  return {reference("exact", 400), contender("link", 100, about(0.06, 0.01)),
          contender("parcel", 40, about(0.30, 0.03)), contender("glicksman", 120, about(0.20, 0.02))};
}

}  // namespace

TEST(Frontier, HoldsWhatNoOtherBeatsInBoth) {
  const Frontier frontier = frontier_of(clear_study());
  EXPECT_THAT(frontier.cases, ElementsAre("parcel", "link", "exact"));
  ASSERT_EQ(frontier.steps.size(), 2U);
  EXPECT_EQ(frontier.steps[0].from, "parcel");
  EXPECT_EQ(frontier.steps[0].to, "link");
  EXPECT_DOUBLE_EQ(frontier.steps[0].time_ratio, 2.5);
  EXPECT_NEAR(frontier.steps[0].error_change, -0.24, 1e-12);
  EXPECT_TRUE(frontier.steps[0].distinguishable);
}

TEST(Frontier, StepIntoTheNoiseIsSaidToBeNotDistinguishable) {
  const Frontier frontier =
      frontier_of({contender("coarse", 10, about(0.06, 0.04)), contender("fine", 100, about(0.05, 0.04))});
  ASSERT_EQ(frontier.steps.size(), 1U);
  EXPECT_FALSE(frontier.steps[0].distinguishable);
}

TEST(Frontier, CasesWithoutTimeOrErrorStandOutside) {
  const Frontier frontier = frontier_of(
      {contender("failed", Estimate::k_unknown, gap("it was not run")), contender("done", 10, about(0.1, 0.01))});
  EXPECT_THAT(frontier.cases, ElementsAre("done"));
  EXPECT_THAT(frontier.steps, IsEmpty());
}

TEST(Frontier, OfTwoTwinsBothStay) {
  EXPECT_THAT(frontier_of({contender("a", 10, about(0.1, 0.01)), contender("b", 10, about(0.1, 0.01))}).cases,
              ElementsAre("a", "b"));
}

TEST(Indistinguishable, AreThoseWhoseIntervalsOverlap) {
  EXPECT_THAT(indistinguishable({reference("exact", 400), contender("link", 100, about(0.06, 0.04)),
                                 contender("ut", 150, about(0.04, 0.04)), contender("parcel", 40, about(0.30, 0.03))}),
              ElementsAre(Pair("link", "ut")));
}

TEST(Advice, NamesTheFastestOfTheBest) {
  EXPECT_EQ(advice(clear_study(), "profile error"),
            "link is 4 x faster than exact; its profile error, 6 ± 1 %, is the smallest; parcel is 2.5 x faster still, "
            "but off by 30 ± 3 %.");
}

TEST(Advice, NoiseHidesTheDifference) {
  EXPECT_EQ(advice({reference("exact", 400), contender("link", 100, about(0.06, 0.04)),
                    contender("ut", 150, about(0.05, 0.03))},
                   "profile error"),
            "link is 4 x faster than exact; its profile error, 6 ± 4 %, cannot be told from ut's, 5 ± 3 %, which takes "
            "1.5 x as long.");
}

TEST(Advice, AnErrorWithinTheNoiseOfNoneIsSaidToBeSo) {
  EXPECT_EQ(advice({reference("exact", 400), contender("link", 100, about(0.02, 0.03)),
                    contender("ut", 150, about(0.01, 0.03))},
                   "profile error"),
            "link is 4 x faster than exact; its profile error, 0 to 5 %, cannot be told from zero.");
}

TEST(Advice, OfOneWinnerInBothSaysSo) {
  EXPECT_EQ(advice({reference("exact", 400), contender("link", 100, about(0.06, 0.01)),
                    contender("ut", 150, about(0.2, 0.01))},
                   "profile error"),
            "link is 4 x faster than exact; its profile error, 6 ± 1 %, is also the smallest.");
}

TEST(Advice, IntervalThatIsALowerBoundIsNamedOne) {
  Estimate error = about(0.06, 0.01);
  error.lower_bound = true;
  EXPECT_EQ(advice({reference("exact", 400), contender("link", 100, error)}, "profile error"),
            "link is 4 x faster than exact; its profile error, 6 ± at least 1 %, has nothing to be compared with.");
}

TEST(Advice, AnErrorWithoutNoiseHasNoInterval) {
  EXPECT_EQ(advice({reference("fine", 400), contender("coarse", 100, exactly(0.033)), contender("middle", 200, exactly(0.016))},
                   "height error"),
            "middle is 2 x faster than fine; its height error, 1.6 %, is the smallest; coarse is 2 x faster still, but off by "
            "3.3 %.");
}

TEST(Advice, WhereNothingIsFasterTheReferenceStays) {
  EXPECT_EQ(advice({reference("coarse", 10), contender("fine", 25, about(0.1, 0.02))}, "bed height error"),
            "Nothing here beats coarse: the fastest other case, fine, takes 2.5 x as long, and its bed height error is "
            "10 ± 2 %.");
}

TEST(Advice, AgainstMeasuredDataTheSlowestCaseIsTheMeasureOfSpeed) {
  EXPECT_EQ(
      advice({contender("gidaspow", 10, about(0.1, 0.02)), contender("tang", 20, about(0.3, 0.02))}, "profile error"),
      "gidaspow is 2 x faster than tang; its profile error, 10 ± 2 %, is also the smallest.");
}

// As in the table beside it.
TEST(Advice, CountsTwoDigitsOfLargeNumbersToo) {
  EXPECT_EQ(advice({reference("exact", 1234), contender("parcel", 10, about(1.234, 0.1))}, "profile error"),
            "parcel is 120 x faster than exact; its profile error, 120 ± 10 %, has nothing to be compared with.");
}

TEST(Advice, WithoutACaseToJudgeSaysSo) {
  EXPECT_EQ(
      advice({reference("exact", 400), contender("link", Estimate::k_unknown, gap("it was not run"))}, "profile error"),
      "No case has both a wall time and a profile error: there is nothing to advise.");
}
