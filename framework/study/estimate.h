#pragma once
/// Numbers with confidence from correlated series. All intervals are 95 %.

#include <limits>
#include <string>
#include <vector>

namespace similitude {

/// Below this many independent samples an interval is said to be a lower bound: the series is too short to show how
/// slow its slowest motion is.
inline constexpr double k_fewest_samples = 20;

struct Estimate {
  static constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();
  double value = k_unknown;
  double low = k_unknown, high = k_unknown;  // ends of the 95 % interval
  bool lower_bound = false;                  // the interval is at least this wide
  double effective_samples = k_unknown;      // independent ones behind it; NaN: it is not a mean over time
  std::string gap;                           // why there is no value

  bool known() const { return gap.empty(); }
  double half_width() const { return 0.5 * (high - low); }
};
/// A number without noise.
Estimate exactly(double value);
Estimate gap(const std::string& why);

/// The intervals have a point in common: the two are indistinguishable.
bool overlap(const Estimate& a, const Estimate& b);

/// Of Student's distribution: |t| is below it with `probability`.
double student_two_sided(double probability, double degrees_of_freedom);

/// Mean of a correlated series by blocks (Flyvbjerg & Petersen 1989, J. Chem. Phys. 91, 461), the length of a block
/// from the series itself: the shortest B with B^3 > 2 n g^2, where g = se_B^2 / se_1^2 (Lee et al. 2011, Phys. Rev. E
/// 83, 066706).
struct BlockedMean {
  double mean = 0, standard_error = 0;
  double effective_samples = 0;  // n / g, times (f - 2) / f: so much 1 / se_B^2 of f + 1 blocks is too large on average
  std::size_t block_length = 1, blocks = 0;
  bool plateau = false;  // a block length was found; otherwise the largest standard error stands
};
BlockedMean blocked_mean(const std::vector<double>& series);

/// The series of a monitor after start-up, at even intervals.
struct Series {
  double interval = 0;  // [s]
  std::vector<double> values;
};
/// From rows at times that are even but for the steps they fall on: interpolated, from `from` [s] on. Rows without a
/// value are passed over.
Series even_series(const std::vector<double>& times, const std::vector<double>& values, double from);

Estimate mean_of(const Series& series);
/// Standard deviation of the series.
Estimate fluctuation_of(const Series& series);
/// [Hz], of the highest peak of the spectrum: Welch (1967), IEEE Trans. Audio Electroacoust. 15, 70; three
/// half-overlapping Hann windows. The interval is the spectrum's resolution, or the scatter of the windows' own peaks
/// if that is wider. A gap if the highest power is at the lowest frequency that the windows resolve: then nothing
/// repeats within them.
Estimate dominant_frequency_of(const Series& series);

}  // namespace similitude
