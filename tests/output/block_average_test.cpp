#include "output/block_average.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../study/series.h"

using namespace similitude;
using similitude::test::autoregressive;

namespace {

BlockAverage average_of(const std::vector<double>& series) {
  BlockAverage average;
  for (const double value : series) average.add(value, 1);
  return average;
}

/// Exact variance of the mean of n values of that series.
double variance_of_mean(double phi, std::size_t n) {
  const auto count = static_cast<double>(n);
  return ((1 + phi) / (1 - phi) - 2 * phi * (1 - std::pow(phi, count)) / (count * (1 - phi) * (1 - phi))) / count;
}

}  // namespace

TEST(BlockAverage, OfFourValuesIsTheTextBookStandardError) {
  // mean 2.5, sum of squares 5, se = sqrt(5 / 3 / 4)
  const BlockAverage average = average_of({1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(average.mean(), 2.5);
  EXPECT_DOUBLE_EQ(average.effective_blocks(), 4);
  EXPECT_DOUBLE_EQ(average.standard_error(), std::sqrt(5.0 / 12));
}

TEST(BlockAverage, HasNoMeanOfNothingAndNoErrorOfOneValue) {
  EXPECT_TRUE(std::isnan(BlockAverage().mean()));
  EXPECT_EQ(average_of({7}).mean(), 7);
  EXPECT_TRUE(std::isnan(average_of({7}).standard_error()));
}

TEST(BlockAverage, JoinsNeighboursWhenThereAreTwentyBlocks) {
  std::vector<double> series(20);
  for (std::size_t k = 0; k < 20; ++k) series[k] = static_cast<double>(k);
  const BlockAverage average = average_of(series);
  EXPECT_EQ(average.block_length(), 2u);
  EXPECT_DOUBLE_EQ(average.effective_blocks(), 10);
  // Ten block means 0.5, 2.5, …, 18.5: variance 4 * (100 - 1) / 12 * 10 / 9 = 36.67, se = sqrt(3.667)
  EXPECT_DOUBLE_EQ(average.mean(), 9.5);
  EXPECT_NEAR(average.standard_error(), std::sqrt(330.0 / 90), 1e-14);
}

TEST(BlockAverage, KeepsTenToNineteenBlocksHoweverLongTheWindow) {
  BlockAverage average;
  for (int k = 1; k <= 5000; ++k) {
    average.add(1, 1);
    if (k < 10) continue;
    EXPECT_GE(average.effective_blocks(), 10);
    EXPECT_LE(average.effective_blocks(), 19);
  }
  EXPECT_EQ(average.mean(), 1);
  EXPECT_EQ(average.standard_error(), 0);
}

TEST(BlockAverage, CountsValuesThatDoNotFillABlockInTheMean) {
  std::vector<double> series(21, 0.0);
  series[20] = 21;
  EXPECT_DOUBLE_EQ(average_of(series).mean(), 1);
}

TEST(BlockAverage, WeighsValuesByMass) {
  BlockAverage average;
  average.add(3 * 2.0, 3);
  average.add(1 * 6.0, 1);
  EXPECT_DOUBLE_EQ(average.mean(), 3);
  // (3 + 1)^2 / (9 + 1)
  EXPECT_DOUBLE_EQ(average.effective_blocks(), 1.6);
}

TEST(BlockAverage, GivesNoErrorWhereOneBlockSawAlmostEverything) {
  BlockAverage average;
  average.add(100, 100);
  for (int k = 0; k < 9; ++k) average.add(0, 0);
  EXPECT_EQ(average.mean(), 1);
  EXPECT_TRUE(std::isnan(average.standard_error()));
}

// 2000 series of 2000 uncorrelated values: mean of se^2 is 1/2000 to 2 % (19 to 10 blocks: spread sqrt(2/9/2000) = 1
// %).
TEST(BlockAverage, FindsTheErrorOfAnUncorrelatedSeries) {
  std::mt19937_64 random(1);
  double squares = 0;
  for (int k = 0; k < 2000; ++k) squares += std::pow(average_of(autoregressive(0, 2000, random)).standard_error(), 2);
  EXPECT_NEAR(squares / 2000 * 2000, 1, 0.03);  // three spreads
}

// Correlation time (1+phi)/(1-phi) = 19 values against blocks of 256: the blocks themselves are correlated by
// 2 phi/(1-phi^2)/256 = 4 %, which lowers se^2 by about as much. The naive error would be 19 times too small in se^2.
TEST(BlockAverage, FindsTheErrorOfAnAutoregressiveSeries) {
  constexpr double phi = 0.9;
  constexpr std::size_t length = 4000;
  std::mt19937_64 random(2);
  double squares = 0, mean_squares = 0;
  for (int k = 0; k < 2000; ++k) {
    const BlockAverage average = average_of(autoregressive(phi, length, random));
    squares += std::pow(average.standard_error(), 2);
    mean_squares += std::pow(average.mean(), 2);
  }
  const double exact = variance_of_mean(phi, length);
  EXPECT_NEAR(mean_squares / 2000 / exact, 1, 0.1);  // three times sqrt(2/2000): the series is what it should be
  EXPECT_NEAR(squares / 2000 / exact, 1, 0.08);      // 4 % bias and three spreads of 1.3 %
}

// An interval of +-2.2 standard errors (Student, about 11 to 18 degrees of freedom) holds the true mean in 95 % of
// cases.
TEST(BlockAverage, CoversTheTrueMeanAsOftenAsItClaims) {
  std::mt19937_64 random(3);
  int covered = 0;
  for (int k = 0; k < 2000; ++k) {
    const BlockAverage average = average_of(autoregressive(0.9, 4000, random));
    covered += std::abs(average.mean()) < 2.16 * average.standard_error();
  }
  EXPECT_NEAR(covered / 2000.0, 0.95, 0.02);
}

// Weights that fluctuate with the value: the variance of a ratio of means by the delta method, here with a value equal
// to the weight: R = E[w^2]/E[w], var = E[(w^2 - R w)^2] / (n E[w]^2). For w uniform in (0, 1): R = 2/3.
TEST(BlockAverage, FindsTheErrorOfARatio) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform;
  constexpr int length = 1000, series = 2000;
  double squares = 0, mean = 0;
  for (int k = 0; k < series; ++k) {
    BlockAverage average;
    for (int i = 0; i < length; ++i) {
      const double w = uniform(random);
      average.add(w * w, w);
    }
    squares += std::pow(average.standard_error(), 2);
    mean += average.mean();
  }
  // E[w^4] - 2 R E[w^3] + R^2 E[w^2] = 1/5 - 1/3 + 4/27 = 2/135; over n E[w]^2 = n/4
  const double exact = 2.0 / 135 * 4 / length;
  EXPECT_NEAR(mean / series, 2.0 / 3, 1e-3);
  EXPECT_NEAR(squares / series / exact, 1, 0.04);
}
