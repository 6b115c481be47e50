// Damping from restitution. Reference values: closed form for the full spring-dashpot; Schwager & Poeschel (2007) for the
// force cut off at zero, integrated independently to six digits.
#include <gtest/gtest.h>
#include <similitude/contact_law.h>

#include <cmath>

namespace similitude {
namespace {

struct Row {
  double restitution, full, cut_off;
};
constexpr Row k_table[] = {{0.2, 0.455950, 0.731247},  {0.4, 0.279998, 0.354508},  {0.5, 0.215454, 0.255276},
                           {0.6, 0.160493, 0.180858},  {0.74, 0.095408, 0.101977}, {0.8, 0.070850, 0.074355},
                           {0.84, 0.055413, 0.057514}, {0.9, 0.033518, 0.034265},  {0.97, 0.009695, 0.009756},
                           {0.98, 0.006431, 0.006457}};

TEST(Damping, IsTheTablesForAFullSpringDashpot) {
  for (const Row& row : k_table) EXPECT_NEAR(damping_ratio(row.restitution), row.full, 6e-7) << row.restitution;
}

TEST(Damping, IsTheTablesWhenPartnersNeverAttract) {
  for (const Row& row : k_table) {
    EXPECT_NEAR(damping_ratio_without_attraction(row.restitution), row.cut_off, 6e-7) << row.restitution;
  }
}

TEST(Damping, ComesBackAsTheRestitutionItWasMadeFrom) {
  for (double e = 0.01; e < 1; e += 0.01) {   // through critical damping, which is e = exp(-2)
    EXPECT_NEAR(restitution_without_attraction(damping_ratio_without_attraction(e)), e, 1e-12) << e;
  }
}

TEST(Damping, IsCriticalAtRestitutionExpMinusTwo) {
  EXPECT_NEAR(damping_ratio_without_attraction(std::exp(-2.0)), 1.0, 1e-9);
  EXPECT_NEAR(impact_duration_without_attraction(1 - 1e-5), impact_duration_without_attraction(1 + 1e-5), 2e-5);
}

TEST(Damping, IsNoneForElasticPartners) {
  EXPECT_EQ(damping_ratio(1.0), 0.0);
  EXPECT_EQ(damping_ratio_without_attraction(1.0), 0.0);
  EXPECT_DOUBLE_EQ(impact_duration(0.0), k_pi);
  EXPECT_DOUBLE_EQ(impact_duration_without_attraction(0.0), k_pi);
}

// Semi-implicit Euler of x'' = -x - 2 zeta x' has the characteristic polynomial z^2 - (2 - h^2 - 2 zeta h) z + 1 - 2 zeta h;
// its largest root leaves the unit circle at h = 2 (sqrt(1 + zeta^2) - zeta).
TEST(StableStep, IsWhereTheDampedSpringStartsToGrow) {
  for (const double zeta : {0.0, 0.05, 0.3, 1.0}) {
    const auto grows = [zeta](double h) {
      double x = 1e-3, v = 1;
      for (int step = 0; step < 20000 && std::abs(x) < 1e3; ++step) {
        v += h * (-x - 2 * zeta * v);
        x += h * v;
      }
      return std::abs(x) >= 1e3;
    };
    EXPECT_FALSE(grows(0.999 * stable_step(zeta))) << zeta;
    EXPECT_TRUE(grows(1.001 * stable_step(zeta))) << zeta;
  }
}

/// A law that says nothing about its contact time: Hertz without damping.
struct Hertz {
  double modulus;   // [Pa], effective
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    const V touching = max(c.overlap, V(0));
    return along(c.normal, V(4.0 / 3 * modulus * sqrt(c.effective_radius() * touching) * touching));
  }
};

// Chung & Ooi (2011), test 1, glass: 40.3395 us.
TEST(HeadOnImpact, TakesHertzTimeForHertzSpheres) {
  const Impact impact = head_on_impact(Hertz{2.5e10}, 0.00586431, 0.005, 20);
  EXPECT_NEAR(impact.duration, 40.3395e-6, 0.002 * 40.3395e-6);   // a thousand steps per time scale and the last step
  EXPECT_NEAR(impact.restitution, 1, 0.002);
}

struct Dashpot {
  double damping;
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, V(500.0 * c.overlap - 2 * damping * sqrt(500.0 * c.effective_mass) * c.normal_velocity));
  }
};

TEST(HeadOnImpact, AgreesWithTheClosedFormOfASpringDashpot) {
  const double mass = 2.7e-7, scale = std::sqrt(mass / 500);
  for (const double e : {0.4, 0.74, 0.97}) {
    const Dashpot law{damping_ratio(e)};
    const Impact impact = head_on_impact(law, mass, 5e-4, 1.0);
    EXPECT_NEAR(impact.duration, scale * impact_duration(law.damping), 0.003 * impact.duration) << e;
    EXPECT_NEAR(impact.restitution, e, 0.003) << e;
    EXPECT_NEAR(largest_stable_step_of(impact), scale * stable_step_in_a_bed(law.damping), 0.01 * scale) << e;
  }
}

TEST(HeadOnImpact, NeverEndsWithoutARepulsion) {
  EXPECT_TRUE(std::isinf(head_on_impact(Hertz{0}, 1e-7, 5e-4, 1).duration));
}

}  // namespace
}  // namespace similitude
