#include <gtest/gtest.h>

#include "beds.h"
#include "similarity/audit.h"

namespace similitude {
namespace {

using testing::exact_quarter;
using testing::similar;
using testing::spouted_bed;
using testing::terminal_velocity_law;

std::vector<std::string> warnings_of(const RealScene& real, const similitude_ratios& ratios) {
  const AuditedBed exact = audited(real), scaled = audited(simulated_bed(real, ratios));
  return audit_warnings(exact, scaled, compare_groups(exact, scaled, 0.42));
}

const GroupComparison& group(const std::vector<GroupComparison>& groups, const std::string& name) {
  for (const GroupComparison& one : groups)
    if (one.name == name) return one;
  throw std::runtime_error("no group " + name);
}

TEST(AuditedBed, KnowsSlotsPlatesDepthAndCells) {
  const AuditedBed bed = audited(spouted_bed());
  EXPECT_NEAR(bed.slot, 10e-3, 1e-12);
  EXPECT_NEAR(bed.plate_gap, 28e-3, 1e-12);   // plates at 60 and 90 mm, 2 mm thick
  EXPECT_NEAR(bed.entrance, 30e-3, 1e-12);
  EXPECT_EQ(bed.depth, 20e-3);
  EXPECT_EQ(bed.cell, 5e-3);
  EXPECT_EQ(bed.contact_pressure, 500 / 1e-3);
}

TEST(AuditedBed, HasNoDepthWherePeriodicAndNoPlatesWhereThereAreNone) {
  RealScene scene = spouted_bed();
  scene.periodic[1] = true;
  scene.baffles.clear();
  for (Patch& patch : scene.patches) patch.rest = true;
  const AuditedBed bed = audited(scene);
  EXPECT_EQ(bed.depth, 0);
  EXPECT_EQ(bed.plate_gap, 0);
  EXPECT_EQ(bed.entrance, 0);
  EXPECT_EQ(bed.slot, 0);
  const auto groups = compare_groups(bed, bed, 0.42);
  for (const GroupComparison& one : groups) EXPECT_TRUE(one.name != "depth/d" && one.name != "gap/d" && one.name != "slot/d");
}

TEST(AuditWarnings, HaveNothingToSayOfAnExactBed) {
  EXPECT_TRUE(warnings_of(spouted_bed(), identity_ratios()).empty());
  EXPECT_TRUE(warnings_of(spouted_bed(), exact_quarter()).empty());
}

// n/r = 2.83: the slot of 10 mm is 3.5 particles wide, the jet 2.83 times as strong; 7.1 particles of depth are enough.
TEST(AuditWarnings, OfTheTerminalVelocityLawSpeakOfSlotAndJet) {
  const auto warnings = warnings_of(spouted_bed(), terminal_velocity_law(0.25, 1040, 1.225));
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0],
            "the inlet is 3.5 particles wide (really 10.0): below 8 they bridge it now and then (a rule of thumb), below 5 they may "
            "block it, as silos (Zuriguel et al. 2005, Phys. Rev. E 71, 051303).");
  EXPECT_EQ(warnings[1],
            "the jet has 2.83 times its momentum against the bed's weight: spout and fountain come out too strong (1.5 is a rule of "
            "thumb).");
}

// n/r = 6 in a bed of 20 particles depth, cells of 5 and a plate gap of 28.
TEST(AuditWarnings, SpeakOfAllThatParticlesBecomeTooLargeFor) {
  std::string all;
  for (const std::string& warning : warnings_of(spouted_bed(), similar(1, 6, 1, (1.225 + (1040 - 1.225) / 6) / 1040, 6))) all += warning + "\n";
  for (const char* words : {"the gap beside a plate is 4.7 particles wide", "larger than a fifth of the gap", "entrance below the plates is 5.0",
                            "the bed is 3.3 particles deep", "a particle of 1.20 cells"})
    EXPECT_NE(all.find(words), std::string::npos) << words << "\nin\n" << all;
}

TEST(AuditWarnings, SpeakOfHarderContactsAndOfMoreParticles) {
  similitude_ratios hard = identity_ratios();
  hard.stiffness = 8;
  ASSERT_EQ(warnings_of(spouted_bed(), hard).size(), 1u);
  EXPECT_EQ(warnings_of(spouted_bed(), hard)[0], "contacts are 8 times as hard against the bed's weight as in the real bed.");
  similitude_ratios fine = identity_ratios();
  fine.diameter = 0.5;
  fine.parcel_weight = 0.125;
  fine.stiffness = 0.5;
  ASSERT_EQ(warnings_of(spouted_bed(), fine).size(), 1u);
  EXPECT_EQ(warnings_of(spouted_bed(), fine)[0], "3.69e+06 particles for 4.61e+05 real ones: more work, not less.");
}

// The family keeps St only to the density ratio: 1.00216 is lost, and said to be.
TEST(CompareGroups, KeepWithinATenthOfAPercent) {
  const RealScene real = spouted_bed();
  const auto groups = compare_groups(audited(real), audited(simulated_bed(real, terminal_velocity_law(0.25, 1040, 1.225))), 0.42);
  EXPECT_NEAR(group(groups, "St").ratio, 1 + (0.70787 / 0.25 - 1) * 1.225 / 1040, 1e-7);
  EXPECT_FALSE(group(groups, "St").kept);
  EXPECT_TRUE(group(groups, "softness").kept);
  EXPECT_NEAR(group(groups, "slot/d").scaled, 10 * 0.25 / 0.70787, 1e-4);
}

ModelParameter given(const std::string& name, double value) { return {name, value, "", SIMILITUDE_SCALES_NOT, true}; }

TEST(GasFractionAtMinimum, IsWhatTheCaseSays) {
  RealScene scene = spouted_bed();
  EXPECT_EQ(gas_fraction_at_minimum(scene), 0.42);
  scene.models.drag.parameters.push_back(given("minimum_fluidization_velocity", 0.36));
  EXPECT_NEAR(gas_fraction_at_minimum(scene), 0.4328, 5e-5);
  scene.models.scaling.parameters.push_back(given("gas_fraction_at_minimum_fluidization", 0.45));
  EXPECT_EQ(gas_fraction_at_minimum(scene), 0.45);
}

}  // namespace
}  // namespace similitude
