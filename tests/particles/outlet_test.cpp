#include <gtest/gtest.h>

#include "beds.h"
#include "particles/surfaces.h"

namespace similitude {
namespace {
using namespace testing;

Patch patch(PatchKind kind, Face face, Interval x, Interval y, Interval z) {
  Patch out;
  out.name = "patch";
  out.kind = kind;
  out.face = face;
  out.extent = {x, y, z};
  return out;
}

const Face k_top{Axis::z, Side::high};
const Face k_bottom{Axis::z, Side::low};

/// A cube of 10 mm whose lid is an opening.
ModelScene open_cube() {
  ModelScene scene = box(0.01, 0.01, 0.01);
  scene.patches.push_back(patch(PatchKind::pressure, k_top, {0, 0.01}, {0, 0.01}, {0.01, 0.01}));
  return scene;
}

TEST(Outlets, LetParticlesLeaveAndCountThem) {
  const ModelScene scene = open_cube();
  ParticleStore store;
  for (std::size_t n = 0; n < 5; ++n) {
    const std::size_t row = add_sphere(store, 0.001 + 0.002 * static_cast<double>(n), 0.005, 0.009);
    store.velocity[row].z = n < 3 ? 1.0 : -0.001;
  }
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-5));
  engine.advance(90);
  EXPECT_EQ(store.size(), 5u);   // half a sphere through the opening feels nothing
  EXPECT_DOUBLE_EQ(store.velocity[row_of(store, 0)].z, 1.0);
  engine.advance(20);
  ASSERT_EQ(store.size(), 2u);
  EXPECT_EQ(row_of(store, 0), store.size());
  EXPECT_LT(row_of(store, 3), store.size());
  EXPECT_LT(row_of(store, 4), store.size());
  EXPECT_EQ(engine.report().removed, 3u);
  EXPECT_DOUBLE_EQ(engine.report().removed_mass, 3 * sphere_mass(0.5 * k_diameter));
  EXPECT_DOUBLE_EQ(engine.report().removed_volume, 3 * k_pi / 6 * k_diameter * k_diameter * k_diameter);
}

TEST(Outlets, NobodyIsSeenOutsideAfterAnAdvance) {
  const ModelScene scene = open_cube();
  ParticleStore store;
  add_sphere(store, 0.005, 0.005, 0.01 - 1e-5);
  store.velocity[0].z = 1;
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-6));
  engine.advance(9);
  EXPECT_EQ(store.size(), 1u);
  engine.advance(2);
  EXPECT_EQ(store.size(), 0u);
  engine.advance(5);   // an empty bed goes on
  EXPECT_EQ(engine.report().removed, 1u);
}

// Two that touch on the floor, and a third that leaves in the last sub-step: the lists are made anew after it.
TEST(Outlets, ContactsAreCountedWhenSomebodyLeavesInTheLastSubStep) {
  const ModelScene scene = open_cube();
  ParticleStore store;
  add_sphere(store, 0.005, 0.005, 0.01 - 1e-5);
  store.velocity[0].z = 1;
  add_sphere(store, 0.004, 0.005, 0.003);
  add_sphere(store, 0.004 + 0.999 * k_diameter, 0.005, 0.003);
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-6));
  engine.advance(10);
  ASSERT_EQ(store.size(), 3u);
  engine.advance(1);
  ASSERT_EQ(store.size(), 2u);
  EXPECT_EQ(engine.report().contacts, 1u);
}

TEST(Outlets, InletsAreWallsForParticles) {
  ModelScene scene = box(0.01, 0.01, 0.01);
  scene.patches.push_back(patch(PatchKind::velocity, k_bottom, {0.002, 0.008}, {0, 0.01}, {0, 0}));
  ParticleStore store;
  add_sphere(store, 0.005, 0.005, 0.0006);
  store.velocity[0].z = -0.3;
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(1e-6));
  engine.advance(500);
  EXPECT_NEAR(store.velocity[0].z, 0.3, 0.003);
  EXPECT_EQ(engine.report().removed, 0u);
}

