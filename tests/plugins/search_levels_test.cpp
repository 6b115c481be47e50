#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "loader/catalogue.h"

namespace similitude {
namespace {

/// An environment variable for the length of a test; null: unset.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    value == nullptr ? unsetenv(name) : setenv(name, value, 1);
  }
  ~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

std::vector<std::string> told(const std::vector<SearchLevel>& levels) {
  std::vector<std::string> texts;
  for (const SearchLevel& level : levels)
    if (level.name != "install folder") texts.push_back(level.name + " " + level.folder.string());
  return texts;
}

TEST(SearchLevels, GoFromTheCaseToTheInstallation) {
  const Variable path("SIMILITUDE_PLUGIN_PATH", "/a:/b::");
  const Variable data("XDG_DATA_HOME", "/home/me/data");
  const auto levels = search_levels({"/case/plugins"});
  EXPECT_THAT(told(levels),
              testing::ElementsAre("plugin_paths of the case /case/plugins", "SIMILITUDE_PLUGIN_PATH /a",
                                   "SIMILITUDE_PLUGIN_PATH /b", "user folder /home/me/data/similitude/plugins"));
  EXPECT_EQ(levels.back().name, "install folder");
}

TEST(SearchLevels, TheUserFolderIsInTheHomeFolderByDefault) {
  const Variable path("SIMILITUDE_PLUGIN_PATH", nullptr);
  const Variable data("XDG_DATA_HOME", nullptr);
  const Variable home("HOME", "/home/me");
  EXPECT_THAT(told(search_levels({})), testing::ElementsAre("user folder /home/me/.local/share/similitude/plugins"));
}

TEST(SearchLevels, WithoutAHomeThereIsNoUserFolder) {
  const Variable path("SIMILITUDE_PLUGIN_PATH", nullptr);
  const Variable data("XDG_DATA_HOME", "relative/is/ignored");
  const Variable home("HOME", nullptr);
  EXPECT_THAT(told(search_levels({})), testing::IsEmpty());
}

TEST(SearchLevels, TheInstallFolderLiesBesideTheProgram) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  EXPECT_EQ(search_levels({}).back().folder, program.parent_path().parent_path() / "lib/similitude/plugins");
}

}  // namespace
}  // namespace similitude
