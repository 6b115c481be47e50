#pragma once
/// A folder for a test's files, and what a reader says of them.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scene/messages.h"

namespace similitude::test {

class StudyFolder : public ::testing::Test {
 protected:
  StudyFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "similitude-study-XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~StudyFolder() override { std::filesystem::remove_all(folder); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; }

  /// The message without the folder; "" if there is none.
  template <class Action>
  std::string refusal_by(Action action) {
    try {
      action();
    } catch (const InputError& error) {
      std::string what = error.what();
      for (std::size_t at = what.find(folder.string() + "/"); at != std::string::npos; at = what.find(folder.string() + "/"))
        what.erase(at, folder.string().size() + 1);
      return what;
    }
    return "";
  }

  std::filesystem::path folder;
};

}  // namespace similitude::test