TEST(Outlets, BesideAnOutletTheWallActs) {
  ModelScene scene = box(0.01, 0.01, 0.01);
  scene.patches.push_back(patch(PatchKind::pressure, k_top, {0, 0.005}, {0, 0.01}, {0.01, 0.01}));
  ParticleStore store;
  add_sphere(store, 0.002, 0.005, 0.0090);
  add_sphere(store, 0.008, 0.005, 0.0090);
  for (Row& v : store.velocity) v.z = 0.5;
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(2e-6));
  engine.advance(1500);
  ASSERT_EQ(store.size(), 1u);
  EXPECT_EQ(store.id[0], 1u);
  EXPECT_NEAR(store.velocity[0].z, -0.5, 0.005);
}

TEST(Outlets, TheRestOfAFaceMayBeTheOutlet) {
  ModelScene scene = box(0.01, 0.01, 0.01);
  scene.patches.push_back(patch(PatchKind::velocity, k_top, {0, 0.005}, {0, 0.01}, {0.01, 0.01}));
  Patch rest = patch(PatchKind::pressure, k_top, {0, 0}, {0, 0}, {0.01, 0.01});
  rest.rest = true;
  scene.patches.push_back(rest);
  ParticleStore store;
  add_sphere(store, 0.002, 0.005, 0.0090);
  add_sphere(store, 0.008, 0.005, 0.0090);
  for (Row& v : store.velocity) v.z = 0.5;
  const ContactModel law = make_law({});
  Engine engine(store, scene, law, options(2e-6));
  engine.advance(1500);
  ASSERT_EQ(store.size(), 1u);
  EXPECT_EQ(store.id[0], 0u);
}

// Half through an opening a sphere touches its rim. The push must set in from zero, not at the full depth.
TEST(Outlets, TheRimOfAnOpeningPushesSmoothly) {
  ModelScene scene = box(0.01, 0.01, 0.01);
  scene.patches.push_back(patch(PatchKind::pressure, k_top, {0, 0.005}, {0, 0.01}, {0.01, 0.01}));
  const ContactModel law = make_law({.stiffness = 1000});
  double before = 0;
  for (int n = 0; n <= 200; ++n) {   // moves from over the opening to under the wall, 0.3 mm below the plane
    ParticleStore store;
    add_sphere(store, 0.004 + 1e-5 * n, 0.005, 0.0097);
    Engine engine(store, scene, law, options(1e-9));
    engine.advance(1);
    const Row& f = store.force[0];
    const double push = std::hypot(f.x, f.z);
    EXPECT_LE(std::fabs(push - before), 1000 * 1.01e-5);   // at most stiffness times the step
    before = push;
  }
  EXPECT_NEAR(before, 1000 * 0.2e-3, 1e-9);
}

/// An opening of 4 x 4 mm in the middle of the bottom, cut along the given lines.
ModelScene opening_in_pieces(const std::vector<double>& x, const std::vector<double>& y) {
  ModelScene scene = box(0.01, 0.01, 0.01);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    for (std::size_t j = 0; j + 1 < y.size(); ++j) {
      scene.patches.push_back(patch(PatchKind::pressure, k_bottom, {x[i], x[i + 1]}, {y[j], y[j + 1]}, {0, 0}));
    }
  }
  return scene;
}

TEST(Outlets, AnOpeningInPiecesIsTheOpening) {
  constexpr double k_middle = 0.005;
  const std::vector<double> whole{0.003, 0.007}, halves{0.003, k_middle, 0.007};
  // One side of the seam was typed in other units: it differs by rounding.
  ModelScene rounded = opening_in_pieces(halves, whole);
  rounded.patches[1].extent[0].low = std::nextafter(k_middle, 1);
  const Surfaces one(opening_in_pieces(whole, whole));
  for (const ModelScene& scene : {opening_in_pieces(halves, whole), opening_in_pieces(whole, halves), opening_in_pieces(halves, halves), rounded}) {
    const Surfaces pieces(scene);
    ASSERT_EQ(pieces.count(), one.count());
    for (const double x : {0.0029, 0.003, 0.0032, 0.0049, k_middle, 0.0051, 0.007}) {
      for (const double y : {0.0029, 0.0031, 0.0049, k_middle, 0.0069}) {
        for (const double z : {-1e-4, 3e-4}) {
          const Row centre{x, y, z, 0.5e-3};
          EXPECT_EQ(pieces.has_left(centre), one.has_left(centre)) << x << " " << y;
          for (std::size_t s = 0; s < one.count(); ++s) {
            SurfaceTouch expected, found;
            ASSERT_EQ(pieces.nearest(s, centre, found), one.nearest(s, centre, expected));
            EXPECT_EQ(found.distance, expected.distance) << one.name(s) << " " << x << " " << y;
          }
        }
      }
    }
  }
}

