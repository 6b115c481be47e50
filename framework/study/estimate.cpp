#include "study/estimate.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

namespace similitude {
namespace {

constexpr double k_confidence = 0.95;
constexpr std::size_t k_fewest_blocks = 4;  // below, Student's t says nothing useful
constexpr std::size_t k_fewest_values = 8;
constexpr std::size_t k_windows = 3;  // of a spectrum, each half of the series
constexpr std::size_t k_fewest_in_window = 16;

Estimate too_few_rows(std::size_t wanted) {
  return gap(fmt::format("fewer than {} rows in the window of the average: lengthen time.end, or write more of them, e.g. output.monitors: every 5 ms", wanted));
}

struct Blocked {
  double standard_error = 0;
  std::size_t blocks = 0;
};

Blocked in_blocks(const std::vector<double>& series, std::size_t length) {
  Blocked result{.standard_error = 0, .blocks = series.size() / length};
  const auto n = static_cast<double>(result.blocks);
  std::vector<double> means;
  for (std::size_t b = 0; b < result.blocks; ++b) {
    double sum = 0;
    for (std::size_t k = 0; k < length; ++k) sum += series[b * length + k];
    means.push_back(sum / static_cast<double>(length));
  }
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / n;
  double squares = 0;
  for (const double m : means) squares += (m - mean) * (m - mean);
  result.standard_error = std::sqrt(squares / (n * (n - 1)));
  return result;
}

/// 1, 2, 3, 4, 6, 8, 12, …: fine enough that the length chosen is at most half as long again as needed.
std::size_t next_length(std::size_t length) { return length < 3 ? length + 1 : length + (length + 2) / 3; }

Estimate interval_of(double value, const BlockedMean& mean) {
  const double reach = student_two_sided(k_confidence, static_cast<double>(mean.blocks) - 1) * mean.standard_error;
  Estimate result;
  result.value = value;
  result.low = value - reach;
  result.high = value + reach;
  result.effective_samples = mean.effective_samples;
  result.lower_bound = !mean.plateau || mean.effective_samples < k_fewest_samples;
  return result;
}

/// Power of the frequencies 1, 2, … per window, of values[first, first + length), mean taken off, Hann's window put on.
std::vector<double> spectrum(const std::vector<double>& values, std::size_t first, std::size_t length) {
  const auto n = static_cast<double>(length);
  double mean = 0;
  for (std::size_t k = 0; k < length; ++k) mean += values[first + k] / n;
  std::vector<double> windowed(length);
  for (std::size_t k = 0; k < length; ++k) {
    const double hann = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / n);
    windowed[k] = hann * (values[first + k] - mean);
  }
  std::vector<double> power;
  for (std::size_t f = 1; f <= length / 2; ++f) {
    const double angle = -2 * std::numbers::pi * static_cast<double>(f) / n;
    const std::complex<double> turn = std::polar(1.0, angle);
    std::complex<double> sum = 0, phase = 1;
    for (const double value : windowed) {
      sum += value * phase;
      phase *= turn;
    }
    power.push_back(std::norm(sum));
  }
  return power;
}

/// In cycles per window: the highest of the powers, refined by the parabola through the logarithms of its neighbours.
double peak_of(const std::vector<double>& power) {
  const auto highest = static_cast<std::size_t>(std::max_element(power.begin(), power.end()) - power.begin());
  const auto place = static_cast<double>(highest) + 1;
  if (highest == 0 || highest + 1 == power.size() || !(power[highest - 1] > 0) || !(power[highest + 1] > 0))
    return place;
  const double left = std::log(power[highest - 1]), middle = std::log(power[highest]),
               right = std::log(power[highest + 1]);
  const double bend = left - 2 * middle + right;
  return bend < 0 ? place + 0.5 * (left - right) / bend : place;
}

}  // namespace

Estimate exactly(double value) {
  Estimate result;
  result.value = result.low = result.high = value;
  return result;
}

Estimate gap(const std::string& why) {
  Estimate result;
  result.gap = why;
  return result;
}

bool overlap(const Estimate& a, const Estimate& b) { return a.low <= b.high && b.low <= a.high; }

double student_two_sided(double probability, double degrees_of_freedom) {
  if (!(degrees_of_freedom > 0)) return std::numeric_limits<double>::infinity();
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), 0.5 + 0.5 * probability);
}

