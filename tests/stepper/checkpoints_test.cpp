// What a run's checkpoints promise about the files beside them.
#include "stepper/checkpoints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace similitude {
namespace {

/// A run's folder that holds monitors.csv and nothing else.
class Checkpointing : public testing::Test {
 protected:
  Checkpointing() : directory((std::filesystem::remove_all(folder), folder), false) { std::ofstream(folder / "monitors.csv") << "time [s]\n"; }
  ~Checkpointing() override { std::filesystem::remove_all(folder); }

  bool written(std::uint64_t probes_length, std::uint64_t scalars_length) {
    RunIdentity run;
    run.resolved_case = "{}";
    RunState state;
    state.outputs.monitors_length = 9;
    state.outputs.probes_length = probes_length;
    state.outputs.scalars_length = scalars_length;
    return Checkpoints(directory, 1, run, {}, [this](const std::string& text) { warning = text; }).write(state);
  }

  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("checkpoints_" + std::to_string(::getpid()));
  OutputDirectory directory;
  std::string warning;
};

TEST_F(Checkpointing, AsksNothingOfTablesThatThisRunDoesNotHave) {
  EXPECT_TRUE(written(0, 0));
  EXPECT_EQ(warning, "");
}

// A length of a table is worth something only where the table itself is on the disk.
TEST_F(Checkpointing, SyncsEveryTableWhoseLengthItKeeps) {
  EXPECT_FALSE(written(10, 0));
  EXPECT_THAT(warning, testing::HasSubstr("probes.csv: cannot be synced: No such file or directory."));
  EXPECT_FALSE(written(0, 10));
  EXPECT_THAT(warning, testing::HasSubstr("scalars.csv: cannot be synced: No such file or directory."));
}

}  // namespace
}  // namespace similitude
