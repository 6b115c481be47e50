// Every plugin that ships is healthy. What its kind's suite holds against a law must follow from what the law declares.

#include <fstream>
#include <iterator>

#include "loader/catalogue.h"
#include "patient.h"

namespace similitude::doctor {
namespace {

std::vector<std::string> shipped() {
  std::vector<std::string> files;
  for (const auto& item : std::filesystem::directory_iterator(search_levels({}).back().folder))
    if (item.path().extension() == ".so") files.push_back(item.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

/// The page that says what is checked.
std::string page() {
  std::ifstream file(DOCTOR_PAGE);
  return {std::istreambuf_iterator<char>(file), {}};
}

// In one test: the examination of all of them takes about ten seconds.
TEST(Doctor, FindsEveryShippedPluginHealthy) {
  const std::vector<std::string> files = shipped();
  EXPECT_GE(files.size(), 32u);
  const std::string documented = page();
  for (const std::string& file : files) {
    const Examination examination = examine(file);
    EXPECT_TRUE(examination.healthy()) << examination_text(examination);
    EXPECT_GE(examination.findings.size(), 8u) << examination_text(examination);
    for (const Finding& finding : examination.findings)
      EXPECT_THAT(documented, testing::HasSubstr("`" + finding.check + "`")) << "is not in " << DOCTOR_PAGE;
  }
}

}  // namespace
}  // namespace similitude::doctor