BlockedMean blocked_mean(const std::vector<double>& series) {
  BlockedMean result;
  const auto n = static_cast<double>(series.size());
  result.mean = std::accumulate(series.begin(), series.end(), 0.0) / n;
  const double uncorrelated = in_blocks(series, 1).standard_error;
  result.effective_samples = n;
  result.blocks = series.size();
  if (!(uncorrelated > 0)) {
    result.plateau = true;  // a constant: every block says the same
    return result;
  }
  for (std::size_t length = 1; series.size() / length >= k_fewest_blocks; length = next_length(length)) {
    const Blocked blocked = in_blocks(series, length);
    const double inefficiency = blocked.standard_error * blocked.standard_error / (uncorrelated * uncorrelated);
    const auto block = static_cast<double>(length);
    result.plateau = block * block * block > 2 * n * inefficiency * inefficiency;
    if (!result.plateau && blocked.standard_error <= result.standard_error) continue;
    result.standard_error = blocked.standard_error;
    const double freedom = static_cast<double>(blocked.blocks) - 1;
    result.effective_samples = n / std::max(1.0, inefficiency) * (freedom - 2) / freedom;
    result.block_length = length;
    result.blocks = blocked.blocks;
    if (result.plateau) break;
  }
  return result;
}

Series even_series(const std::vector<double>& times, const std::vector<double>& values, double from) {
  std::vector<double> t, v;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] < from || std::isnan(values[k])) continue;
    t.push_back(times[k]);
    v.push_back(values[k]);
  }
  Series series;
  if (t.size() < 2) return series;
  series.interval = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  std::size_t right = 1;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double time = std::min(t.front() + static_cast<double>(k) * series.interval, t.back());
    while (right + 1 < t.size() && t[right] < time) ++right;
    const double share = (time - t[right - 1]) / (t[right] - t[right - 1]);
    series.values.push_back(v[right - 1] + share * (v[right] - v[right - 1]));
  }
  return series;
}

Estimate mean_of(const Series& series) {
  if (series.values.size() < k_fewest_values) return too_few_rows(k_fewest_values);
  const BlockedMean mean = blocked_mean(series.values);
  return interval_of(mean.mean, mean);
}

Estimate fluctuation_of(const Series& series) {
  if (series.values.size() < k_fewest_values) return too_few_rows(k_fewest_values);
  const BlockedMean mean = blocked_mean(series.values);
  std::vector<double> squares;
  for (const double value : series.values) squares.push_back((value - mean.mean) * (value - mean.mean));
  const BlockedMean variance = blocked_mean(squares);
  // About the mean of the same values the squares are too small by that mean's own variance.
  const Estimate of_variance = interval_of(variance.mean + mean.standard_error * mean.standard_error, variance);
  Estimate result = of_variance;
  result.value = std::sqrt(of_variance.value);
  result.low = std::sqrt(std::max(0.0, of_variance.low));
  result.high = std::sqrt(of_variance.high);
  result.effective_samples = std::min(mean.effective_samples, variance.effective_samples);
  result.lower_bound = !mean.plateau || !variance.plateau || result.effective_samples < k_fewest_samples;
  return result;
}

Estimate dominant_frequency_of(const Series& series) {
  const std::size_t length = series.values.size() / 2;
  if (length < k_fewest_in_window) return too_few_rows(2 * k_fewest_in_window);
  std::vector<double> total(length / 2, 0.0), peaks;
  for (std::size_t w = 0; w < k_windows; ++w) {
    const std::vector<double> power =
        spectrum(series.values, w * (series.values.size() - length) / (k_windows - 1), length);
    for (std::size_t f = 0; f < power.size(); ++f) total[f] += power[f];
    peaks.push_back(peak_of(power));
  }
  if (!(*std::max_element(total.begin(), total.end()) > 0)) return gap("nothing fluctuates");
  const auto highest = std::max_element(total.begin(), total.end()) - total.begin();
  // Hann's window spreads what is slower than the window over its two lowest frequencies.
  if (highest < 2) return gap("no frequency stands out above the slowest that the window resolves");

  const double per_window = 1 / (static_cast<double>(length) * series.interval);  // [Hz]
  Estimate result;
  result.value = peak_of(total) * per_window;
  double reach = per_window;
  for (const double peak : peaks) reach = std::max(reach, std::abs(peak * per_window - result.value));
  result.low = std::max(0.0, result.value - reach);
  result.high = result.value + reach;
  return result;
}

}  // namespace similitude
