// Every way a file can fail to be a plugin, and the words the user gets. The texts are meant literally.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <similitude/plugin.h>
#include <sys/stat.h>

#include <cmath>

#include "cage.h"
#include "loader/contact_answers.h"
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
    "Rebuild it against this program: cmake -B build -DCMAKE_PREFIX_PATH=<prefix> && cmake --build build";
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
  expect_refusal("other_major", "built for plugin ABI 7.0, this program offers ABI 1.0.", k_rebuild + k_both_sides);
}

TEST(Zoo, ANewerMinorIsRefusedWithBothSides) {
  expect_refusal("newer_minor", "built for plugin ABI 1.99, this program offers ABI 1.0.",
                 "Update Similitude, or build the plugin for this one.\n" + k_rebuild + k_both_sides);
}

TEST(Zoo, AnotherLayoutIsRefusedWithBothHashes) {
  expect_refusal("other_layout",
                 "built for plugin ABI 1.0 with another layout of its structures (deadbeef, this program's is " +
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

TEST(Zoo, AMissingFunctionIsNamed) {
  expect_refusal("no_function", "drag model \"no_function\": its function exchange is missing.",
                 "This is for the plugin's author to mend. The macros of the SDK's headers fill these tables.");
}

TEST(Zoo, AnExceptionOutOfCreateIsARefusal) {
  Cage cage;
  const Catalogue catalogue = cage.add("throws_in_create").catalogue();
  EXPECT_EQ(zoo::error_of([&] {
              create_model<similitude_drag_functions>(*catalogue.find("drag", "throws_in_create"), similitude_bed{}, {{0.5, nullptr}});
            }),
            "drag model \"throws_in_create\" cannot be created: it let an exception out of create(), which its author must "
            "catch: the fuse was short.\n  (from " +
                cage.path("drag_throws_in_create.so") + ", version 1.0.0)");
}

/// One block of eight rows at a drag law of the cage's bad_block.
struct BlockAnswer {
  similitude_status status{};
  double exchange[8] = {};
};

BlockAnswer answer_to_a_block(const char* id) {
  Cage cage;
  const Catalogue catalogue = cage.add("bad_block").catalogue();
  const DragModel law = create_model<similitude_drag_functions>(*catalogue.find("drag", id), similitude_bed{}, {});
  alignas(64) const double ones[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  BlockAnswer answer;
  alignas(64) double exchange[8] = {};
  const similitude_drag_block block = {sizeof block, 8, ones, ones, ones, ones, ones, nullptr, nullptr, exchange};
  law.functions().exchange(law.instance(), &block, &answer.status);
  std::copy(exchange, exchange + 8, answer.exchange);
  return answer;
}

TEST(Zoo, WhatALawThrowsInABlockComesBackInItsOwnWords) {
  const BlockAnswer answer = answer_to_a_block("throws_in_a_block");
  EXPECT_EQ(answer.status.code, 1);
  EXPECT_STREQ(answer.status.text, "this gas is too thin for me.\n  Use a thicker one.");
}

// That the host refuses it, and names particle, place and step, is tested with the command.
TEST(Zoo, ANumberThatIsNoneComesBackAsOne) {
  const BlockAnswer answer = answer_to_a_block("returns_nan");
  EXPECT_EQ(answer.status.code, 0);
  for (const double k : answer.exchange) EXPECT_TRUE(std::isnan(k));
}

TEST(Zoo, WhatAContactLawThrowsBeforeARunIsRefusedAfterItsOwnWords) {
  Cage cage;
  const Catalogue catalogue = cage.add("throws_in_setup").catalogue();
  const ContactModel law = create_model<similitude_contact_functions>(*catalogue.find("contact", "throws_in_setup"), similitude_bed{}, {});
  const HeadOnImpact impact{.effective_mass = 2.5e-7, .effective_radius = 2.5e-4, .speed = 0.5};
  const std::string fix =
      "\n  This is for the plugin's author to mend: `similitude plugins doctor` on its file says more. If the law threw, its "
      "words stand above.";
  testing::internal::CaptureStderr();
  EXPECT_EQ(zoo::error_of([&] { contact_time_of(law, impact); }),
            "contact model \"throws_in_setup\": its contact time is not a number for an impact at 0.5 m/s of an effective mass of "
            "2.5e-07 kg and radius of 0.00025 m." + fix);
  EXPECT_EQ(zoo::error_of([&] { largest_stable_step_of(law, impact); }),
            "contact model \"throws_in_setup\": its largest stable step is not a number for an impact at 0.5 m/s of an effective "
            "mass of 2.5e-07 kg and radius of 0.00025 m." + fix);
  EXPECT_EQ(zoo::error_of([&] { reach_of(law, 1e-3); }),
            "contact model \"throws_in_setup\": its reach is not a number for a diameter of 0.001 m." + fix);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "warning: contact_time: I have no watch.\nwarning: largest_stable_step: I do not step.\nwarning: reach: I do not reach "
            "out.\n");
}

TEST(Zoo, AContactLawThatWillNotSayWhatItNeedsIsNotCreated) {
  Cage cage;
  const Catalogue catalogue = cage.add("throws_in_setup").catalogue();
  EXPECT_EQ(zoo::error_of([&] {
              create_model<similitude_contact_functions>(*catalogue.find("contact", "throws_when_asked_what_it_needs"),
                                                         similitude_bed{}, {});
            }),
            "contact model \"throws_when_asked_what_it_needs\" cannot be created: whether I turn is nobody's business.\n  (from " +
                cage.path("drag_throws_in_setup.so") + ", version 1.0.0)");
}

template <class Functions>
std::string refusal_of(const Cage& cage, const char* kind, const char* id) {
  const Catalogue catalogue = cage.catalogue();
  return zoo::error_of([&] { create_model<Functions>(*catalogue.find(kind, id), similitude_bed{}, {}); });
}

TEST(Zoo, AnEffectThatWillNotSayWhatItNeedsIsNotCreated) {
  Cage cage;
  cage.add("throws_when_asked");
  for (const auto& [id, words] : {std::pair{"will_not_read", "I do not read."}, std::pair{"will_not_add", "I do not add."},
                                  std::pair{"will_not_remember", "I forgot whether I do."}, std::pair{"has_no_partners", "I dance alone."},
                                  std::pair{"has_no_conflicts", "I quarrel with nobody."}, std::pair{"uses_nothing", "I am of no use."}}) {
    EXPECT_EQ(refusal_of<similitude_effect_functions>(cage, "effect", id),
              std::string("effect model \"") + id + "\" cannot be created: " + words + "\n  (from " + cage.path("drag_throws_when_asked.so") +
                  ", version 1.0.0)");
  }
}

TEST(Zoo, AGasSolverThatWillNotSayWhatItNeedsIsNotCreated) {
  Cage cage;
  cage.add("throws_when_asked");
  EXPECT_EQ(refusal_of<similitude_fluid_functions>(cage, "fluid", "needs_nothing"),
            "fluid model \"needs_nothing\" cannot be created: I am in want of nothing.\n  (from " + cage.path("drag_throws_when_asked.so") +
                ", version 1.0.0)");
}

TEST(Zoo, WhatAGasSolverThrowsOverItsStateIsRefusedAfterItsOwnWords) {
  Cage cage;
  const Catalogue catalogue = cage.add("throws_when_asked").catalogue();
  const auto made = [&](const char* id) { return create_model<similitude_fluid_functions>(*catalogue.find("fluid", id), similitude_bed{}, {}); };
  const std::string fix = "\n  This is for the plugin's author to mend. If the solver threw, its words stand above.";
  std::vector<double> state;
  testing::internal::CaptureStderr();
  EXPECT_EQ(zoo::error_of([&] { save_state_of(made("cannot_count"), state); }),
            "fluid model \"cannot_count\": it does not say how many numbers it remembers." + fix);
  const FluidModel forgetful = made("forgetful");
  EXPECT_EQ(zoo::error_of([&] { save_state_of(forgetful, state); }), "fluid model \"forgetful\": it does not say what it remembers." + fix);
  forgetful.functions().load_state(forgetful.instance(), state.data());
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "warning: state_size: one, two, many.\nwarning: save_state: it has slipped my mind.\nwarning: load_state: that was somebody "
            "else.\n");
  similitude_gas_step step{};
  step.struct_size = sizeof step;
  similitude_gas_report report{};
  report.struct_size = sizeof report;
  similitude_status status{};
  forgetful.functions().advance(forgetful.instance(), &step, &report, &status);
  EXPECT_EQ(status.code, 1);
  EXPECT_STREQ(status.text, "load_state() failed, so that the gas would not go on as it was; what it threw stands above.");
}

TEST(Zoo, TwoFilesWithTheSameModelAreBothNamed) {
  Cage cage;
  cage.add("sound").add("twin");
  EXPECT_EQ(zoo::error_of([&] { cage.catalogue(); }),
            "two files offer the drag model \"sound\": " + cage.path("drag_sound.so") + " and " + cage.path("drag_twin.so") +
                " (both found by user folder).\n  Remove one of them, or move the one that is meant to a nearer level of the search.");
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

TEST(Zoo, LinksThatGoInACircleAreRefused) {
  Cage cage;
  std::filesystem::create_symlink("drag_b.so", cage.path("drag_a.so"));
  std::filesystem::create_symlink("drag_a.so", cage.path("drag_b.so"));
  const Catalogue catalogue = cage.catalogue();
  ASSERT_EQ(catalogue.refused().size(), 2u);
  EXPECT_EQ(catalogue.refused()[0].reason, "it is a symbolic link to drag_b.so in a circle of links.");
  EXPECT_EQ(catalogue.refused()[0].fix, "Point the link to the library, or remove it.");
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

/// Root may read everything, so root becomes nobody while `work` is done.
template <class Work>
void as_a_common_user(Work&& work) {
  constexpr uid_t nobody = 65534;
  const bool root = geteuid() == 0;
  if (root) {
    ASSERT_EQ(seteuid(nobody), 0);
  }
  work();
  if (root) {
    ASSERT_EQ(seteuid(0), 0);
  }
}

TEST(Zoo, AFileThatMayNotBeReadIsRefused) {
  Cage cage;
  cage.add("sound");
  using std::filesystem::perms;
  std::filesystem::permissions(cage.folder(), perms::group_read | perms::group_exec | perms::others_read | perms::others_exec,
                               std::filesystem::perm_options::add);
  std::filesystem::permissions(cage.path("drag_sound.so"), std::filesystem::perms::none);
  as_a_common_user([&] {
    const RefusedFile file = refused(cage);
    EXPECT_EQ(file.reason, "it cannot be read: Permission denied.");
    EXPECT_EQ(file.fix, "Make it readable to this user, or remove it.");
  });
}

TEST(Zoo, OneBadNeighbourSpoilsNothing) {
  Cage cage;
  const Catalogue catalogue = cage.add("sound").add("flush_to_zero").add("other_major").write("a.so", "").catalogue();
  EXPECT_THAT(catalogue.ids("drag"), testing::ElementsAre("sound"));
  EXPECT_EQ(catalogue.refused().size(), 3u);
}

}  // namespace
}  // namespace similitude
