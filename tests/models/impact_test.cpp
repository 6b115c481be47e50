// Impacts of single spheres on a wall, with the simplest integrator, through the plugin's boundary.
#include <gtest/gtest.h>
#include <similitude/restitution.h>

#include <algorithm>
#include <cmath>

#include "sphere_on_wall.h"

namespace similitude {
namespace {

using test::ContactModel;
using test::Rebound;
using test::Sphere;
using test::Values;

constexpr Sphere k_alumina{5e-4, 1040};
constexpr double k_stiffness = 500;

double contact_time(const ContactModel& law, const Sphere& sphere) {
  return law.functions().contact_time(law.instance(), 0, sphere.mass(), sphere.radius, 1.0);
}

/// The largest relative error of the restitution over all phases at which a step may meet the wall.
double restitution_error(const ContactModel& law, double restitution, int steps_per_contact) {
  const double dt = contact_time(law, k_alumina) / steps_per_contact;
  double worst = 0;
  for (const Rebound& r : impacts(law, k_alumina, {-1, 0, 0}, dt, test::all_phases())) {
    worst = std::max(worst, std::abs(r.velocity.x / restitution - 1));
  }
  return worst;
}

Values linear_spring(double restitution, double attraction = 0) {
  return {{"stiffness", k_stiffness}, {"restitution", restitution}, {"friction", 0}, {"attraction", attraction}};
}

TEST(LinearSpring, ReboundsWithItsRestitutionAtTwentyStepsPerContact) {
  for (const double e : {0.74, 0.8, 0.9, 0.97, 1.0}) {
    EXPECT_LT(restitution_error(ContactModel(LINEAR_SPRING, {linear_spring(e)}), e, 20), 0.03) << e;
    EXPECT_LT(restitution_error(ContactModel(LINEAR_SPRING, {linear_spring(e, 1)}), e, 20), 0.03) << e;
  }
}

TEST(LinearSpring, ReboundsWithItsRestitutionAtAHundredStepsPerContact) {
  for (const double e : {0.4, 0.5, 0.6, 0.74, 0.9, 1.0}) {
    EXPECT_LT(restitution_error(ContactModel(LINEAR_SPRING, {linear_spring(e)}), e, 100), 0.02) << e;
    EXPECT_LT(restitution_error(ContactModel(LINEAR_SPRING, {linear_spring(e, 1)}), e, 100), 0.02) << e;
  }
}

TEST(FluentDem, ReboundsWithItsRestitution) {
  for (const double e : {0.74, 0.9, 1.0}) {
    const ContactModel law(FLUENT_DEM, {{{"stiffness", k_stiffness}, {"restitution", e}}});
    EXPECT_LT(restitution_error(law, e, 20), 0.03) << e;
    EXPECT_LT(restitution_error(law, e, 100), 0.02) << e;
  }
}

TEST(LinearSpring, ConvergesAtLeastLinearlyInTheStep) {
  for (const double attraction : {0.0, 1.0}) {
    for (const double e : {0.4, 0.74, 0.9}) {
      const ContactModel law(LINEAR_SPRING, {linear_spring(e, attraction)});
      double before = restitution_error(law, e, 20);
      for (const int steps : {40, 80, 160, 320}) {
        const double now = restitution_error(law, e, steps);
        EXPECT_LT(now, 0.6 * before) << e << ' ' << steps;   // half, and the phases are sampled at 40 places
        before = now;
      }
    }
  }
}

TEST(LinearSpring, NeverPullsUnlessAttractionIsAllowed) {
  // Separating at 2 m/s from a hundredth of a radius: the dashpot would pull.
  for (const double attraction : {0.0, 1.0}) {
    const ContactModel law(LINEAR_SPRING, {linear_spring(0.5, attraction)});
    test::ContactColumns contact(8);
    for (std::size_t row = 0; row < 8; ++row) {
      contact.normal.set(row, {0, 0, 1});
      contact.overlap[row] = 5e-6;
      contact.velocity.set(row, {0, 0, 2});
      contact.radius_i[row] = contact.radius_j[row] = 5e-4;
      contact.effective_mass[row] = 0.5 * k_alumina.mass();
    }
    similitude_contact_block block = contact.block(1e-6, 0, false);
    similitude_status status{};
    law.functions().forces(law.instance(), &block, &status);
    if (attraction != 0) {
      EXPECT_LT(contact.force.get(0).z, 0);
    } else {
      EXPECT_EQ(contact.force.get(0).z, 0);
    }
  }
}

TEST(LinearSpring, TakesTheContactTimeItTells) {
  for (const double attraction : {0.0, 1.0}) {
    for (const double e : {0.5, 0.74, 1.0}) {
      const ContactModel law(LINEAR_SPRING, {linear_spring(e, attraction)});
      const double told = contact_time(law, k_alumina);
      const double w0 = std::sqrt(k_stiffness / k_alumina.mass());
      if (attraction != 0) {
        const double loss = std::log(e);
        EXPECT_NEAR(told * w0, std::sqrt(k_pi * k_pi + loss * loss), 1e-12);
      } else {   // from contact until the force is gone
        const Rebound r = impacts(law, k_alumina, {-1, 0, 0}, told / 2000, {1.0}).front();
        EXPECT_NEAR(r.duration, told, 0.002 * told);
      }
    }
  }
}

TEST(LinearSpring, TellsTheStepBeyondWhichAPackedBedHeats) {
  const ContactModel law(LINEAR_SPRING, {linear_spring(0.74)});
  const double w0 = std::sqrt(k_stiffness / k_alumina.mass());
  EXPECT_NEAR(law.functions().largest_stable_step(law.instance(), 0, k_alumina.mass(), k_alumina.radius, 1.0) * w0,
              std::sqrt(1 + 4 * 0.101977 * 0.101977) - 2 * 0.101977, 2e-6);   // its fastest mode has twice w0
  // Twice the usual tangential spring: seven sevenths of it swing on two sevenths of the mass.
  Values stiff = linear_spring(1);
  stiff["friction"] = 0.3;
  stiff["tangential_stiffness_ratio"] = 4.0 / 7;
  const ContactModel stiff_law(LINEAR_SPRING, {stiff});
  EXPECT_NEAR(stiff_law.functions().largest_stable_step(stiff_law.instance(), 0, k_alumina.mass(), k_alumina.radius, 1.0) * w0,
              1 / std::sqrt(2.0), 1e-12);
}

// Oblique impact of a 5 mm alumina sphere at 3.9 m/s, mu 0.092, e = 1: the set-up of Kharaz, Gorham & Salman (2001) with
// the linear spring of MFIX's test DEM05 (k_n 1.72e7 N/m, k_t 1.48e7 N/m, no damping).
constexpr Sphere k_kharaz{2.5e-3, 4000};
constexpr double k_speed = 3.9, k_friction = 0.092;

Rebound oblique(const ContactModel& law, double degrees, int steps_per_contact = 500) {
  const double angle = degrees * k_pi / 180;
  return impacts(law, k_kharaz, {-k_speed * std::cos(angle), k_speed * std::sin(angle), 0},
                 contact_time(law, k_kharaz) / steps_per_contact, {0.5})
      .front();
}

Values kharaz_spring() {
  return {{"stiffness", 1.72e7}, {"restitution", 1}, {"friction", k_friction}, {"tangential_stiffness_ratio", 1.48 / 1.72}};
}

/// Full sliding: v_t'/v_t = 1 - mu (1 + e) / tan(angle), omega = (5/2) mu (1 + e) v_n / r.
void expect_full_sliding(const ContactModel& law, double degrees) {
  const double angle = degrees * k_pi / 180;
  const Rebound r = oblique(law, degrees);
  EXPECT_NEAR(r.velocity.y / (k_speed * std::sin(angle)), 1 - 2 * k_friction / std::tan(angle), 5e-4) << degrees;
  const double spin = 2.5 * 2 * k_friction * k_speed * std::cos(angle) / k_kharaz.radius;
  EXPECT_NEAR(std::abs(r.angular_velocity.z), spin, 2e-3 * spin) << degrees;
}

TEST(LinearSpring, SlidesThroughAnObliqueImpactAsTheClosedForm) {
  const ContactModel law(LINEAR_SPRING, {kharaz_spring()});
  for (const double degrees : {30.0, 40.0, 60.0, 75.0}) expect_full_sliding(law, degrees);
}

TEST(FluentDem, SlidesThroughAnObliqueImpactAsTheClosedForm) {
  const ContactModel law(FLUENT_DEM, {{{"stiffness", 1.72e7}, {"restitution", 1}, {"mu_stick", k_friction}, {"mu_glide", k_friction}}});
  for (const double degrees : {40.0, 60.0, 75.0}) expect_full_sliding(law, degrees);
}

/// v_t'/v_t of the same model without damping, written down again in one dimension each way and integrated with two
/// hundred thousand steps.
double integrated_tangential_restitution(double degrees, double stiffness, double tangential_stiffness) {
  const double angle = degrees * k_pi / 180, mass = k_kharaz.mass(), radius = k_kharaz.radius;
  const double dt = k_pi * std::sqrt(mass / stiffness) / 200000;
  double overlap = 0, approach = k_speed * std::cos(angle), spring = 0, slip = k_speed * std::sin(angle), surface = 0;
  do {
    spring += (slip - surface) * dt;
    const double limit = k_friction * stiffness * overlap / tangential_stiffness;
    spring = std::clamp(spring, -limit, limit);
    slip -= tangential_stiffness * spring / mass * dt;
    surface += tangential_stiffness * spring * radius * radius / k_kharaz.inertia() * dt;
    approach -= stiffness * overlap / mass * dt;
    overlap += approach * dt;
  } while (overlap > 0);
  return slip / (k_speed * std::sin(angle));
}

TEST(LinearSpring, SticksAndSlidesInAnObliqueImpactAsItsEquationsDo) {
  const ContactModel law(LINEAR_SPRING, {kharaz_spring()});
  for (const double degrees : {1.0, 2.5, 5.0, 10.0, 15.0, 20.0, 27.5}) {
    EXPECT_NEAR(oblique(law, degrees, 5000).velocity.y / (k_speed * std::sin(degrees * k_pi / 180)),
                integrated_tangential_restitution(degrees, 1.72e7, 1.48e7), 5e-4)
        << degrees;
  }
}

// Sphere on wall, MFIX 21.3.2, t_c/50. From 7.5 degrees on the contact slides at first and last, and the answer hangs on
// friction. Below, where it swings on its tangential spring throughout, MFIX is up to 0.02 lower.
TEST(LinearSpring, SticksAndSlidesInAnObliqueImpactAsMfix) {
  const std::pair<double, double> mfix[] = {{7.5, 0.7268}, {10, 0.6556},   {12.5, 0.6162}, {15, 0.5971}, {20, 0.5946},
                                            {25, 0.6219},  {27.5, 0.6474}, {30, 0.6813}};
  const ContactModel law(LINEAR_SPRING, {kharaz_spring()});
  for (const auto& [degrees, ratio] : mfix) {
    const Rebound r = oblique(law, degrees);
    EXPECT_NEAR(r.velocity.y / (k_speed * std::sin(degrees * k_pi / 180)), ratio, 0.005) << degrees;
  }
}

// A sphere of 1 mm, density 1e4, set down sliding at 0.1 m/s rolls from t = 2 u0 / (7 mu g) on with 5/7 u0 (MFIX DEM04).
struct Rolling {
  double time, speed, spin;
};
Rolling slide_to_roll(const ContactModel& law, double friction) {
  const Sphere sphere{5e-4, 1e4};
  const similitude_contact_needs needs = test::needs_of(law);
  const double g = 9.81, dt = 1e-6, u0 = 0.1, weight = sphere.mass() * g;
  test::ContactColumns contact(8);
  Vec3<double> velocity = {0, u0, 0}, spin = {0, 0, 0};
  double height = sphere.radius - weight / 1e4, rolling_since = 0;   // at rest on its spring of 1e4 N/m
  for (int step = 1; step * dt < 4 * u0 / (7 * friction * g); ++step) {
    const Vec3<double> arm = {-sphere.radius, 0, 0};
    for (std::size_t row = 0; row < 8; ++row) {
      contact.normal.set(row, {1, 0, 0});
      contact.overlap[row] = sphere.radius - height;
      contact.velocity.set(row, velocity + cross(spin, arm));
      contact.radius_i[row] = sphere.radius;
      contact.radius_j[row] = std::numeric_limits<double>::infinity();
      contact.effective_mass[row] = sphere.mass();
    }
    similitude_contact_block block = contact.block(dt, needs.history_count);
    similitude_status status{};
    law.functions().forces(law.instance(), &block, &status);
    const Vec3<double> force = contact.force.get(0);
    if (rolling_since == 0 && std::abs(force.y) < 0.99 * friction * weight) rolling_since = step * dt;
    velocity = velocity + dt * ((1 / sphere.mass()) * force - Vec3<double>{g, 0, 0});
    spin = spin + (dt / sphere.inertia()) * cross(arm, force);
    height += velocity.x * dt;
  }
  return {rolling_since, velocity.y, std::abs(spin.z) * sphere.radius};
}

TEST(LinearSpring, TurnsSlidingIntoRolling) {
  for (const double friction : {0.2, 0.5, 1.0}) {
    const ContactModel law(LINEAR_SPRING, {{{"stiffness", 1e4}, {"restitution", 0.9}, {"friction", friction}}});
    const Rolling end = slide_to_roll(law, friction);
    const double time = 2 * 0.1 / (7 * friction * 9.81);
    EXPECT_NEAR(end.time, time, 0.01 * time) << friction;
    EXPECT_NEAR(end.speed, 5.0 / 7 * 0.1, 2e-4 * 0.1) << friction;
    EXPECT_NEAR(end.spin, 5.0 / 7 * 0.1, 4e-4 * 0.1) << friction;
  }
}

TEST(FluentDem, TurnsSlidingIntoRolling) {
  const double friction = 0.5;
  const ContactModel law(FLUENT_DEM, {{{"stiffness", 1e4}, {"restitution", 0.9}, {"mu_stick", friction}, {"mu_glide", friction}}});
  const Rolling end = slide_to_roll(law, friction);
  const double time = 2 * 0.1 / (7 * friction * 9.81);
  EXPECT_NEAR(end.time, time, 0.01 * time);
  EXPECT_NEAR(end.speed, 5.0 / 7 * 0.1, 2e-4 * 0.1);
  EXPECT_NEAR(end.spin, 5.0 / 7 * 0.1, 4e-4 * 0.1);
}

}  // namespace
}  // namespace similitude
