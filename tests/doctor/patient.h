#pragma once
/// A patient before the doctor.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "doctor/examination.h"

namespace similitude::doctor {

inline std::string library(const std::string& name) { return std::string(PATIENTS_FOLDER) + "/" + name + ".so"; }

/// Examined once per program. Two seconds are long enough for every check of a patient but the one that never ends.
inline const Examination& examined(const std::string& name, double limit = 60) {
  static std::map<std::string, Examination> known;
  const auto found = known.find(name);
  if (found != known.end()) return found->second;
  return known[name] = examine(library(name), limit);
}

/// The names of the checks that failed.
inline std::vector<std::string> failures(const Examination& examination, const std::string& model) {
  std::vector<std::string> names;
  for (const Finding& finding : examination.findings)
    if (finding.model == model && finding.outcome.verdict == Verdict::fail) names.push_back(finding.check);
  return names;
}

inline Outcome outcome(const Examination& examination, const std::string& model, const std::string& check) {
  for (const Finding& finding : examination.findings)
    if (finding.model == model && finding.check == check) return finding.outcome;
  ADD_FAILURE() << "no check \"" << check << "\" of " << model;
  return {};
}

}  // namespace similitude::doctor
