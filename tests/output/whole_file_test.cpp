#include "output/whole_file.h"

#include <gmock/gmock.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <csignal>

#include "scratch.h"

using namespace similitude;
using namespace similitude::test;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(WholeFile, HoldsTheBytesAndLeavesNoTemporaryFile) {
  const ScratchFolder folder;
  write_whole_file(folder / "a", std::string("with a zero \0 inside", 20));
  EXPECT_EQ(text_of(folder / "a"), std::string("with a zero \0 inside", 20));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("a"));
}

TEST(WholeFile, ReplacesAnEarlierFileAsAWhole) {
  const ScratchFolder folder;
  write_whole_file(folder / "a", "a long first text");
  write_whole_file(folder / "a", "short");
  EXPECT_EQ(text_of(folder / "a"), "short");
}

// /dev/full answers every write as a full disk does.
TEST(WholeFile, SaysThatTheDiskIsFullAndKeepsTheEarlierFile) {
  const ScratchFolder folder;
  write_whole_file(folder / "a", "earlier");
  std::filesystem::create_symlink("/dev/full", folder / "a.part");
  EXPECT_EQ(message_of<OutputError>([&] { write_whole_file(folder / "a", "later"); }),
            (folder / "a").string() +
                ": cannot be written: the disk is full.\n"
                "  Free space there or give another folder with -o. What was written before is whole.");
  EXPECT_EQ(text_of(folder / "a"), "earlier");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("a"));
}

TEST(WholeFile, LeavesNothingOnASmallDiskThatFillsUpHalfWay) {
  const ScratchFolder folder;
  if (::mount("none", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "mounting is not allowed here";
  const std::string message =
      message_of<OutputError>([&] { write_whole_file(folder / "frame", std::string(100'000, 'x')); });
  const std::vector<std::string> left = names_in(folder.path());
  ::umount(folder.path().c_str());
  EXPECT_THAT(message, testing::HasSubstr("frame: cannot be written: the disk is full."));
  EXPECT_THAT(left, IsEmpty());
}

// A limit on file size stops a write half way wherever the tests run; the system calls that EFBIG.
TEST(WholeFile, LeavesNothingWhenAWriteStopsHalfWay) {
  const ScratchFolder folder;
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {10'000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string message =
      message_of<OutputError>([&] { write_whole_file(folder / "frame", std::string(100'000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, (folder / "frame").string() +
                         ": cannot be written: File too large.\n"
                         "  Check that its folder exists and may be written to, or give another folder with -o.");
  EXPECT_THAT(names_in(folder.path()), IsEmpty());
}

TEST(WholeFile, SaysThatTheFolderIsNotThere) {
  const ScratchFolder folder;
  const auto file = folder / "gone" / "a";
  EXPECT_EQ(message_of<OutputError>([&] { write_whole_file(file, "x"); }),
            file.string() +
                ": cannot be written: No such file or directory.\n"
                "  Check that its folder exists and may be written to, or give another folder with -o.");
}
