#pragma once
/// What one check found.

#include <string>
#include <utility>

namespace similitude::doctor {

enum class Verdict { ok, fail, skipped };

struct Outcome {
  Verdict verdict = Verdict::ok;
  std::string seen;     // the numbers, or why it was skipped; one line
  std::string advice;   // of a FAIL: what to do
};

inline Outcome ok(std::string seen) { return {Verdict::ok, std::move(seen), ""}; }
inline Outcome skipped(std::string why) { return {Verdict::skipped, std::move(why), ""}; }
inline Outcome fail(std::string seen, std::string advice) { return {Verdict::fail, std::move(seen), std::move(advice)}; }

struct Finding {
  std::string model;   // "drag model gidaspow"; empty: the file itself
  std::string check;
  Outcome outcome;
};

}  // namespace similitude::doctor
