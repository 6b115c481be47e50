// MFIX DEM04: a sphere set down sliding comes to roll.
#include <gtest/gtest.h>

#include <cmath>

#include "record.h"
#include "spheres.h"

namespace similitude::test {
namespace {

constexpr Sphere k_ball{5e-4, 1e4};
constexpr double k_gravity = 9.81, k_start = 0.1;   // [m/s^2], [m/s]

struct Rolling {
  double since, speed, surface;   // [s], [m/s], [m/s]: time at which it rolls, its speed, radius times spin
};

Rolling slide_to_roll(const char* law, const Values& values, double sag, double friction, double dt) {
  Spheres spheres(law, values, {0.01, 0.01, 0.01}, k_gravity);
  spheres.add(k_ball, {1e-3, 5e-3, k_ball.radius - sag}, {k_start, 0, 0});
  const double weight = k_ball.mass() * k_gravity;
  Rolling end{};
  std::int64_t step = 0;
  const double slides = 2 * k_start / (7 * friction * k_gravity), calms = 0.01;   // [s], the tangential spring swings on for a while
  for (; static_cast<double>(step) * dt < slides + calms; step += 10) {
    spheres.advance(dt, 10);
    if (end.since == 0 && std::abs(spheres.force(0).x) < 0.99 * friction * weight) end.since = static_cast<double>(step) * dt;
  }
  end.speed = spheres.velocity(0).x;
  end.surface = spheres.spin(0).y * k_ball.radius;
  return end;
}

struct Errors {
  Worst time, speed, spin;   // [-], of the slide's duration and of its speed at the start
};

/// t_s = 2 u0 / (7 mu g), u = 5/7 u0. Bounds as MFIX's own distance: 0.57 % of t_s, 0.017 % of u, 0.042 % of the spin.
void expect_rolling(const Rolling& end, double friction, Errors& errors) {
  const double time = 2 * k_start / (7 * friction * k_gravity);
  errors.time.see(end.since, time);
  errors.speed.see(end.speed / k_start - 5.0 / 7);
  errors.spin.see(end.surface / k_start - 5.0 / 7);
  EXPECT_NEAR(end.since, time, 0.0057 * time) << friction;
  EXPECT_NEAR(end.speed, 5.0 / 7 * k_start, 1.7e-4 * k_start) << friction;
  EXPECT_NEAR(end.surface, 5.0 / 7 * k_start, 4.2e-4 * k_start) << friction;
}

TEST(MfixDem04, ASlidingSphereRollsOnASpring) {
  Errors errors;
  for (const double friction : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    const Values values = {{"stiffness", 1e4}, {"restitution", 0.9}, {"friction", friction}, {"tangential_stiffness_ratio", 1},
                           {"tangential_damping_ratio", 0.5}, {"attraction", 0}};
    expect_rolling(slide_to_roll(LINEAR_SPRING, values, k_ball.mass() * k_gravity / 1e4, friction, 1e-6), friction, errors);
  }
  record({"slide to roll (MFIX DEM04), five coefficients of friction", "closed form",
          percent(errors.time.value) + " (time), " + percent(errors.speed.value) + " (speed), " + percent(errors.spin.value) + " (spin)",
          "MFIX 0.57 % (time), 0.017 % (speed), 0.042 % (spin)"});
}

TEST(MfixDem04, ASlidingSphereRollsOnHertzsContact) {
  Errors errors;
  const double youngs_modulus = 1e8, poisson_ratio = 0.25;
  const double modulus = youngs_modulus / (2 * (1 - poisson_ratio * poisson_ratio));
  const double sag = std::pow(0.75 * k_ball.mass() * k_gravity / (modulus * std::sqrt(k_ball.radius)), 2.0 / 3);
  for (const double friction : {0.2, 0.6, 1.0}) {
    const Values values = {{"youngs_modulus", youngs_modulus}, {"poisson_ratio", poisson_ratio}, {"restitution", 0.9}, {"friction", friction}};
    for (const char* law : {HERTZ_MINDLIN, HERTZ_THORNTON}) expect_rolling(slide_to_roll(law, values, sag, friction, 1e-6), friction, errors);
  }
  record({"the same on Hertz's contact", "closed form",
          percent(errors.time.value) + " (time), " + percent(errors.speed.value) + " (speed), " + percent(errors.spin.value) + " (spin)", ""});
}

}  // namespace
}  // namespace similitude::test
