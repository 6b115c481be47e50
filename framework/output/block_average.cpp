#include "output/block_average.h"

#include <cmath>
#include <limits>

namespace similitude {

void BlockAverage::add(double weighted_sum, double weight) {
  total_.weighted += weighted_sum;
  total_.weight += weight;
  open_.weighted += weighted_sum;
  open_.weight += weight;
  if (++in_open_ < block_length_) return;

  blocks_.push_back(open_);
  open_ = {};
  in_open_ = 0;
  if (blocks_.size() < k_most_blocks) return;
  for (std::size_t b = 0; b < k_most_blocks / 2; ++b)
    blocks_[b] = {blocks_[2 * b].weighted + blocks_[2 * b + 1].weighted,
                  blocks_[2 * b].weight + blocks_[2 * b + 1].weight};
  blocks_.resize(k_most_blocks / 2);
  block_length_ *= 2;
}

double BlockAverage::mean() const {
  return total_.weight > 0 ? total_.weighted / total_.weight : std::numeric_limits<double>::quiet_NaN();
}

double BlockAverage::effective_blocks() const {
  double sum = 0, squares = 0;
  for (const Sums& block : blocks_) {
    sum += block.weight;
    squares += block.weight * block.weight;
  }
  return squares > 0 ? sum * sum / squares : 0;
}

double BlockAverage::standard_error() const {
  const double blocks = effective_blocks();
  if (blocks < 2) return std::numeric_limits<double>::quiet_NaN();
  Sums sum;
  for (const Sums& block : blocks_) {
    sum.weighted += block.weighted;
    sum.weight += block.weight;
  }
  // About the mean of the whole blocks, so that the residuals add up to zero.
  const double whole_mean = sum.weighted / sum.weight;
  double squares = 0;
  for (const Sums& block : blocks_) {
    const double residual = block.weighted - whole_mean * block.weight;
    squares += residual * residual;
  }
  return std::sqrt(blocks / (blocks - 1) * squares / (sum.weight * total_.weight));
}

}  // namespace similitude
