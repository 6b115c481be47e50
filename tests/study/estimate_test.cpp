#include "study/estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "series.h"

using namespace similitude;
using similitude::test::autoregressive;

namespace {

Series every_10_ms(std::vector<double> values) { return {.interval = 0.01, .values = std::move(values)}; }

/// 5 + amplitude sin(2 pi f t) + noise.
Series wave(double frequency, double amplitude, double noise, std::size_t length) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  Series series{.interval = 0.01, .values = {}};
  for (std::size_t k = 0; k < length; ++k)
    series.values.push_back(5 + amplitude * std::sin(2 * std::numbers::pi * frequency * 0.01 * static_cast<double>(k)) +
                            noise * normal(random));
  return series;
}

/// In how many of `trials` series of this memory the interval holds the truth.
template <class Measure>
double coverage(double phi, std::size_t length, double truth, Measure measure) {
  constexpr int k_trials = 1000;
  std::mt19937_64 random(42);
  int held = 0;
  for (int t = 0; t < k_trials; ++t) {
    const Estimate e = measure(every_10_ms(autoregressive(phi, length, random)));
    held += e.low <= truth && truth <= e.high;
  }
  return held / static_cast<double>(k_trials);
}

}  // namespace

TEST(Student, QuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(student_two_sided(0.95, 1), 12.706, 1e-3);
  EXPECT_NEAR(student_two_sided(0.95, 9), 2.262, 1e-3);
  EXPECT_NEAR(student_two_sided(0.99, 20), 2.845, 1e-3);
}

TEST(BlockedMean, OfIndependentValuesIsTheTextBooksStandardError) {
  std::mt19937_64 random(1);
  const BlockedMean mean = blocked_mean(autoregressive(0, 20000, random));
  EXPECT_TRUE(mean.plateau);
  EXPECT_NEAR(mean.standard_error, 1 / std::sqrt(20000.0),
              0.1 / std::sqrt(20000.0));  // some 600 blocks: 3 % of scatter
  EXPECT_GT(mean.effective_samples, 16000);
}

TEST(BlockedMean, FindsTheMemoryOfTheSeries) {
  // phi = 0.9: g = 19, so 19000 values are worth 1000.
  std::mt19937_64 random(2);
  const BlockedMean mean = blocked_mean(autoregressive(0.9, 19000, random));
  EXPECT_TRUE(mean.plateau);
  EXPECT_NEAR(mean.effective_samples, 1000, 250);  // some 90 blocks: 15 % of scatter in se^2
  EXPECT_GT(mean.block_length, 2 * 19U);
}

TEST(BlockedMean, ATrendHasNoPlateau) {
  std::vector<double> ramp(500);
  for (std::size_t k = 0; k < ramp.size(); ++k) ramp[k] = static_cast<double>(k);
  const BlockedMean mean = blocked_mean(ramp);
  EXPECT_FALSE(mean.plateau);
  EXPECT_LT(mean.effective_samples, 20);
}

TEST(BlockedMean, AConstantIsKnownExactly) {
  const Estimate mean = mean_of(every_10_ms(std::vector<double>(100, 3.5)));
  EXPECT_EQ(mean.value, 3.5);
  EXPECT_EQ(mean.low, 3.5);
  EXPECT_EQ(mean.high, 3.5);
  EXPECT_FALSE(mean.lower_bound);
}

// 95 % are meant. The least is what 1000 trials of a series with a memory of a fiftieth of its length can give: block
// averages know the memory only roughly, and no method of one series does better (Flyvbjerg & Petersen 1989, section
// III).
TEST(MeanOfSeries, IntervalHoldsTheTruth) {
  EXPECT_NEAR(coverage(0, 400, 0, mean_of), 0.95, 0.025);
  EXPECT_NEAR(coverage(0.8, 2000, 0, mean_of), 0.95, 0.025);
  EXPECT_GT(coverage(0.9, 1000, 0, mean_of), 0.89);
}

TEST(MeanOfSeries, FewIndependentSamplesAreALowerBound) {
  std::mt19937_64 random(3);
  EXPECT_TRUE(mean_of(every_10_ms(autoregressive(0.95, 300, random))).lower_bound);   // g = 39: 8 samples
  EXPECT_FALSE(mean_of(every_10_ms(autoregressive(0.5, 3000, random))).lower_bound);  // g = 3: 1000
}

TEST(MeanOfSeries, TooFewRowsAreAGap) {
  EXPECT_EQ(mean_of(every_10_ms({1, 2, 3})).gap, "fewer than 8 rows in the window of the average: lengthen time.end, or write more of them, e.g. output.monitors: every 5 ms");
}

TEST(FluctuationOfSeries, OfASineIsItsAmplitudeOverRootTwo) {
  const Estimate fluctuation = fluctuation_of(wave(5, 3, 0, 1000));
  EXPECT_NEAR(fluctuation.value, 3 / std::numbers::sqrt2, 0.01);
}

TEST(FluctuationOfSeries, IntervalHoldsTheTruth) { EXPECT_GT(coverage(0.5, 2000, 1, fluctuation_of), 0.91); }

TEST(DominantFrequency, OfASineIsItsFrequency) {
  const Estimate frequency = dominant_frequency_of(wave(5.3, 1, 0.3, 300));
  EXPECT_NEAR(frequency.value, 5.3, 0.1);
  EXPECT_LT(frequency.low, 5.3);
  EXPECT_GT(frequency.high, 5.3);
  EXPECT_NEAR(frequency.half_width(), 1 / 1.5, 0.1);  // [Hz]: a window of 1.5 s
}

TEST(DominantFrequency, ASlowDriftHasNone) {
  std::vector<double> ramp(300);
  for (std::size_t k = 0; k < ramp.size(); ++k) ramp[k] = static_cast<double>(k);
  EXPECT_EQ(dominant_frequency_of(every_10_ms(ramp)).gap,
            "no frequency stands out above the slowest that the window resolves");
}

TEST(EvenSeries, PutsUnevenRowsOnEvenTimes) {
  // Rows of a straight line at uneven times stay on it; what is before the start or empty is passed over.
  const Series series = even_series({0, 1, 2.2, 2.9, 4}, {99, 10, 22, 29, 40}, 0.5);
  EXPECT_DOUBLE_EQ(series.interval, 1);
  ASSERT_EQ(series.values.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(series.values[k], 10 * (1 + static_cast<double>(k)), 1e-12);
}
