/// Profiles for the terminal: a row per bin, a bar from zero.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "output/number.h"
#include "output/profiles.h"

namespace similitude {
namespace {

constexpr int k_bar_columns = 30;

struct Range {
  double low = 0, high = 0;  // zero is always inside, so that a bar begins there
};

Range range_of(const std::vector<ProfileRow>& rows) {
  Range range;
  for (const ProfileRow& row : rows)
    if (!std::isnan(row.mean)) range = {std::min(range.low, row.mean), std::max(range.high, row.mean)};
  return range;
}

std::string bar(double value, const Range& range) {
  if (!(range.high > range.low)) return "";
  const auto column = [&](double v) {
    return static_cast<int>(std::lround((v - range.low) / (range.high - range.low) * k_bar_columns));
  };
  const int zero = column(0), end = column(value);
  std::string text(static_cast<std::size_t>(k_bar_columns) + 1, ' ');
  for (int k = std::min(zero, end); k < std::max(zero, end) + (end < zero ? 0 : 1); ++k)
    text[static_cast<std::size_t>(k)] = '#';
  text[static_cast<std::size_t>(zero)] = '|';
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string header(const ProfileRow& row, const ProfileWindow& window) {
  return row.sampler + " at z = " + readable(row.z) + " m, mean over " + readable(window.from) + " ... " +
         readable(window.to) + " s (" + std::to_string(window.instants) +
         (window.instants == 1 ? " instant)\n" : " instants)\n") + "     x [m]       mean   std. error         n\n";
}

std::string line(const ProfileRow& row, const Range& range) {
  char text[128];
  if (row.n == 0) {
    std::snprintf(text, sizeof text, "%10.5g      empty\n", row.x);
    return text;
  }
  if (std::isnan(row.standard_error))
    std::snprintf(text, sizeof text, "%10.5g %10.4g            - %9llu  ", row.x, row.mean,
                  static_cast<unsigned long long>(row.n));
  else
    std::snprintf(text, sizeof text, "%10.5g %10.4g %12.2g %9llu  ", row.x, row.mean, row.standard_error,
                  static_cast<unsigned long long>(row.n));
  return text + bar(row.mean, range) + "\n";
}

}  // namespace

std::string profile_table(const ProfileSampler& sampler) {
  const std::vector<ProfileRow> rows = sampler.rows();
  std::string text;
  for (auto first = rows.begin(); first != rows.end();) {
    const auto last = std::find_if(
        first, rows.end(), [&](const ProfileRow& row) { return row.sampler != first->sampler || row.z != first->z; });
    const std::vector<ProfileRow> profile(first, last);
    const Range range = range_of(profile);
    const bool gas = first->sampler.starts_with("gas");
    if (!text.empty()) text += '\n';
    text += header(*first, gas ? sampler.gas_window() : sampler.solids_window());
    for (const ProfileRow& row : profile) text += line(row, range);
    first = last;
  }
  return text;
}

}  // namespace similitude
