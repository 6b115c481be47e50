// From a scene to faces, and the words for what does not fit.
#include <gtest/gtest.h>

#include "fluid/grid.h"
#include "scene/messages.h"

namespace similitude {
namespace {

constexpr Face k_bottom{Axis::z, Side::low}, k_top{Axis::z, Side::high};

Patch patch(const std::string& name, Face face, Interval x, Interval y) {
  Patch made;
  made.name = name;
  made.face = face;
  made.extent = {x, y, {}};
  made.mark = {"spout.yaml", 14, 28};
  return made;
}

/// 150 x 20 x 1000 mm in cells of 5 mm: the spouted bed.
RealScene bed() {
  RealScene scene;
  scene.size = {0.15, 0.02, 1};
  scene.cell = {0.005, 0.005, 0.005};
  Patch spout = patch("spout", k_bottom, {0.07, 0.08}, {0, 0.02});
  spout.velocity = 13.2;
  spout.ramp = 0.05;
  Patch background = patch("background", k_bottom, {}, {});
  background.rest = true;
  background.velocity = 0.46;
  Patch outlet = patch("outlet", k_top, {0, 0.15}, {0, 0.02});
  outlet.kind = PatchKind::pressure;
  scene.patches = {background, spout, outlet};
  Baffle plate;
  plate.name = "plates";
  plate.position = 0.06;
  plate.extent = {Interval{}, Interval{0, 0.02}, Interval{0.03, 0.25}};
  plate.mark = {"spout.yaml", 18, 12};
  scene.baffles = {plate};
  return scene;
}

std::string refusal(const RealScene& scene) {
  try {
    const Grid grid(scene);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "accepted";
}

int kind(const Grid& grid, int axis, int i, int j, int k) { return grid.face_kind(axis, grid.face(axis, i, j, k)); }

TEST(Grid, LaysPatchesWallsAndBafflesOnFaces) {
  const Grid grid(bed());
  EXPECT_EQ(grid.cells(0), 30);
  EXPECT_EQ(grid.cells(1), 4);
  EXPECT_EQ(grid.cells(2), 200);
  EXPECT_EQ(grid.cell_count(), 24000u);
  EXPECT_NEAR(grid.cell_volume(), 1.25e-7, 1e-20);
  const similitude_grid& table = grid.table();
  ASSERT_EQ(table.patch_count, 3u);
  EXPECT_STREQ(table.patches[1].name, "spout");
  EXPECT_EQ(table.patches[1].velocity[2], 13.2);
  EXPECT_EQ(table.patches[1].ramp, 0.05);
  for (int i = 0; i < 30; ++i) {
    const bool spout = i == 14 || i == 15;
    EXPECT_EQ(kind(grid, 2, i, 2, 0), SIMILITUDE_FACE_PATCH + (spout ? 1 : 0)) << i;  // `rest` takes what is left
    EXPECT_EQ(kind(grid, 2, i, 0, 200), SIMILITUDE_FACE_PATCH + 2);
  }
  EXPECT_EQ(kind(grid, 0, 0, 1, 50), SIMILITUDE_FACE_NO_SLIP);
  EXPECT_EQ(kind(grid, 0, 30, 1, 50), SIMILITUDE_FACE_NO_SLIP);
  for (int k = 0; k < 200; ++k) {
    EXPECT_EQ(kind(grid, 0, 12, 3, k), k >= 6 && k < 50 ? SIMILITUDE_FACE_NO_SLIP : SIMILITUDE_FACE_OPEN) << k;
    EXPECT_TRUE(grid.open(0, grid.face(0, 11, 3, k)));
  }
}

TEST(Grid, OpensPeriodicSidesAndSlipsWhereAsked) {
  RealScene scene = bed();
  scene.patches.clear();
  scene.baffles.clear();
  scene.periodic = {true, false, false};
  scene.walls[1] = {WallKind::slip, WallKind::no_slip};
  const Grid grid(scene);
  EXPECT_TRUE(grid.periodic(0));
  EXPECT_EQ(kind(grid, 0, 0, 0, 0), SIMILITUDE_FACE_OPEN);
  EXPECT_EQ(kind(grid, 0, 30, 0, 0), SIMILITUDE_FACE_OPEN);
  EXPECT_EQ(kind(grid, 1, 3, 0, 0), SIMILITUDE_FACE_SLIP);
  EXPECT_EQ(kind(grid, 1, 3, 4, 0), SIMILITUDE_FACE_NO_SLIP);
}

TEST(Grid, BlowsIntoTheDomainFromEitherSide) {
  RealScene scene = bed();
  scene.patches[2].kind = PatchKind::velocity;
  scene.patches[2].velocity = 2;
  EXPECT_EQ(Grid(scene).table().patches[2].velocity[2], -2);
}

TEST(Grid, NamesTheNearestAlignedPatch) {
  RealScene scene = bed();
  scene.patches[1].extent[0] = {0.0675, 0.08};
  EXPECT_EQ(refusal(scene),
            "spout.yaml:14:28: scene.patches.spout.x: 67.5 mm is not on a cell face (cells of 5 mm, faces at 65 mm and 70 mm).\n"
            "  Use [65 mm, 80 mm] or [70 mm, 80 mm], or set scene.domain.cell: 2.5 mm.");
}

TEST(Grid, TakesPositionsThatOnlyRoundingMoved) {
  RealScene scene = bed();
  scene.patches[1].extent[0] = {0.07 + 1e-9, 0.08 - 1e-9};
  EXPECT_EQ(refusal(scene), "accepted");
}

TEST(Grid, RefusesAPatchThatSticksOutOfItsFace) {
  RealScene scene = bed();
  scene.patches[1].extent[0] = {0.14, 0.16};
  EXPECT_EQ(refusal(scene),
            "spout.yaml:14:28: scene.patches.spout.x: [140 mm, 160 mm] sticks out of the bottom face (0 mm to 150 mm).\n"
            "  Use [140 mm, 150 mm].");
}

TEST(Grid, NamesBothPatchesThatOverlap) {
  RealScene scene = bed();
  scene.patches[0].rest = false;
  scene.patches[0].extent = {Interval{0, 0.075}, Interval{0, 0.02}, Interval{}};
  EXPECT_EQ(refusal(scene),
            "spout.yaml:14:28: scene.patches.spout: overlaps background on the bottom face.\n"
            "  Shrink one of them, or let one take what is left: rest: true.");
}

TEST(Grid, RefusesBafflesBetweenFacesAndOutside) {
  RealScene scene = bed();
  scene.baffles[0].position = 0.062;
  EXPECT_EQ(refusal(scene),
            "spout.yaml:18:12: scene.baffles.plates.at_x: 62 mm is not on a cell face "
            "(cells of 5 mm, faces at 60 mm and 65 mm).\n"
            "  Use 60 mm or 65 mm, or set scene.domain.cell: 1 mm.");
  scene.baffles[0].position = 0.15;
  EXPECT_EQ(refusal(scene),
            "spout.yaml:18:12: scene.baffles.plates.at_x: 150 mm is not inside the domain (0 mm to 150 mm).\n"
            "  Move it inside: the sides of the domain are walls already.");
  scene.baffles[0].position = 0.06;
  scene.baffles[0].extent[2] = {0.03, 0.252};
  EXPECT_EQ(refusal(scene).substr(0, 70), "spout.yaml:18:12: scene.baffles.plates.z: 252 mm is not on a cell face");
}

TEST(Grid, RefusesADomainThatIsNotWholeCells) {
  RealScene scene = bed();
  scene.size[0] = 0.152;
  EXPECT_EQ(refusal(scene),
            "scene.domain.size: 152 mm in x is not a whole number of cells of 5 mm.\n"
            "  Use 150 mm or 155 mm, or another scene.domain.cell.");
}

}  // namespace
}  // namespace similitude
