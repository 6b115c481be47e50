#include "study/profile_error.h"

#include <gtest/gtest.h>

#include <functional>

#include "output/block_average.h"
#include "series.h"

using namespace similitude;
using similitude::test::autoregressive;

namespace {

constexpr std::size_t k_bins = 15;

/// A profile of one height as a run would leave it: `truth` of a bin plus noise that remembers, part of it common to
/// all bins.
Profile sampled(const std::function<double(double)>& truth, double noise, double common, std::mt19937_64& random,
                double z = 0.1) {
  constexpr std::size_t k_instants = 1900;
  constexpr double k_memory = 0.8;
  const std::vector<double> shared = autoregressive(k_memory, k_instants, random);
  Profile profile{.sampler = "vertical_velocity [m/s]", .bins = {}};
  for (std::size_t i = 0; i < k_bins; ++i) {
    const double x = 0.005 * (static_cast<double>(i) + 0.5);
    const std::vector<double> own = autoregressive(k_memory, k_instants, random);
    BlockAverage average;
    for (std::size_t t = 0; t < k_instants; ++t)
      average.add(truth(x) + noise * (std::sqrt(common) * shared[t] + std::sqrt(1 - common) * own[t]), 1);
    ProfileBin bin{.x = x,
                   .z = z,
                   .mean = average.mean(),
                   .standard_error = average.standard_error(),
                   .blocks = average.effective_blocks(),
                   .in_blocks = {}};
    for (const auto& block : average.blocks()) bin.in_blocks.push_back({block.weighted, block.weight});
    profile.bins.push_back(bin);
  }
  return profile;
}

double parabola(double x) { return 1 - 400 * (x - 0.0375) * (x - 0.0375); }  // largest: 1
double lower_parabola(double x) { return parabola(x) - 0.1; }

Profile measured(std::vector<ProfileBin> bins) {
  return {.sampler = "vertical_velocity [m/s]", .bins = std::move(bins), .measured = true};
}

Profile exact(const std::function<double(double)>& truth) {
  std::vector<ProfileBin> bins;
  for (std::size_t i = 0; i < k_bins; ++i) {
    const double x = 0.005 * (static_cast<double>(i) + 0.5);
    bins.push_back({.x = x, .z = 0.1, .mean = truth(x), .standard_error = 0, .blocks = 0, .in_blocks = {}});
  }
  return measured(std::move(bins));
}

}  // namespace

TEST(ProfileError, OfAShiftIsTheShiftOverTheReferencesLargest) {
  const ProfileError error = profile_error(exact(lower_parabola), exact(parabola));
  EXPECT_NEAR(error.l2.value, 0.1, 1e-12);
  EXPECT_NEAR(error.maximum.value, 0.1, 1e-12);
  ASSERT_EQ(error.heights.size(), 1U);
  EXPECT_NEAR(error.heights[0].difference.value, -0.1, 1e-12);  // the profile is low
  EXPECT_EQ(error.bins, k_bins);
}

TEST(ProfileError, IsNormalisedByTheReferenceNotByTheProfile) {
  const ProfileError error = profile_error(exact([](double) { return 3.0; }), exact([](double) { return 2.0; }));
  EXPECT_NEAR(error.l2.value, 0.5, 1e-12);
}

TEST(ProfileError, ComparesAtTheReferencesPlaces) {
  // Measured halfway between two bins of a straight line, and beyond the last bin's centre.
  const ProfileError error = profile_error(
      exact([](double x) { return x; }),
      measured({{.x = 0.010, .z = 0.1, .mean = 0.010, .standard_error = 0, .blocks = 0, .in_blocks = {}},
                {.x = 0.090, .z = 0.1, .mean = 0.090, .standard_error = 0, .blocks = 0, .in_blocks = {}}}));
  EXPECT_EQ(error.bins, 1U);
  EXPECT_EQ(error.left_out, 1U);
  EXPECT_NEAR(error.l2.value, 0, 1e-12);
}

TEST(ProfileError, BinsSeenTooSeldomAreLeftOut) {
  std::mt19937_64 random(1);
  Profile profile = sampled(parabola, 0.1, 0, random);
  profile.bins[3].blocks = 4;
  profile.bins[5].mean = Estimate::k_unknown;
  const ProfileError error = profile_error(profile, sampled(parabola, 0.1, 0, random));
  EXPECT_EQ(error.left_out, 2U);
  EXPECT_EQ(error.bins, k_bins - 2);
}

