#include <gtest/gtest.h>

#include "@name@.h"

namespace {

TEST(@Type@, IsTheRealBedAtOne) {
  const similitude::Ratios r = @Type@{.n = 1}.ratios({});
  EXPECT_EQ(r.diameter, 1);
  EXPECT_EQ(r.parcel_weight, 1);
  EXPECT_EQ(r.stiffness, 1);
}

// As much solid in as much space: a grain weighs what its particles weigh.
TEST(@Type@, KeepsTheMassOfSolids) {
  const similitude::Ratios r = @Type@{.n = 2}.ratios({});
  EXPECT_EQ(r.parcel_weight, r.diameter * r.diameter * r.diameter * r.particle_density);
}

}  // namespace
