#pragma once
/// One file, examined from its bytes to the behaviour of its models.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "doctor/finding.h"

namespace similitude::doctor {

struct Examination {
  std::filesystem::path file;      // absolute
  std::vector<Finding> findings;   // in the order of the checks: the file's, then model after model

  bool healthy() const;            // nothing failed
};

/// Longest that one check may take [s]. The slowest of the shipped models' takes a hundredth of it.
inline constexpr double k_check_limit = 60;

/// Nothing of the file runs in this process. Main thread, before any other thread was started: every check is a fork.
Examination examine(const std::filesystem::path& file, double check_limit = k_check_limit);

/// A line per check, what to do under each that failed, and the sum. Ends with a new line.
std::string examination_text(const Examination& examination);
/// {"file", "healthy", "findings": [{"model", "check", "verdict": "ok|fail|skipped", "seen", "advice"}]}; model is null
/// for the file's own checks.
nlohmann::json examination_json(const Examination& examination);

}  // namespace similitude::doctor
