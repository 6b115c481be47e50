#include <gtest/gtest.h>

#include "scene/messages.h"

namespace similitude {
namespace {

TEST(InputError, SaysWhereWhatAndHowToMendIt) {
  EXPECT_STREQ(
      InputError({"spout.yaml", 14, 28}, "scene.patches.spout.x", "67.5 mm is not on a cell face.", "Use 65 mm.")
          .what(),
      "spout.yaml:14:28: scene.patches.spout.x: 67.5 mm is not on a cell face.\n  Use 65 mm.");
}

TEST(InputError, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(InputError({"--set", 0, 0}, "time.end", "no.").what(), "--set: time.end: no.");
  EXPECT_STREQ(InputError("bed.csv: there is no such file.", "Look\nagain.").what(),
               "bed.csv: there is no such file.\n  Look\n  again.");
  EXPECT_STREQ(InputError({}, "time.end", "no.").what(), "time.end: no.");
}

TEST(NearestName, FindsAWordWithinAThirdOfItsLength) {
  const std::vector<std::string> names{"diameter", "density", "count", "x", "y", "rest"};
  EXPECT_EQ(nearest_name("diamter", names), "diameter");
  EXPECT_EQ(nearest_name("denisty", names), "density");
  EXPECT_EQ(nearest_name("cuont", names), "count");
  EXPECT_EQ(nearest_name("radius", names), "");
  EXPECT_EQ(nearest_name("z", names), "");  // one edit from x, but sharing nothing with it
}

}  // namespace
}  // namespace similitude
