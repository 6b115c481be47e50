#include "output/profiles.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scratch.h"

using namespace similitude;
using namespace similitude::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// Bins of 5 mm over 20 mm, heights 50 mm and 100 mm, a bed 30 mm deep: the middle third is 10 ... 20 mm.
ProfileSettings four_bins() { return {.heights = {0.05, 0.1}, .size = {0.02, 0.03, 0.2}, .from = 1}; }

struct Seen {
  double x, y, z, velocity, mass;  // real bed
};
ParticleStore bed_of(const std::vector<Seen>& particles, const MapBack& map) {
  ParticleStore store;
  std::uint64_t id = 0;
  for (const Seen& p : particles) {
    const std::size_t row = store.add(id++, 0, p.x * map.ratios.length, p.y * map.ratios.length,
                                      p.z * map.ratios.length, 1e-4, p.mass * map.ratios.mass);
    store.velocity[row].z = p.velocity * map.ratios.velocity;
  }
  return store;
}

}  // namespace

TEST(ProfileSampler, TakesParticlesOfTheCentralPlaneAroundEachHeight) {
  ProfileSampler sampler(four_bins(), MapBack());
  sampler.sample(bed_of({{0.007, 0.015, 0.05, 1, 1},      // second bin, in the plane
                         {0.008, 0.011, 0.0524, 3, 1},    // still inside the slab of +-2.5 mm
                         {0.007, 0.015, 0.0526, 100, 1},  // above it
                         {0.007, 0.009, 0.05, 100, 1},    // in front of the middle third
                         {0.007, 0.021, 0.05, 100, 1},    // behind it
                         {0.02, 0.015, 0.1, -2, 1}},      // on the right wall, at the other height
                        MapBack()),
                 1);
  const auto rows = sampler.rows();
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(rows[1].sampler, "vertical_velocity [m/s]");
  EXPECT_DOUBLE_EQ(rows[1].x, 0.0075);
  EXPECT_DOUBLE_EQ(rows[1].y, 0.015);
  EXPECT_DOUBLE_EQ(rows[1].z, 0.05);
  EXPECT_EQ(rows[1].mean, 2);
  EXPECT_EQ(rows[1].n, 2u);
  EXPECT_EQ(rows[7].mean, -2);
  EXPECT_EQ(rows[7].n, 1u);
}

TEST(ProfileSampler, NamesEmptyBins) {
  ProfileSampler sampler(four_bins(), MapBack());
  sampler.sample(bed_of({{0.001, 0.015, 0.05, 1, 1}}, MapBack()), 1);
  const auto rows = sampler.rows();
  EXPECT_EQ(rows[2].n, 0u);
  EXPECT_TRUE(std::isnan(rows[2].mean));
  EXPECT_TRUE(std::isnan(rows[2].standard_error));
}

TEST(ProfileSampler, WeighsByMassAndByHowManyAreThere) {
  ProfileSampler sampler(four_bins(), MapBack());
  sampler.sample(bed_of({{0.001, 0.015, 0.05, 1, 2}, {0.002, 0.015, 0.05, 4, 1}}, MapBack()), 1);
  sampler.sample(bed_of({{0.001, 0.015, 0.05, 7, 1}}, MapBack()), 1.1);
  // (2 * 1 + 1 * 4 + 1 * 7) / 4, not the mean of the instants' means (2 + 7) / 2
  EXPECT_DOUBLE_EQ(sampler.rows()[0].mean, 13.0 / 4);
  EXPECT_EQ(sampler.rows()[0].n, 3u);
}

TEST(ProfileSampler, GivesTheStandardErrorOfTheInstants) {
  ProfileSampler sampler(four_bins(), MapBack());
  for (const double v : {1.0, 2.0, 3.0, 4.0}) sampler.sample(bed_of({{0.001, 0.015, 0.05, v, 1}}, MapBack()), v);
  const auto row = sampler.rows()[0];
  EXPECT_DOUBLE_EQ(row.mean, 2.5);
  EXPECT_DOUBLE_EQ(row.standard_error, std::sqrt(5.0 / 12));  // sqrt(sum of squares 5 / 3 / 4)
  EXPECT_DOUBLE_EQ(row.blocks, 4);
}

