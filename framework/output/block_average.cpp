#include "output/block_average.h"

#include <cmath>
#include <limits>

namespace similitude {

void BlockAverage::add(double weighted_sum, double weight) {
  state_.total.weighted += weighted_sum;
  state_.total.weight += weight;
  state_.open.weighted += weighted_sum;
  state_.open.weight += weight;
  if (++state_.in_open < state_.block_length) return;

  state_.blocks.push_back(state_.open);
  state_.open = {};
  state_.in_open = 0;
  if (state_.blocks.size() < k_most_blocks) return;
  for (std::size_t b = 0; b < k_most_blocks / 2; ++b)
    state_.blocks[b] = {state_.blocks[2 * b].weighted + state_.blocks[2 * b + 1].weighted,
                  state_.blocks[2 * b].weight + state_.blocks[2 * b + 1].weight};
  state_.blocks.resize(k_most_blocks / 2);
  state_.block_length *= 2;
}

double BlockAverage::mean() const {
  return state_.total.weight > 0 ? state_.total.weighted / state_.total.weight : std::numeric_limits<double>::quiet_NaN();
}

double BlockAverage::effective_blocks() const {
  double sum = 0, squares = 0;
  for (const Sums& block : state_.blocks) {
    sum += block.weight;
    squares += block.weight * block.weight;
  }
  return squares > 0 ? sum * sum / squares : 0;
}

double BlockAverage::standard_error() const {
  const double blocks = effective_blocks();
  if (blocks < 2) return std::numeric_limits<double>::quiet_NaN();
  Sums sum;
  for (const Sums& block : state_.blocks) {
    sum.weighted += block.weighted;
    sum.weight += block.weight;
  }
  // About the mean of the whole blocks, so that the residuals add up to zero.
  const double whole_mean = sum.weighted / sum.weight;
  double squares = 0;
  for (const Sums& block : state_.blocks) {
    const double residual = block.weighted - whole_mean * block.weight;
    squares += residual * residual;
  }
  return std::sqrt(blocks / (blocks - 1) * squares / (sum.weight * state_.total.weight));
}

}  // namespace similitude
