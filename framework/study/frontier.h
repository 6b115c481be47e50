#pragma once
/// The judgement: which cases no other beats in both time and error, what each step along them costs, and one sentence
/// of advice.

#include <string>
#include <vector>

#include "study/estimate.h"

namespace similitude {

/// A case as the frontier sees it.
struct Contender {
  std::string name;
  double wall_s = Estimate::k_unknown;  // NaN: not known
  Estimate error;                       // [-]; of the reference zero
  bool reference = false;
};

struct FrontierStep {
  std::string from, to;          // from the faster to the more accurate
  double time_ratio = 1;         // to over from
  double error_change = 0;       // to minus from, negative
  bool distinguishable = false;  // the two errors' intervals are apart
};

struct Frontier {
  std::vector<std::string> cases;  // the fastest first
  std::vector<FrontierStep> steps;
  bool holds(const std::string& name) const;
};

/// Contenders without a time or an error stand outside.
Frontier frontier_of(const std::vector<Contender>& contenders);

/// Pairs whose errors' intervals overlap, the reference left out.
std::vector<std::pair<std::string, std::string>> indistinguishable(const std::vector<Contender>& contenders);

/// One sentence: the fastest case whose error cannot be told from the smallest, how much faster than the reference it
/// is, what its error is, and what stands next to it. `metric` is what the error is of, in words.
std::string advice(const std::vector<Contender>& contenders, const std::string& metric);

/// "6 ± 4 %": value and half the interval; "0 to 4 %" where it reaches zero; "at least 4 %" where it is a lower bound.
std::string percent_text(const Estimate& error);

}  // namespace similitude
