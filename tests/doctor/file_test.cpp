// The file itself, before any model is asked: what cannot be loaded, what falls over while it is, and the report's form.

#include <nlohmann/json.hpp>

#include "patient.h"

namespace similitude::doctor {
namespace {

std::string animal(const std::string& name) { return std::string(ZOO_FOLDER) + "/drag_" + name + ".so"; }

TEST(Doctor, TellsOfAFileThatIsNotThere) {
  const Examination examination = examine("/nowhere/drag_law.so");
  EXPECT_EQ(outcome(examination, "", "tag").seen, "it cannot be read: No such file or directory.");
  EXPECT_EQ(examination.findings.size(), 1u);
}

TEST(Doctor, TellsOfAnotherAbiWithoutLoadingTheFile) {
  const Examination examination = examine(animal("other_major"));
  EXPECT_EQ(outcome(examination, "", "tag").verdict, Verdict::ok);
  EXPECT_THAT(outcome(examination, "", "fits").seen, testing::StartsWith("built for plugin ABI 7.0, this program offers ABI "));
  EXPECT_EQ(examination.findings.size(), 2u);
}

TEST(Doctor, TellsWhatTheLoaderRefuses) {
  const Examination examination = examine(animal("bad_default"));
  EXPECT_EQ(outcome(examination, "", "loads").seen, "drag model \"bad_default\": parameter \"factor\": default 5 is outside its range [0, 1].");
  EXPECT_EQ(outcome(examination, "", "loads").advice,
            "This is for the plugin's author to mend. The macros of the SDK's headers fill these tables.");
}

TEST(Doctor, SurvivesAFileThatCrashesWhileItIsLoaded) {
  const Examination examination = examine(library("drag_start_up"));
  EXPECT_EQ(outcome(examination, "", "loads").seen, "it crashes: it touches memory that is not its own.");
  EXPECT_EQ(outcome(examination, "", "loads").advice,
            "Run the check under a debugger: gdb --args similitude plugins doctor FILE, with set follow-fork-mode child. "
            "It happens while the file is loaded, in its start-up code.");
  EXPECT_EQ(examination.findings.size(), 3u);
}

TEST(Doctor, ReportsALinePerCheckAndWhatToDoUnderWhatFailed) {
  const Examination examination{"/home/me/drag_law.so",
                                {{"", "tag", ok("plugin ABI 1.0")},
                                 {"drag model law", "made", ok("with its defaults")},
                                 {"drag model law", "limits", fail("K steps.\nTwice.", "Mend it.")},
                                 {"drag model law", "threads", skipped("\"limits\" failed")}}};
  EXPECT_EQ(examination_text(examination),
            "/home/me/drag_law.so\n"
            "\n"
            "file\n"
            "  ok       tag      plugin ABI 1.0\n"
            "\n"
            "drag model law\n"
            "  ok       made     with its defaults\n"
            "  FAIL     limits   K steps.\n"
            "                    Twice.\n"
            "                    Mend it.\n"
            "  skipped  threads  \"limits\" failed\n"
            "\n"
            "Not healthy: 1 of 3 checks failed, 1 skipped.\n");
  const nlohmann::json page = examination_json(examination);
  EXPECT_EQ(page["file"], "/home/me/drag_law.so");
  EXPECT_EQ(page["healthy"], false);
  EXPECT_EQ(page["findings"][0], nlohmann::json({{"model", nullptr}, {"check", "tag"}, {"verdict", "ok"}, {"seen", "plugin ABI 1.0"}, {"advice", ""}}));
  EXPECT_EQ(page["findings"][2]["verdict"], "FAIL");
}

}  // namespace
}  // namespace similitude::doctor
