/// What makes two runs runs of one case.

#include "stepper/resume.h"

#include <gtest/gtest.h>

#include <string>

namespace similitude::test {
namespace {

/// A bed from a file that lies in `folder`.
CaseIdentity bed_in(const std::string& folder, const std::string& sha256, const std::string& title = "a bed") {
  return {.resolved_case = R"({"title": ")" + title + R"(", "plugin_paths": [")" + folder + R"(/plugins"], "scene": {"bed": {"fill": "file", "file": ")" +
                           folder + R"(/bed.csv"}, "gravity": ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]}, "time": {"end": "1 s"}})",
          .bed_sha256 = sha256};
}

}  // namespace

TEST(CaseDifferences, AreNoneWhereACaseWasMovedAndRenamed) {
  EXPECT_EQ(case_differences(bed_in("/here", "0123"), bed_in("/elsewhere", "0123", "the same bed")), "");
}

TEST(CaseDifferences, NameABedOfOtherBytes) {
  EXPECT_EQ(case_differences(bed_in("/here", "0123456789abcdef"), bed_in("/here", "fedcba9876543210")),
            "\n    scene.bed.file: the file is another (SHA-256 was 0123456789ab…, is fedcba987654… of /here/bed.csv)");
}

TEST(CaseDifferences, TakeThePathOfABedWhoseBytesAnEarlierRunDoesNotTell) {
  EXPECT_EQ(case_differences(bed_in("/here", ""), bed_in("/here", "0123")), "");
  EXPECT_EQ(case_differences(bed_in("/here", ""), bed_in("/elsewhere", "0123")),
            "\n    scene.bed.file: was /here/bed.csv, is /elsewhere/bed.csv");
}

TEST(CaseDifferences, NameABedThatIsNoLongerOfAFile) {
  const CaseIdentity settled{.resolved_case = R"({"scene": {"bed": {"fill": "settle"}, "gravity": ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]}})", .bed_sha256 = ""};
  EXPECT_EQ(case_differences(bed_in("/here", "0123"), settled),
            "\n    scene.bed.fill: was file, is settle\n    scene.bed.file: was /here/bed.csv, is left out");
}

}  // namespace similitude::test
