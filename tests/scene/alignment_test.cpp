#include <gtest/gtest.h>

#include "scene/alignment.h"

namespace similitude {
namespace {

constexpr double mm = 1e-3;

TEST(Alignment, FindsTheFacesOnBothSides) {
  const Aligned between = align(67.5 * mm, 5 * mm);
  EXPECT_FALSE(between.ok);
  EXPECT_DOUBLE_EQ(between.low, 65 * mm);
  EXPECT_DOUBLE_EQ(between.high, 70 * mm);
}

// 70 mm / 5 mm is not 14 in doubles; rounding must not push anybody off a face.
TEST(Alignment, ForgivesRounding) {
  for (int face = 0; face <= 400; ++face) {
    EXPECT_TRUE(align(face * 0.0025, 0.0025).ok) << face;
    EXPECT_TRUE(align(face / 400.0, 0.0025).ok) << face;
  }
}

TEST(Alignment, ScalesWithPowersOfTwo) {
  const Aligned real = align(0.0675, 0.005), quarter = align(0.0675 / 4, 0.005 / 4);
  EXPECT_EQ(quarter.ok, real.ok);
  EXPECT_EQ(quarter.low, real.low / 4);
  EXPECT_EQ(quarter.high, real.high / 4);
}

TEST(Alignment, TextsNameFacesAndWhatToType) {
  EXPECT_EQ(off_face_text(67.5 * mm, 5 * mm),
            "67.5 mm is not on a cell face (cells of 5 mm, faces at 65 mm and 70 mm).");
  EXPECT_EQ(off_face_fix(Interval{67.5 * mm, 80 * mm}, 5 * mm),
            "Use [65 mm, 80 mm] or [70 mm, 80 mm], or set scene.domain.cell: 2.5 mm.");
  EXPECT_EQ(off_face_fix(Interval{70 * mm, 82 * mm}, 5 * mm),
            "Use [70 mm, 80 mm] or [70 mm, 85 mm], or set scene.domain.cell: 1 mm.");
  EXPECT_EQ(off_face_fix(Interval{67.5 * mm, 82.5 * mm}, 5 * mm),
            "Use [65 mm, 85 mm] or [70 mm, 80 mm], or set scene.domain.cell: 2.5 mm.");
  EXPECT_EQ(off_face_fix(Interval{67.123 * mm, 80 * mm}, 5 * mm), "Use [65 mm, 80 mm] or [70 mm, 80 mm].");
  EXPECT_EQ(off_face_fix(Interval{70 * mm, 82 * mm}, 5 * mm, 2 * mm), "Use [70 mm, 80 mm] or [70 mm, 85 mm].");   // 1 mm is below a grain
  EXPECT_EQ(off_face_fix(62.5 * mm, 5 * mm), "Use 60 mm or 65 mm, or set scene.domain.cell: 2.5 mm.");
}

// An interval within one cell must not be turned into an empty one.
TEST(Alignment, OffersNoEmptyInterval) {
  EXPECT_EQ(off_face_fix(Interval{71 * mm, 74 * mm}, 5 * mm), "Use [70 mm, 75 mm], or set scene.domain.cell: 1 mm.");
}

}  // namespace
}  // namespace similitude