TEST(ProfileSampler, BeginsAtTheWindowAndRemembersIt) {
  ProfileSampler sampler(four_bins(), MapBack());
  const ParticleStore bed = bed_of({{0.001, 0.015, 0.05, 1, 1}}, MapBack());
  for (const double time : {0.0, 0.9, 1.0, 1.5, 2.0}) sampler.sample(bed, time);
  EXPECT_EQ(sampler.solids_window().from, 1.0);
  EXPECT_EQ(sampler.solids_window().to, 2.0);
  EXPECT_EQ(sampler.solids_window().instants, 3u);
  EXPECT_EQ(sampler.rows()[0].n, 3u);
}

TEST(ProfileSampler, HasNoRowsBeforeItSawAnything) {
  EXPECT_TRUE(ProfileSampler(four_bins(), MapBack()).rows().empty());
}

// A quarter-scale bed moves a quarter as far and half as fast: divided by powers of two nothing is rounded.
TEST(ProfileSampler, GivesTheSameBitsForAScaledBed) {
  const std::vector<Seen> seen = {{0.001, 0.015, 0.05, 0.1, 1e-6}, {0.0123, 0.0151, 0.0999, -0.7, 3e-6}};
  ProfileSampler real(four_bins(), MapBack()), scaled(four_bins(), quarter_scale());
  for (const double time : {1.0, 1.25, 1.5}) {
    real.sample(bed_of(seen, MapBack()), time);
    scaled.sample(bed_of(seen, quarter_scale()), 0.5 * time);
  }
  const auto a = real.rows(), b = scaled.rows();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].n, b[k].n);
    if (a[k].n == 0) continue;
    EXPECT_EQ(a[k].mean, b[k].mean);
    EXPECT_EQ(a[k].standard_error, b[k].standard_error);
  }
  EXPECT_EQ(scaled.solids_window().to, 1.5);
}

TEST(ProfileSampler, EndsItsLastBinAtTheWall) {
  ProfileSampler sampler({.heights = {0.05}, .size = {0.012, 0.03, 0.1}}, MapBack());
  sampler.sample(bed_of({{0.0119, 0.015, 0.05, 1, 1}}, MapBack()), 0);
  const auto rows = sampler.rows();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_DOUBLE_EQ(rows[2].x, 0.011);
  EXPECT_EQ(rows[2].n, 1u);
}

// 0.15 / 0.005 is 30 in decimal and 29.999… or 30.000…4 in binary: no sliver of a thirty-first bin.
TEST(ProfileSampler, HasThirtyBinsAcrossOneHundredAndFiftyMillimetres) {
  ProfileSampler sampler({.heights = {0.05}, .size = {0.15, 0.02, 1}}, MapBack());
  sampler.sample(ParticleStore(), 0);
  EXPECT_EQ(sampler.rows().size(), 30u);
}

TEST(ProfileSampler, NeverChangesWhatItSees) {
  const std::vector<Seen> seen = {{0.001, 0.015, 0.05, 0.1, 1e-6}};
  const ParticleStore bed = bed_of(seen, MapBack());
  ProfileSampler sampler(four_bins(), MapBack());
  sampler.sample(bed, 1);
  EXPECT_EQ(bed.velocity[0].z, 0.1);
  EXPECT_EQ(bed.position[0].x, 0.001);
}

