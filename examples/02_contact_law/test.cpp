#include <gtest/gtest.h>

#include "bouncy.h"

namespace {

Bouncy bouncy(double restitution) {
  Bouncy law{.stiffness = 500, .restitution = restitution, .damping_ratio = 0};
  law.prepare();
  return law;
}

constexpr double k_mass = 2.7e-7;     // [kg], effective, of two spheres of alumina of 1 mm
constexpr double k_radius = 0.25e-3;  // [m], effective

// The damping is made from the restitution, so an impact must give it back. 0.5 %: the error of playing it through with
// a thousand steps.
TEST(Bouncy, AnImpactGivesTheRestitutionBack) {
  for (const double restitution : {0.4, 0.74, 0.9, 1.0})
    EXPECT_NEAR(similitude::head_on_impact(bouncy(restitution), k_mass, k_radius, 0.5).restitution, restitution,
                0.005 * restitution);
}

// Half a period of the undamped spring: pi sqrt(m/k) = 73.0 microseconds.
TEST(Bouncy, AnElasticImpactLastsHalfAPeriod) {
  EXPECT_NEAR(similitude::head_on_impact(bouncy(1), k_mass, k_radius, 0.5).duration, 73.0e-6, 0.2e-6);
}

}  // namespace
