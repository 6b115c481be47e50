#include "output/map_back.h"

#include <gtest/gtest.h>

#include "scratch.h"

using namespace similitude;
using namespace similitude::test;

TEST(MapBack, DividesByTheRatioOfEachQuantity) {
  const MapBack map = quarter_scale();
  EXPECT_EQ(map.length(0.05), 0.2);
  EXPECT_EQ(map.time(1), 2);
  EXPECT_EQ(map.velocity(3), 6);
  EXPECT_EQ(map.angular_velocity(10), 5);
  EXPECT_EQ(map.pressure(250), 1000);
  EXPECT_EQ(map.solids_mass(1), 64);
  EXPECT_EQ(map.material_diameter(5e-4), 1e-3);
}

// Gas mass goes with rho_f* r^3 = 2/64, its flow with rho_f* r^2 v* = 2/16/2.
TEST(MapBack, MapsGasMassesWithTheGasDensity) {
  const MapBack map = quarter_scale();
  EXPECT_EQ(map.gas_mass(1), 32);
  EXPECT_EQ(map.gas_mass_flow(1), 16);
}

// J* = rho_f* v*^2 / p*. Froude scaling (v*^2 = r) with the gas made twice as heavy and the solids' density kept
// (rho_p - rho_f about unchanged): jets are about twice too strong against the bed's weight.
TEST(MapBack, FindsTheJetRatioFromTheScalingLaw) {
  RealScene real = small_bed<RealBed>(1);
  real.models.scaling.id = "froude";
  similitude_ratios scaling = identity_ratios();
  scaling.length = 0.25;
  scaling.velocity = scaling.time = 0.5;
  scaling.gas_density = 2;
  const MapBack map = map_back(real, scaling);
  EXPECT_EQ(map.scaling_law, "froude");
  EXPECT_EQ(map.gas_density, 2);
  EXPECT_DOUBLE_EQ(map.jet_ratio, 2 * 0.25 / map.ratios.pressure);
  EXPECT_NEAR(map.jet_ratio, 2, 2 * 2 * 1.2 / 2500);  // of the order of the density ratio
}

TEST(MapBack, OfTheIdentityChangesNothing) {
  const MapBack map = map_back(small_bed<RealBed>(1), identity_ratios());
  EXPECT_EQ(map.jet_ratio, 1);
  EXPECT_EQ(map.pressure(0.1), 0.1);
  EXPECT_EQ(map_back_note(map), "The real bed itself was simulated; values are as computed.");
}

TEST(MapBack, SaysWhichPressuresAreOff) {
  EXPECT_EQ(
      map_back_note(quarter_scale()),
      "Values are the real bed's: simulated values divided by the ratios of this file. Pressures are mapped by bed "
      "weight; dynamic pressures are off by the jet ratio J* = 2. 'diameter [m]' is what touches, "
      "'material_diameter [m]' the real particle's.");
}