// Cells of 20 mm under bins of 5 mm: a bin sees the cell it lies in; the slab 37.5 ... 42.5 mm lies half in each of two
// layers, the middle third of the depth (20 ... 40 mm) is the middle cell.
TEST(GasFractionProfile, WeighsCellsByTheVolumeSharedWithTheBin) {
  const ModelScene scene = small_bed<ModelBed>(0.25);
  const Grid grid(scene);
  ProfileSampler sampler({.heights = {0.04}, .size = {0.08, 0.06, 0.16}}, quarter_scale());
  Column<double> fraction(grid.cell_count(), 0.1);  // in front and behind
  for (int k = 0; k < 8; ++k)
    for (int i = 0; i < 4; ++i) fraction[grid.cell(i, 1, k)] = 0.4 + 0.1 * i + (k == 2 ? 0.04 : 0);
  sampler.sample(grid, fraction, 1);
  const auto rows = sampler.rows();
  ASSERT_EQ(rows.size(), 16u);
  EXPECT_EQ(rows[0].sampler, "gas_fraction [1]");
  EXPECT_NEAR(rows[0].mean, 0.42, 1e-12);
  EXPECT_NEAR(rows[3].mean, 0.42, 1e-12);
  EXPECT_NEAR(rows[4].mean, 0.52, 1e-12);
  EXPECT_NEAR(rows[15].mean, 0.72, 1e-12);
}

TEST(ProfileFile, HasTheColumnsOfTheContract) {
  const ScratchFolder folder;
  const OutputDirectory directory(folder.path(), false);
  ProfileSampler sampler({.heights = {0.05}, .size = {0.01, 0.03, 0.1}}, MapBack());
  for (const double v : {1.0, 2.0, 3.0, 4.0}) sampler.sample(bed_of({{0.001, 0.015, 0.05, v, 1}}, MapBack()), v);
  write_profiles(directory, sampler.rows());
  EXPECT_THAT(lines_of(folder / "profiles.csv"),
              ElementsAre("sampler,x,y,z,mean,standard error,n,blocks",
                          "vertical_velocity [m/s],0.0025,0.015,0.05,2.5,0.6454972243679028,4,4",
                          "vertical_velocity [m/s],0.0075,0.015,0.05,,,0,0"));
}

TEST(ProfileBlocksFile, HoldsWhatTheMeansAreMadeOf) {
  const ScratchFolder folder;
  const OutputDirectory directory(folder.path(), false);
  ProfileSampler sampler({.heights = {0.05}, .size = {0.005, 0.03, 0.1}}, MapBack());
  for (const double v : {1.0, 2.0}) sampler.sample(bed_of({{0.001, 0.015, 0.05, v, 4}}, MapBack()), v);
  sampler.sample(bed_of({{0.001, 0.015, 0.09, 9, 4}}, MapBack()), 3);   // nothing at this height now
  write_profile_blocks(directory, sampler.block_rows());
  EXPECT_THAT(lines_of(folder / "profile_blocks.csv"),
              ElementsAre("sampler,x,z,block,weighted sum,weight", "vertical_velocity [m/s],0.0025,0.05,0,4,4",
                          "vertical_velocity [m/s],0.0025,0.05,1,8,4", "vertical_velocity [m/s],0.0025,0.05,2,0,0"));
}

TEST(ProfileTable, SaysTheWindowAndNamesEmptyBins) {
  ProfileSampler sampler({.heights = {0.05}, .size = {0.02, 0.03, 0.1}}, MapBack());
  for (const double time : {1.0, 2.0})
    sampler.sample(bed_of({{0.001, 0.015, 0.05, -0.5 * time, 1}, {0.011, 0.015, 0.05, 1.5, 1}}, MapBack()), time);
  EXPECT_EQ(profile_table(sampler),
            "vertical_velocity [m/s] at z = 0.05 m, mean over 1 ... 2 s (2 instants)\n"
            "     x [m]       mean   std. error         n\n"
            "    0.0025      -0.75         0.25         2  ##########|\n"
            "    0.0075      empty\n"
            "    0.0125        1.5            0         2            |####################\n"
            "    0.0175      empty\n");
}
