#pragma once
/// Series whose statistics are known.

#include <cmath>
#include <random>
#include <vector>

namespace similitude::test {

/// x_k = phi x_(k-1) + sqrt(1 - phi^2) e_k: mean 0, variance 1, correlation phi^lag; g = (1 + phi) / (1 - phi).
inline std::vector<double> autoregressive(double phi, std::size_t length, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> series(length);
  double value = normal(random);
  for (double& x : series) {
    x = value;
    value = phi * value + std::sqrt(1 - phi * phi) * normal(random);
  }
  return series;
}

}  // namespace similitude::test
