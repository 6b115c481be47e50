// Oblique impacts on a wall: MFIX DEM05, the experiment of Kharaz, Gorham & Salman (2001), Chung & Ooi (2011) tests 4 and 5.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record.h"
#include "spheres.h"

namespace similitude::test {
namespace {

struct Set {
  const char* file;
  Values values;
  Sphere sphere;
  double friction, restitution;
};

/// What leaves the wall x = 0 after an impact at a speed [m/s], at an angle from the normal.
struct Rebound {
  double ratio;        // [-], v_t'/v_t
  double angle;        // [deg], of the centre's velocity from the normal
  double spin;         // [rad/s], as friction makes it
  double patch_angle;  // [deg], of the contact point's velocity
  double tangential, normal_in, tangential_in, surface;   // [m/s]
};

Rebound rebound(const Set& set, double degrees, double speed, double steps_per_contact = 1000) {
  const double angle = degrees * k_pi / 180, normal = speed * std::cos(angle), tangential = speed * std::sin(angle);
  const double r = set.sphere.radius;
  Spheres spheres(set.file, set.values, {40 * r, 40 * r, 40 * r});
  const double contact = spheres.contact_time(set.sphere.mass(), r, normal), dt = contact / steps_per_contact;
  spheres.add(set.sphere, {r + 0.5 * normal * dt, 20 * r, 20 * r}, {-normal, tangential, 0});
  spheres.advance(dt, static_cast<std::int64_t>(1.2 * steps_per_contact));
  EXPECT_FALSE(spheres.touching());
  const Row v = spheres.velocity(0);
  const double spin = spheres.spin(0).z;   // the contact point moves at v_t - r spin
  return {v.y / tangential, std::atan2(v.y, v.x) * 180 / k_pi, spin, std::atan2(v.y - r * spin, v.x) * 180 / k_pi, v.y, normal, tangential,
          r * spin};
}

// 5 mm of alumina on a wall of soda lime glass, mu 0.092, e = 1, as MFIX.
constexpr Sphere k_kharaz{2.5e-3, 4000};
constexpr double k_speed = 3.9, k_friction = 0.092;

Set linear() {
  return {LINEAR_SPRING, {{"stiffness", 1.72e7}, {"restitution", 1}, {"friction", k_friction}, {"tangential_stiffness_ratio", 1.48 / 1.72}},
          k_kharaz, k_friction, 1};
}
Set hertz(const char* file, double restitution = 1) {
  return {file, {{"youngs_modulus", 380e9}, {"poisson_ratio", 0.23}, {"partner_youngs_modulus", 70e9}, {"partner_poisson_ratio", 0.25},
                 {"restitution", restitution}, {"friction", k_friction}},
          k_kharaz, k_friction, restitution};
}

// v_t'/v_t = 1 - mu (1 + e) / tan(angle), omega = (5/2) mu (1 + e) v_n / r. Springs slide throughout from 28 degrees on. Laws
// that attract at the end of a contact have no friction then, and slide by up to 1 % more for e = 0.7: not part of the formula.
TEST(ObliqueImpact, SlidesAsTheClosedForm) {
  Set damped = linear();
  damped.values["restitution"] = damped.restitution = 0.7;
  Worst ratio, spin_off;   // [-]
  for (const Set& set : {linear(), damped, hertz(HERTZ_MINDLIN), hertz(HERTZ_THORNTON), hertz(HERTZ_THORNTON, 0.7)}) {
    for (double degrees = 30; degrees < 80; degrees += 5) {
      const double angle = degrees * k_pi / 180, loss = set.friction * (1 + set.restitution);
      const Rebound r = rebound(set, degrees, k_speed);
      ratio.see(r.ratio, 1 - loss / std::tan(angle));
      EXPECT_NEAR(r.ratio, 1 - loss / std::tan(angle), 0.005 * r.ratio) << set.file << ' ' << degrees;
      const double spin = 2.5 * loss * k_speed * std::cos(angle) / k_kharaz.radius;
      spin_off.see(r.spin, spin);
      EXPECT_NEAR(r.spin, spin, 0.005 * spin) << set.file << ' ' << degrees;   // its lever arm is the radius less the overlap
    }
  }
  record({"oblique impact, sliding, three contact laws, 30 to 75 deg", "closed form", percent(ratio.value) + " of v_t'/v_t, " + percent(spin_off.value) + " of the spin", "MFIX 0.4 % of the spin"});
}

/// The linear spring without damping, written down again in one dimension each way; the lever arm is the radius less the overlap.
double integrated_ratio(double degrees) {
  const double angle = degrees * k_pi / 180, mass = k_kharaz.mass(), r = k_kharaz.radius, stiffness = 1.72e7, across = 1.48e7;
  const double dt = k_pi * std::sqrt(mass / stiffness) / 100000;
  double overlap = 0, approach = k_speed * std::cos(angle), spring = 0, tangential = k_speed * std::sin(angle), spin = 0;
  do {
    const double lever = r - overlap, limit = k_friction * stiffness * overlap / across;
    spring = std::clamp(spring + (tangential - lever * spin) * dt, -limit, limit);
    tangential -= across * spring / mass * dt;
    spin += across * spring * lever / (0.4 * mass * r * r) * dt;
    approach -= stiffness * overlap / mass * dt;
    overlap += approach * dt;
  } while (overlap > 0);
  return tangential / (k_speed * std::sin(angle));
}

TEST(ObliqueImpact, SticksAndSlidesAsTheEquationsOfTheLinearSpring) {
  Worst ratio;
  for (const double degrees : {1.0, 2.5, 5.0, 7.5, 10.0, 15.0, 20.0, 27.5, 35.0}) {
    const double ours = rebound(linear(), degrees, k_speed, 4000).ratio, exact = integrated_ratio(degrees);
    ratio.see(ours - exact);
    EXPECT_NEAR(ours, exact, 5e-4) << degrees;
  }
  record({"oblique impact, sticking and sliding, linear spring", "the law's equations, integrated", fmt::format("{:.1g} in v_t'/v_t", ratio.value), "MFIX up to 0.01"});
}

/// The value of a table at a place, between its rows.
double between(const Block& table, double x, std::size_t column) {
  for (std::size_t row = 1; row < table.size(); ++row) {
    if (table[row][0] >= x) {
      const double share = (x - table[row - 1][0]) / (table[row][0] - table[row - 1][0]);
      return table[row - 1][column] + share * (table[row][column] - table[row - 1][column]);
    }
  }
  return table.back()[column];
}

// MFIX 21.3.2 on the wall (third column), t_c/50. The linear spring from full sliding on: below, MFIX returns up to 0.01 more than
// the law's equations (see above) give. Hertz from 17.5 degrees on: where the contact sticks, MFIX has a plain spring.
TEST(MfixDem05, LinearSpringAndHertzReboundAsInMfix) {
  const std::vector<Block> ratios = read_blocks("mfix_dem05_coeff.dat"), angles = read_blocks("mfix_dem05_alpha.dat"),
                           spins = read_blocks("mfix_dem05_omega.dat");
  ASSERT_EQ(ratios.size(), 3u);
  const struct {
    Set set;
    double from;   // [deg]
    std::size_t block;
  } comparisons[] = {{linear(), 27.5, 1}, {hertz(HERTZ_MINDLIN), 17.5, 2}};
  Worst ratio, angle, spin;   // [-], [deg], [rad/s]
  for (const auto& [set, from, block] : comparisons) {
    for (double degrees = from; degrees <= 65; degrees += 2.5) {
      const Rebound r = rebound(set, degrees, k_speed);
      ratio.see(r.ratio - between(ratios[block], degrees, 2));
      angle.see(r.angle - between(angles[block], degrees, 2));
      spin.see(r.spin - between(spins[block], degrees, 2));
      EXPECT_NEAR(r.ratio, between(ratios[block], degrees, 2), 5e-4) << set.file << ' ' << degrees;
      EXPECT_NEAR(r.angle, between(angles[block], degrees, 2), 0.02) << set.file << ' ' << degrees;
      EXPECT_NEAR(r.spin, between(spins[block], degrees, 2), 0.5) << set.file << ' ' << degrees;
    }
  }
  record({"oblique impact (MFIX DEM05), linear spring and Hertz", "MFIX's own results",
          fmt::format("{:.1g} in v_t'/v_t, {:.1g} deg, {:.1g} rad/s", ratio.value, angle.value, spin.value), "-, it is the reference"});
}

// Springs miss the experiment by 0.03 in v_t'/v_t above 10 degrees. Below 5 degrees they return too much: the linear spring and Hertz with a
// rescaled spring by 0.12, Hertz with a plain one, as in MFIX, by 0.25. Spins at 6 and 60 degrees contradict the experiment's own
// velocities; the others agree with them within 5 %.
TEST(Kharaz, ReboundsWithinTheModelsErrorOfTheExperiment) {
  const Block ratios = read_blocks("mfix_dem05_coeff.dat")[0], angles = read_blocks("mfix_dem05_alpha.dat")[0],
              spins = read_blocks("mfix_dem05_omega.dat")[0];
  const double off = 0.03;   // [-], of v_t'/v_t; e = 1, as the experiment's angles and v_t'/v_t together say at 20 and 40 degrees
  Worst above, below;   // [-], of v_t'/v_t above and below 10 degrees
  std::vector<std::array<double, 3>> curve;
  for (const Set& set : {linear(), hertz(HERTZ_MINDLIN), hertz(HERTZ_THORNTON)}) {
    for (const auto& row : ratios) {
      const double ours = rebound(set, row[0], k_speed).ratio;
      (row[0] > 10 ? above : below).see(ours - row[1]);
      if (set.file == linear().file) curve.push_back({row[0], ours, row[1]});
      EXPECT_NEAR(ours, row[1], row[0] > 10 ? off : row[0] > 5 ? 0.05 : 0.13) << set.file << ' ' << row[0];
    }
    for (const auto& row : angles) {
      EXPECT_NEAR(rebound(set, row[0], k_speed).angle, row[1], row[0] > 5 ? 0.7 : 0.8) << set.file << ' ' << row[0];
    }
    for (const auto& row : spins) {
      if (row[0] < 10 || row[0] > 60) continue;
      const double tangential = k_speed * std::sin(row[0] * k_pi / 180);
      EXPECT_NEAR(rebound(set, row[0], k_speed).spin, row[1], 2.5 * off * tangential / k_kharaz.radius + 0.05 * row[1]) << set.file << ' ' << row[0];
    }
  }
  record({"oblique impact of alumina on glass", "experiment of Kharaz et al. 2001",
          fmt::format("{:.2g} in v_t'/v_t above 10 deg, {:.2g} below", above.value, below.value), "MFIX 0.03, 0.25"});
  record_curve("kharaz", "angle from the normal [deg],v_t'/v_t of the linear spring,Kharaz et al. (2001)", curve);
}

// Test 4, full sliding: e = 0.98. Bounds are the reading errors.
TEST(ChungOoi4, SlidesAsTheFigures) {
  Set alumina = hertz(HERTZ_MINDLIN, 0.98);
  alumina.values.erase("partner_youngs_modulus");
  alumina.values.erase("partner_poisson_ratio");
  const auto expect = [&](const char* file, double bound, auto value) {
    Worst off;
    int compared = 0;
    const Block figure = read_blocks(file).at(0);
    for (const auto& row : figure) {
      if (row[0] < 30) continue;
      ++compared;
      const double ours = value(rebound(alumina, row[0], k_speed));
      off.see(ours - row[1]);
      EXPECT_NEAR(ours, row[1], bound) << file << ' ' << row[0];
    }
    EXPECT_GE(compared, 7) << file;
    return off.value;
  };
  const double ratio = expect("test4_tangential_restitution.dat", 0.003, [](const Rebound& r) { return r.ratio; });
  const double spin = expect("test4_angular_velocity.dat", 4, [](const Rebound& r) { return -r.spin; });
  const double angle = expect("test4_contact_patch_rebound_angle.dat", 0.4, [](const Rebound& r) { return r.patch_angle; });
  record({"oblique impact, sliding (Chung & Ooi 4)", "curves read from the paper, to 0.003, 4 rad/s, 0.4 deg",
          fmt::format("{:.1g} in v_t'/v_t, {:.1g} rad/s, {:.1g} deg", ratio, spin, angle), ""});
}

// Test 5, full sliding: with x = 2 tan(in) / (mu (1 + e)), y = 2 (contact point's v_t' / v_n) / (mu (1 + e)), y = x - 7 and
// 2 r omega / (mu (1 + e) v_n) = -5, whatever the material; points of the figures: (9.99, 3.01), (12.96, 6.01).
TEST(ChungOoi5, SlidesAsTheFigures) {
  const double friction = 0.3, normal = 0.2;
  const Set steel{HERTZ_MINDLIN, {{"youngs_modulus", 208e9}, {"poisson_ratio", 0.3}, {"restitution", 1}, {"friction", friction}}, {0.01, 7850}, friction, 1};
  const Set polyethylene{HERTZ_THORNTON, {{"youngs_modulus", 1e9}, {"poisson_ratio", 0.4}, {"restitution", 1}, {"friction", friction}}, {0.01, 1400}, friction, 1};
  Worst recoil, spin;
  for (const Set& set : {steel, polyethylene}) {
    for (const double x : {8.0, 9.987915, 12.960725, 20.0}) {
      const double tangent = x * friction;   // (1 + e) / 2 = 1
      const Rebound r = rebound(set, std::atan(tangent) * 180 / k_pi, normal * std::sqrt(1 + tangent * tangent));
      recoil.see(((r.tangential - r.surface) / (r.normal_in * friction) - (x - 7)) / 7);
      spin.see(r.surface / (r.normal_in * friction), 5);
      EXPECT_NEAR((r.tangential - r.surface) / (r.normal_in * friction), x - 7, 0.005 * 7) << x;
      EXPECT_NEAR(r.surface / (r.normal_in * friction), 5, 0.005 * 5) << x;
    }
  }
  record({"oblique impact, sliding, of steel and polyethylene (Chung & Ooi 5)", "closed form", percent(recoil.value) + " of the recoil, " + percent(spin.value) + " of the spin", ""});
}

}  // namespace
}  // namespace similitude::test
