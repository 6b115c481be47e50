// Which file wins, and what is said when none does.

#include "loader/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cage.h"

namespace similitude {
namespace {

using zoo::Cage;
using zoo::error_of;
using Levels = std::vector<SearchLevel>;

TEST(Catalogue, TheNearerLevelWinsAndSaysWhatItHides) {
  Cage near, far;
  near.add("sound");
  far.add("twin");
  const Catalogue catalogue(Levels{near.level("plugin_paths of the case"), far.level("install folder")});
  ASSERT_EQ(catalogue.plugins().size(), 1u);
  EXPECT_EQ(catalogue.plugins()[0].file, near.path("drag_sound.so"));
  EXPECT_EQ(catalogue.plugins()[0].level, "plugin_paths of the case");
  EXPECT_EQ(catalogue.plugins()[0].hides, far.path("drag_twin.so"));
}

TEST(Catalogue, TheSameIdTwiceInOneFolderNamesBothFiles) {
  Cage cage;
  cage.add("sound").add("twin");
  EXPECT_EQ(error_of([&] { cage.catalogue(); }),
            "two files offer the drag model \"sound\": " + cage.path("drag_sound.so") + " and " +
                cage.path("drag_twin.so") +
                " (both found by user folder).\n"
                "  Remove one of them, or move the one that is meant to a nearer level of the search.");
}

TEST(Catalogue, TwoFoldersOfOneLevelAreOneLevel) {
  Cage one, other;
  one.add("sound");
  other.add("twin");
  EXPECT_EQ(error_of([&] {
              Catalogue(Levels{one.level("SIMILITUDE_PLUGIN_PATH"), other.level("SIMILITUDE_PLUGIN_PATH")});
            }),
            "two files offer the drag model \"sound\": " + one.path("drag_sound.so") + " and " +
                other.path("drag_twin.so") +
                " (both found by SIMILITUDE_PLUGIN_PATH).\n"
                "  Remove one of them, or move the one that is meant to a nearer level of the search.");
}

TEST(Catalogue, AFolderNamedTwiceCountsOnceWhereItIsNearest) {
  Cage cage;
  cage.add("sound");
  const Catalogue catalogue(Levels{cage.level("plugin_paths of the case"), cage.level("install folder")});
  ASSERT_EQ(catalogue.plugins().size(), 1u);
  EXPECT_EQ(catalogue.plugins()[0].level, "plugin_paths of the case");
  EXPECT_EQ(catalogue.plugins()[0].hides, "");
}

TEST(Catalogue, ALinkToALibraryIsThatLibrary) {
  Cage cage;
  cage.add("sound");
  std::filesystem::create_symlink(cage.path("drag_sound.so"), cage.path("drag_zebra.so"));
  EXPECT_EQ(cage.catalogue().plugins().size(), 1u);
}

TEST(Catalogue, AMissingFolderIsToldOnlyIfSomebodyNamedIt) {
  const Catalogue catalogue(
      Levels{{"plugin_paths of the case", "/nowhere/plugins", true}, {"user folder", "/nowhere/else"}});
  ASSERT_EQ(catalogue.refused().size(), 1u);
  EXPECT_EQ(catalogue.refused()[0].file, "/nowhere/plugins");
  EXPECT_EQ(catalogue.refused()[0].reason, "there is no such folder, and plugin_paths of the case names it.");
  EXPECT_EQ(catalogue.refused()[0].fix, "Correct the path, or leave it out.");
}

TEST(Catalogue, AWrongLetterIsAnsweredWithTheNearestModel) {
  Cage cage;
  cage.add("sound");
  EXPECT_EQ(error_of([&] { cage.catalogue().throw_no_such_model("drag", "sund"); }),
            "there is no drag model \"sund\".\n"
            "  Did you mean \"sound\" (1.0.0, from " +
                cage.path("drag_sound.so") +
                ")?\n"
                "  Drag models found: sound.\n"
                "  Searched: " +
                cage.folder().string() + " (user folder).");
}

TEST(Catalogue, AMissingModelNamesTheRefusedFilesThatMayContainIt) {
  Cage cage;
  cage.add("other_major").write("contact_note.so", "").write("mine.so", "");
  EXPECT_EQ(error_of([&] { cage.catalogue().throw_no_such_model("drag", "org.example.mine"); }),
            "there is no drag model \"org.example.mine\".\n"
            "  Drag models found: none.\n"
            "  2 files were refused and may contain it (`similitude plugins failures` says what to do):\n"
            "    " +
                cage.path("drag_other_major.so") +
                ": built for plugin ABI 7.0, this program offers ABI 1.0.\n"
                "    " +
                cage.path("mine.so") +
                ": it is not a library (no ELF file).\n"
                "  Searched: " +
                cage.folder().string() + " (user folder).");
}

TEST(Catalogue, WithoutAKindAnyModelIsOffered) {
  Cage cage;
  cage.add("sound");
  EXPECT_EQ(error_of([&] { cage.catalogue().throw_no_such_model("", "gidaspow"); }),
            "there is no model \"gidaspow\".\n"
            "  Models found: sound.\n"
            "  Searched: " +
                cage.folder().string() + " (user folder).");
}

TEST(Catalogue, FindsByKindAndId) {
  Cage cage;
  const Catalogue catalogue = cage.add("sound").catalogue();
  EXPECT_NE(catalogue.find("drag", "sound"), nullptr);
  EXPECT_EQ(catalogue.find("contact", "sound"), nullptr);
  EXPECT_THAT(catalogue.ids("contact"), testing::IsEmpty());
}

TEST(Catalogue, OfOneFileKnowsThatFileAlone) {
  Cage cage;
  cage.add("sound").add("twin");
  const Catalogue good = Catalogue::of_file(cage.path("drag_twin.so"));
  EXPECT_THAT(good.ids("drag"), testing::ElementsAre("sound"));
  const Catalogue missing = Catalogue::of_file(cage.path("drag_none.so"));
  ASSERT_EQ(missing.refused().size(), 1u);
  EXPECT_EQ(missing.refused()[0].reason, "it cannot be read: No such file or directory.");
}

}  // namespace
}  // namespace similitude
