// Every way a file can fail to be a plugin, and the words the user gets. The texts are meant literally.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <similitude/plugin.h>
#include <sys/stat.h>

#include "cage.h"
#include "loader/describe.h"
#include "loader/processor.h"

namespace similitude {
namespace {

using zoo::Cage;

std::string text_of_layout_hash() {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", abi::layout_hash());
  return text;
}

const std::string k_rebuild =
    "Rebuild it against this program: cmake -B build -Dsimilitude_DIR=<prefix>/lib/cmake/similitude && cmake --build "
    "build";
const std::string k_this_program = std::string(" | program: ") + compiler() + ", " + instruction_set() + ")";
const std::string k_both_sides = "\n(plugin: zoo 1.0.0, x86-64" + k_this_program;

/// The one refusal of a cage with one inmate.
RefusedFile refused(const Cage& cage) {
  const Catalogue catalogue = cage.catalogue();
  EXPECT_TRUE(catalogue.plugins().empty());
  EXPECT_EQ(catalogue.refused().size(), 1u);
  return catalogue.refused().empty() ? RefusedFile{} : catalogue.refused().front();
}

void expect_refusal(const std::string& creature, const std::string& reason, const std::string& fix) {
  Cage cage;
  const RefusedFile file = refused(cage.add(creature));
  EXPECT_EQ(file.file, cage.path("drag_" + creature + ".so"));
  EXPECT_EQ(file.reason, reason);
  EXPECT_EQ(file.fix, fix);
}

TEST(Zoo, ASoundPluginIsTaken) {
  Cage cage;
  const Catalogue catalogue = cage.add("sound").catalogue();
  EXPECT_TRUE(catalogue.refused().empty());
  const PluginEntry* sound = catalogue.find("drag", "sound");
  ASSERT_NE(sound, nullptr);
  EXPECT_EQ(sound->file, cage.path("drag_sound.so"));
  EXPECT_EQ(sound->level, "user folder");
  EXPECT_STREQ(sound->descriptor->title, "A creature of the zoo");
}

TEST(Zoo, ALibraryWithoutATagIsNoPlugin) {
  expect_refusal(
      "no_tag", "it is no plugin: it has no section .similitude_tag.",
      "Build it with similitude_add_plugin() and name its model with a macro such as SIMILITUDE_DRAG_LAW, or move it "
      "elsewhere.");
}

TEST(Zoo, ATagWithoutAnEntrySymbolIsRefused) {
  expect_refusal("no_entry", "it does not export similitude_plugin.",
                 "Build it with similitude_add_plugin(), which keeps this one symbol visible.");
}

TEST(Zoo, ATagOfAnotherSizeIsRefused) {
  expect_refusal("short_tag", "its tag has 24 bytes, this program reads 104.", k_rebuild);
}

TEST(Zoo, ATagWithAnotherMagicIsNotOurs) {
  expect_refusal(
      "wrong_magic", "its tag starts with \"XIMILTD\", not with \"SIMILTD\".",
      "Build it with similitude_add_plugin() and name its model with a macro such as SIMILITUDE_DRAG_LAW, or move it "
      "elsewhere.");
}

TEST(Zoo, AnotherMajorIsRefusedWithBothSides) {
  expect_refusal("other_major", "built for plugin ABI 7.1, this program offers ABI 0.1.", k_rebuild + k_both_sides);
}

TEST(Zoo, ANewerMinorIsRefusedWithBothSides) {
  expect_refusal("newer_minor", "built for plugin ABI 0.99, this program offers ABI 0.1.",
                 "Update Similitude, or build the plugin for this one.\n" + k_rebuild + k_both_sides);
}

TEST(Zoo, AnotherLayoutIsRefusedWithBothHashes) {
  expect_refusal("other_layout",
                 "built for plugin ABI 0.1 with another layout of its structures (deadbeef, this program's is " +
                     text_of_layout_hash() + ").",
                 k_rebuild + k_both_sides);
}

TEST(Zoo, AnInstructionSetThatTheProcessorLacksIsRefusedBeforeAnythingRuns) {
  const std::string here = processor_instruction_set();
  expect_refusal("missing_instructions", "built for the instruction set x86-64-v9, this processor has " + here + ".",
                 "Rebuild it for this processor: cmake -B build -DSIMILITUDE_MARCH=" + here +
                     " && cmake --build build\n(plugin: zoo 1.0.0, x86-64-v9" + k_this_program);
}

TEST(Zoo, AnUndefinedSymbolIsNamed) {
  expect_refusal("undefined_symbol", "the system cannot load it: undefined symbol: defined_nowhere.",
                 "Link what defines the symbol: similitude_add_plugin(… LINKS …) finds it missing at build time.");
}

TEST(Zoo, AChangedControlWordIsRefusedAndSetBack) {
  const std::uint32_t before = floating_point_control();
  expect_refusal(
      "flush_to_zero",
      "loading it changed the processor's floating-point control word from 0x1f80 to 0x9fc0; it was set back.",
      "Rebuild it without -ffast-math and -Ofast, whose start-up code flushes small numbers to zero in the whole "
      "program.");
  EXPECT_EQ(floating_point_control(), before);
}

TEST(Zoo, AChangedControlWordIsRefusedAgainAlthoughStartUpCodeRunsOnce) {
  Cage cage;
  cage.add("flush_to_zero");
  EXPECT_EQ(refused(cage).reason, refused(cage).reason);
}

TEST(Zoo, ADefaultOutsideItsRangeIsRefused) {
  expect_refusal("bad_default",
                 "drag model \"bad_default\": parameter \"factor\": default 5 is outside its range [0, 1].",
                 "This is for the plugin's author to mend. The macros of the SDK's headers fill these tables.");
}

TEST(Zoo, ATextFileIsNoLibrary) {
  Cage cage;
  const RefusedFile file = refused(cage.write("drag_note.so", "I am a library, honestly.\n"));
  EXPECT_EQ(file.reason, "it is not a library (no ELF file).");
  EXPECT_EQ(file.fix, "Build the plugin with similitude_add_plugin(), or remove the file.");
}

TEST(Zoo, AnEmptyFileIsNoLibrary) {
  Cage cage;
  EXPECT_EQ(refused(cage.write("drag_empty.so", "")).reason, "it is not a library (no ELF file).");
}

// A download that broke off, or a build that ran out of disk: the ELF header is there, the section table is not.
TEST(Zoo, ATruncatedLibraryIsRefusedInWords) {
  Cage cage;
  cage.add("sound");
  std::filesystem::resize_file(cage.path("drag_sound.so"), 4096);
  EXPECT_EQ(refused(cage).reason, "it is no plugin: it has no section .similitude_tag.");
}

TEST(Zoo, ADanglingLinkNamesWhereItPoints) {
  Cage cage;
  std::filesystem::create_symlink("/nowhere/drag_law.so", cage.path("drag_law.so"));
  const RefusedFile file = refused(cage);
  EXPECT_EQ(file.reason, "it is a symbolic link to /nowhere/drag_law.so, which is not there.");
  EXPECT_EQ(file.fix, "Point the link to the library, or remove it.");
}

TEST(Zoo, AFolderThatIsCalledLikeALibraryIsRefused) {
  Cage cage;
  std::filesystem::create_directory(cage.path("x.so"));
  const RefusedFile file = refused(cage);
  EXPECT_EQ(file.reason, "it is a folder, not a library.");
  EXPECT_EQ(file.fix, "Move it elsewhere, or name the folder itself under plugin_paths.");
}

TEST(Zoo, APipeIsRefusedInsteadOfWaitedFor) {
  Cage cage;
  ASSERT_EQ(mkfifo(cage.path("x.so").c_str(), 0600), 0);
  EXPECT_EQ(refused(cage).reason, "it is not a regular file.");
}

TEST(Zoo, AFileThatMayNotBeReadIsRefused) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  Cage cage;
  cage.add("sound");
  std::filesystem::permissions(cage.path("drag_sound.so"), std::filesystem::perms::none);
  EXPECT_EQ(refused(cage).reason, "it cannot be read: Permission denied.");
}

TEST(Zoo, OneBadNeighbourSpoilsNothing) {
  Cage cage;
  const Catalogue catalogue = cage.add("sound").add("flush_to_zero").add("other_major").write("a.so", "").catalogue();
  EXPECT_THAT(catalogue.ids("drag"), testing::ElementsAre("sound"));
  EXPECT_EQ(catalogue.refused().size(), 3u);
}

}  // namespace
}  // namespace similitude
