#include "output/directory.h"

#include <gmock/gmock.h>

#include "output/whole_file.h"
#include "scene/messages.h"
#include "scratch.h"

using namespace similitude;
using namespace similitude::test;
using testing::UnorderedElementsAre;

TEST(OutputDirectory, IsMadeWithTheFoldersAboveIt) {
  const ScratchFolder folder;
  const OutputDirectory made(folder / "results/spout", false);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "results/spout"));
  EXPECT_EQ(made.file("manifest.json"), folder / "results/spout/manifest.json");
  EXPECT_TRUE(std::filesystem::is_empty(made.path()));
}

TEST(OutputDirectory, RefusesAnEarlierRunAndSaysWhatToType) {
  const ScratchFolder folder;
  write_whole_file(folder / "manifest.json", "{}");
  EXPECT_TRUE(holds_a_run(folder.path()));
  EXPECT_EQ(message_of<InputError>([&] { OutputDirectory(folder.path(), false); }),
            folder.path().string() +
                " holds an earlier run (manifest.json).\n"
                "  Give another folder with -o, or --force to replace that run.");
  EXPECT_EQ(text_of(folder / "manifest.json"), "{}");
}

TEST(OutputDirectory, RefusesAnEarlierRunThatCouldGoOnAndSaysHow) {
  const ScratchFolder folder;
  write_whole_file(folder / "manifest.json", "{}");
  std::filesystem::create_directory(folder / "checkpoints");
  EXPECT_EQ(message_of<InputError>([&] { OutputDirectory(folder.path(), false); }),
            folder.path().string() +
                " holds an earlier run (manifest.json).\n"
                "  Give another folder with -o, --resume to go on with that run, or --force to replace that run.");
}

TEST(OutputDirectory, TakesAFolderThatHoldsOnlyOtherFiles) {
  const ScratchFolder folder;
  write_whole_file(folder / "case.yaml", "similitude: 1");
  EXPECT_FALSE(holds_a_run(folder.path()));
  EXPECT_NO_THROW(OutputDirectory(folder.path(), false));
}

TEST(OutputDirectory, AnyFileOfARunIsAnEarlierRun) {
  for (const char* name : k_files_of_a_run) {
    const ScratchFolder folder;
    write_whole_file(folder / name, "old");
    EXPECT_TRUE(holds_a_run(folder.path())) << name;
  }
}

TEST(OutputDirectory, WithForceRemovesTheEarlierRunAndNothingElse) {
  const ScratchFolder folder;
  for (const char* name : k_files_of_a_run) write_whole_file(folder / name, "old");
  for (const char* name : {"fluid.pvd.part", "notes.txt"}) write_whole_file(folder / name, "old");
  for (const char* inner : {"particles", "fluid", "checkpoints"}) std::filesystem::create_directories(folder / inner);
  for (const char* name : {"particles/particles_000000.vtp", "particles/particles_000099.vtp",
                           "particles/particles_000100.vtp.part", "particles/mine.vtp", "fluid/fluid_000000.vti",
                           "checkpoints/checkpoint_000000007.h5", "checkpoints/checkpoint_000000006.h5.damaged"})
    write_whole_file(folder / name, "old");
  OutputDirectory(folder.path(), true);
  EXPECT_THAT(names_in(folder.path()), UnorderedElementsAre("notes.txt", "particles", "fluid", "checkpoints"));
  EXPECT_THAT(names_in(folder / "particles"), UnorderedElementsAre("mine.vtp"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "fluid"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "checkpoints"));
}

TEST(OutputDirectory, RefusesAFileInItsPlace) {
  const ScratchFolder folder;
  write_whole_file(folder / "results", "x");
  EXPECT_EQ(message_of<InputError>([&] { OutputDirectory(folder / "results", true); }),
            (folder / "results").string() + " is a file, not a folder for results.\n  Give another folder with -o.");
}

TEST(OutputDirectory, SaysWhyItCannotBeMade) {
  const ScratchFolder folder;
  write_whole_file(folder / "results", "x");
  EXPECT_EQ(message_of<InputError>([&] { OutputDirectory(folder / "results/spout", false); }),
            "the folder " + (folder / "results/spout").string() +
                " cannot be made: Not a directory.\n  Give another folder with -o.");
}

// Not even root may make files in /proc; permission bits would not stop it.
TEST(OutputDirectory, SaysThatItCannotBeWrittenTo) {
  EXPECT_EQ(message_of<InputError>([&] { OutputDirectory("/proc", false); }),
            "the folder /proc cannot be written to: No such file or directory.\n"
            "  Give another folder with -o, or change its permissions.");
}

TEST(OutputDirectory, SaysThatASubfolderCannotBeMade) {
  const ScratchFolder folder;
  const OutputDirectory directory(folder.path(), false);
  write_whole_file(folder / "particles", "a file");
  EXPECT_THAT(message_of<OutputError>([&] { directory.subfolder("particles"); }),
              testing::StartsWith((folder / "particles").string() + ": cannot be made: "));
}
