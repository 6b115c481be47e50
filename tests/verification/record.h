#pragma once
/// What a verification test leaves for docs/verification.md (docs/verification/make_page.py reads it from GoogleTest's own results).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace similitude::test {

struct Record {
  std::string feature;     // what is verified
  std::string reference;   // what it is compared with
  std::string ours;        // our error, with its unit
  std::string others;      // the error that other codes publish; empty: none known here
};

inline void record(const Record& r) {
  ::testing::Test::RecordProperty("feature", r.feature);
  ::testing::Test::RecordProperty("reference", r.reference);
  ::testing::Test::RecordProperty("ours", r.ours);
  ::testing::Test::RecordProperty("others", r.others);
}

/// The largest of the errors it was shown, whatever their sign.
struct Worst {
  double value = 0;
  void see(double error) { value = std::max(value, std::abs(error)); }
  void see(double ours, double exact) { see(ours / exact - 1); }
};

inline std::string percent(double ratio) { return fmt::format("{:.2g} %", 100 * ratio); }

/// Rows of a figure, x, ours, reference: a file NAME.csv in the folder SIMILITUDE_CURVES, if that is set.
inline void record_curve(const std::string& name, const std::string& titles, const std::vector<std::array<double, 3>>& rows) {
  const char* folder = std::getenv("SIMILITUDE_CURVES");
  if (folder == nullptr) return;
  std::ofstream file(std::string(folder) + "/" + name + ".csv");
  file << titles << "\n";
  for (const auto& row : rows) file << fmt::format("{:.9g},{:.9g},{:.9g}\n", row[0], row[1], row[2]);
}

}  // namespace similitude::test