TEST(ProfileError, WithNothingToCompareIsAGap) {
  Profile empty = exact(parabola);
  for (ProfileBin& bin : empty.bins) bin.mean = Estimate::k_unknown;
  EXPECT_EQ(profile_error(empty, exact(parabola)).l2.gap, "no bin was seen long enough on both sides");
}

// Noise alone must not look like an error, whether neighbouring bins move together or not.
TEST(ProfileError, TwoSamplesOfOneBedCannotBeToldApart) {
  for (const double common : {0.0, 0.5, 1.0}) {
    std::mt19937_64 random(11);
    int reaches_zero = 0;
    double mean_square = 0;
    constexpr int k_trials = 100;
    for (int t = 0; t < k_trials; ++t) {
      const ProfileError error =
          profile_error(sampled(parabola, 1, common, random), sampled(parabola, 1, common, random));
      reaches_zero += error.l2.low == 0;
      mean_square += error.l2.value * error.l2.value / k_trials;
    }
    EXPECT_GE(reaches_zero, 95) << "common part " << common;
    EXPECT_LT(std::sqrt(mean_square), 0.15) << "common part " << common;  // the noise of a bin's mean is 0.07 each
  }
}

TEST(ProfileError, IntervalHoldsTheTrueError) {
  for (const double common : {0.0, 0.5, 1.0}) {
    std::mt19937_64 random(12);
    int held = 0, held_by_maximum = 0, held_by_difference = 0;
    constexpr int k_trials = 200;
    for (int t = 0; t < k_trials; ++t) {
      const ProfileError error =
          profile_error(sampled(lower_parabola, 0.5, common, random), sampled(parabola, 0.5, common, random));
      // The scale is the noisy reference's largest mean: 1 within some per cent.
      held += error.l2.low <= 0.1 && 0.1 <= error.l2.high;
      held_by_maximum += error.maximum.low <= 0.1 && 0.1 <= error.maximum.high;
      held_by_difference += error.heights[0].difference.low <= -0.1 && -0.1 <= error.heights[0].difference.high;
    }
    EXPECT_GE(held, 0.92 * k_trials) << "common part " << common;
    EXPECT_GE(held_by_maximum, 0.92 * k_trials) << "common part " << common;
    EXPECT_GE(held_by_difference, 0.90 * k_trials) << "common part " << common;
  }
}

TEST(ProfileError, IntervalIsNotWiderThanItMustBe) {
  // Bins that move apart average out: the error of 0.1 is known to much better than one bin's mean, 0.035.
  std::mt19937_64 random(13);
  const ProfileError apart = profile_error(sampled(lower_parabola, 0.5, 0, random), exact(parabola));
  const ProfileError together = profile_error(sampled(lower_parabola, 0.5, 1, random), exact(parabola));
  EXPECT_LT(apart.l2.half_width(), 0.5 * together.l2.half_width());
  EXPECT_GT(apart.l2.low, 0.05);
}

TEST(VarianceOfCombination, OfOneBinIsItsStandardErrorSquared) {
  std::mt19937_64 random(14);
  const Profile profile = sampled(parabola, 1, 0, random);
  std::vector<double> one(k_bins, 0.0);
  one[4] = 1;
  const double error = profile.bins[4].standard_error;
  // output/block_average.h counts the unfinished last block in the total weight: up to a tenth.
  EXPECT_NEAR(variance_of_combination(profile, one) / (error * error), 1, 0.11);
}

TEST(VarianceOfCombination, WithoutBlocksAHeightMovesAsOneAndHeightsApart) {
  Profile profile = exact(parabola);
  profile.bins = {{.x = 0.0, .z = 0.1, .mean = 1, .standard_error = 0.3, .blocks = 10, .in_blocks = {}},
                  {.x = 0.1, .z = 0.1, .mean = 1, .standard_error = 0.1, .blocks = 10, .in_blocks = {}},
                  {.x = 0.0, .z = 0.2, .mean = 1, .standard_error = 0.3, .blocks = 10, .in_blocks = {}}};
  EXPECT_NEAR(variance_of_combination(profile, {1, -1, 1}), 0.4 * 0.4 + 0.3 * 0.3, 1e-12);
}
