#pragma once
/// How far a profile lies from another, with confidence.

#include <string>
#include <vector>

#include "study/estimate.h"

namespace similitude {

/// Below this many effective blocks a bin's standard error says nothing, and the bin is left out.
inline constexpr double k_fewest_blocks_of_a_bin = 5;

struct ProfileBin {
  struct Block {
    double weighted_sum = 0, weight = 0;
  };
  double x = 0, z = 0;                // [m], centre
  double mean = Estimate::k_unknown;  // NaN: nothing was seen
  double standard_error = Estimate::k_unknown;
  double blocks = 0;             // effective ones behind the standard error
  std::vector<Block> in_blocks;  // the same instants in all bins; empty: not known
};

struct Profile {
  std::string sampler;  // "vertical_velocity [m/s]"
  std::vector<ProfileBin> bins;
  /// Measured data: any bin with a mean counts, and a standard error that is not given is zero.
  bool measured = false;
};

struct ErrorAtHeight {
  double z = 0;         // [m]
  Estimate l2;          // [-], as ProfileError::l2, of this height alone
  Estimate difference;  // [-], mean over the height of profile minus reference; negative: the profile is low
};

/// Over the reference's largest magnitude in all its bins.
struct ProfileError {
  Estimate l2;       // [-], root of the mean square over all bins
  Estimate maximum;  // [-]
  std::vector<ErrorAtHeight> heights;
  std::size_t bins = 0, left_out = 0;  // of the reference's: compared, and seen too seldom on one of the two sides
};

/// The profile at the reference's places, straight lines between its bins.
///
/// Noise alone makes two profiles differ: what the standard errors explain is taken off the mean square, so that two
/// samples of the same bed have an expected squared error of zero. The interval of the mean square E^2 is first order
/// in the difference, 2 sum d_i delta_i / N, whose variance comes from its own scatter over the blocks, correlation of
/// neighbouring bins included (where blocks are not known: bins of a height fully correlated, heights independent),
/// plus 2 S^4, the most that the noise's own square S^2 can vary. The interval of the maximum holds for all bins at
/// once (Bonferroni).
ProfileError profile_error(const Profile& profile, const Profile& reference);

/// Variance of sum c_i mean_i.
double variance_of_combination(const Profile& profile, const std::vector<double>& coefficients);

}  // namespace similitude
