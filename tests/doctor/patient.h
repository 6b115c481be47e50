#pragma once
/// Patients before the doctor: what fails, and in which words.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "doctor/examination.h"

namespace similitude::doctor {

/// The line of the report that an illness must be told on, literally.
struct Illness {
  std::string model;    // "drag model accelerates"
  std::string check;
  std::string seen, advice;
  std::vector<std::string> also_fail = {};   // further lines that the same fault spoils
};

inline std::string library(const std::string& name) { return std::string(PATIENTS_FOLDER) + "/" + name + ".so"; }

inline std::vector<std::string> failed_checks(const Examination& examination, const std::string& model) {
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

inline void expect_illness(const Examination& examination, const Illness& illness) {
  SCOPED_TRACE(illness.model);
  const Outcome told = outcome(examination, illness.model, illness.check);
  EXPECT_EQ(told.seen, illness.seen);
  EXPECT_EQ(told.advice, illness.advice);
  std::vector<std::string> expected = illness.also_fail;
  expected.push_back(illness.check);
  EXPECT_THAT(failed_checks(examination, illness.model), testing::UnorderedElementsAreArray(expected));
}

}  // namespace similitude::doctor