TEST(Outlets, ABallOnTheSeamOfOpeningsFallsThrough) {
  const std::vector<double> whole{0.003, 0.007}, halves{0.003, 0.005, 0.007};
  for (const ModelScene& scene : {opening_in_pieces(whole, whole), opening_in_pieces(halves, whole), opening_in_pieces(halves, halves)}) {
    ParticleStore store;
    add_sphere(store, 0.00505, 0.005, 0.001);
    store.velocity[0].z = -1;
    const ContactModel law = make_law({});
    Engine engine(store, scene, law, options(1e-5));
    engine.advance(110);
    EXPECT_EQ(engine.report().removed, 1u) << scene.patches.size() << " patches";
  }
}

TEST(Outlets, PatchesThatCoverAFaceTogetherLeaveNoWall) {
  const std::vector<double> sides{0, 0.005, 0.01};
  EXPECT_EQ(Surfaces(opening_in_pieces({0, 0.01}, {0, 0.01})).count(), 5u);
  EXPECT_EQ(Surfaces(opening_in_pieces(sides, {0, 0.01})).count(), 5u);
  EXPECT_EQ(Surfaces(opening_in_pieces(sides, sides)).count(), 5u);
}

// Three quarters of a square: the fourth keeps its corner.
TEST(Outlets, AnOpeningRoundACornerKeepsTheCorner) {
  ModelScene scene = opening_in_pieces({0.003, 0.005, 0.007}, {0.003, 0.005, 0.007});
  scene.patches.pop_back();
  const Surfaces surfaces(scene);
  const Row centre{0.0048, 0.0049, 0, 0.5e-3};
  double nearest = 1;
  SurfaceTouch touch;
  for (std::size_t s = 0; s < surfaces.count(); ++s) {
    if (surfaces.nearest(s, centre, touch)) nearest = std::min(nearest, touch.distance);
  }
  EXPECT_NEAR(nearest / std::hypot(0.2e-3, 0.1e-3), 1, 1e-12);   // rounding of the places, 25 times finer than the distance
}

TEST(Outlets, RemovalKeepsIdsVelocitiesAndHistory) {
  // Two beds of the same particles; in one, another particle leaves through the top meanwhile.
  const auto run = [](bool with_leaver) {
    ModelScene scene = box(0.01, 0.01, 0.01);
    scene.patches.push_back(patch(PatchKind::pressure, k_top, {0, 0.01}, {0, 0.01}, {0.01, 0.01}));
    ParticleStore store = spinning_store();
    // The leaver gets the first row, so that its leaving moves all others.
    if (with_leaver) store.add(99, 0, 0.0006, 0.0006, 0.0099, 0.5e-3, sphere_mass(0.5e-3));
    for (std::uint64_t n = 0; n < 3; ++n) {
      store.add(n, 0, 0.004 + 0.00099 * static_cast<double>(n), 0.005, 0.0005, 0.5e-3, sphere_mass(0.5e-3));
    }
    for (std::size_t row = 0; row < store.size(); ++row) {
      store.velocity[row].z = store.id[row] == 99 ? 1 : 0;
      if (store.id[row] == 1) store.angular_velocity[row].y = 30;
    }
    const ContactModel law = make_law({.damping_ratio = 0.2, .friction = 0.3, .rotation = true});
    Engine engine(store, scene, law, options(1e-6, 9.81));
    engine.advance(400);
    EXPECT_EQ(engine.report().removed, with_leaver ? 1u : 0u);
    std::map<std::uint64_t, Row> out;
    for (std::size_t row = 0; row < store.size(); ++row) out[store.id[row]] = store.velocity[row];
    return out;
  };
  const auto with = run(true), without = run(false);
  ASSERT_EQ(with.size(), without.size());
  for (const auto& [id, v] : without) {
    EXPECT_EQ(with.at(id).x, v.x);
    EXPECT_EQ(with.at(id).y, v.y);
    EXPECT_EQ(with.at(id).z, v.z);
  }
}

}  // namespace
}  // namespace similitude
