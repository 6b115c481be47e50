#include <gtest/gtest.h>

#include "@name@.h"

namespace {

@Type@ law(double restitution) {
  @Type@ made{.stiffness = 500, .restitution = restitution, .damping_ratio = 0};
  made.prepare();
  return made;
}

constexpr double k_mass = 2.7e-7;     // [kg], effective, of two spheres of alumina of 1 mm
constexpr double k_radius = 0.25e-3;  // [m], effective

// The damping is made from the restitution, so an impact must give it back. 0.5 %: the error of playing it through with
// a thousand steps.
TEST(@Type@, AnImpactGivesTheRestitutionBack) {
  for (const double restitution : {0.4, 0.74, 0.9, 1.0})
    EXPECT_NEAR(similitude::head_on_impact(law(restitution), k_mass, k_radius, 0.5).restitution, restitution,
                0.005 * restitution);
}

}  // namespace
