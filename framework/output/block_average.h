#pragma once
/// Mean and standard error of a correlated series by block averages (Flyvbjerg & Petersen 1989,
/// J. Chem. Phys. 91, 461).

#include <cstdint>
#include <utility>
#include <vector>

namespace similitude {

/// A weighted mean over a window of unknown length: sum w v / sum w, as a ratio of sums, and its standard error.
/// Samples are gathered in blocks; when there are 20, neighbours are joined, so that from the tenth sample on
/// there are 10 to 19 blocks, whatever the window. The error is right when a block is long against the series' memory.
class BlockAverage {
 public:
  static constexpr std::size_t k_most_blocks = 20;

  /// One instant: sums of w v and of w over what was seen then; weight 0 if nothing was. Weights are not negative.
  void add(double weighted_sum, double weight);

  /// NaN where nothing was seen.
  double mean() const;
  /// Of a ratio of sums (Cochran 1977, Sampling Techniques, eq. 6.9), blocks as the sampling units:
  /// se^2 = n/(n-1) sum (A_b - mean W_b)^2 / (sum W_b)^2, with n = effective_blocks(). NaN where n < 2. The mean rests
  /// on the unfinished last block as well, so one factor sum W_b is that of all samples (up to a tenth more).
  double standard_error() const;
  /// (sum W_b)^2 / sum W_b^2 over whole blocks (Kish): blocks that saw little count little.
  double effective_blocks() const;
  /// How many instants one block holds.
  std::uint64_t block_length() const { return state_.block_length; }

  struct Sums {
    double weighted = 0, weight = 0;
  };
  /// All that it remembers, for checkpoints.
  struct State {
    std::vector<Sums> blocks;
    Sums open;  // the block that is being filled
    Sums total;
    std::uint64_t in_open = 0, block_length = 1;
  };
  const State& state() const { return state_; }
  void restore(State state) { state_ = std::move(state); }

  /// The whole blocks, in the order of time: what differs between two averages over the same instants can be told from them.
  const std::vector<Sums>& blocks() const { return state_.blocks; }

 private:
  State state_;
};

}  // namespace similitude
