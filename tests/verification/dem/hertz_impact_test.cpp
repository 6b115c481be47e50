// Chung & Ooi (2011), Granular Matter 13, 643, tests 1, 2 and 7, moved by the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record.h"
#include "spheres.h"

namespace similitude::test {
namespace {

struct Peak {
  double overlap = 0, force = 0, duration = 0;   // [m], [N], [s]
};

/// Follows an impact along x; `overlap` from the spheres' places.
template <class Overlap>
Peak follow(Spheres& spheres, double dt, Overlap overlap) {
  Peak peak;
  double steps = 0;
  bool met = false;
  do {
    spheres.advance(dt);
    if (spheres.touching()) {
      met = true;
      ++steps;
      peak.force = std::max(peak.force, std::abs(spheres.force(0).x));
      peak.overlap = std::max(peak.overlap, overlap());
    }
  } while (!met || spheres.touching());
  peak.duration = steps * dt;
  return peak;
}

struct Benchmark {
  const char* name;
  double radius, density, youngs_modulus, poisson_ratio, speed;
  double overlap, force, duration;   // [m], [N], [s]: Hertz, delta_max = (15 m* v^2 / (16 E* sqrt R*))^(2/5)
};

struct Errors {
  Worst force, overlap, duration;   // [-]
  std::string words() const {
    return percent(force.value) + " (force), " + percent(overlap.value) + " (overlap), " + percent(duration.value) + " (time)";
  }
};

/// Four digits; the duration is a whole number of steps of a thousandth.
void expect_hertz(const Peak& peak, const Benchmark& b, Errors& errors) {
  errors.force.see(peak.force, b.force);
  errors.overlap.see(peak.overlap, b.overlap);
  errors.duration.see(peak.duration, b.duration);
  EXPECT_NEAR(peak.overlap, b.overlap, 1e-4 * b.overlap) << b.name;
  EXPECT_NEAR(peak.force, b.force, 1e-4 * b.force) << b.name;
  EXPECT_NEAR(peak.duration, b.duration, 1.5e-3 * b.duration) << b.name;
}

TEST(ChungOoi1, TwoElasticSpheresReachTheHertzMaxima) {
  Errors errors;
  const Benchmark benchmarks[] = {{"glass", 0.01, 2800, 48e9, 0.20, 20, 274.1127e-6, 10.69689e3, 40.3395e-6},
                                  {"limestone", 0.01, 2500, 20e9, 0.25, 20, 368.3040e-6, 7.10824e3, 54.2010e-6}};
  for (const Benchmark& b : benchmarks) {
    for (const char* law : {HERTZ_MINDLIN, HERTZ_THORNTON}) {
      Spheres spheres(law, {{"youngs_modulus", b.youngs_modulus}, {"poisson_ratio", b.poisson_ratio}, {"restitution", 1}, {"friction", 0.35}},
                      {0.1, 0.1, 0.1});
      const Sphere sphere{b.radius, b.density};
      const double told = spheres.contact_time(sphere.mass() / 2, b.radius / 2, b.speed), dt = told / 1000;
      EXPECT_NEAR(told, b.duration, 1e-5 * b.duration);
      const double gap = 0.3 * b.speed * dt;
      spheres.add(sphere, {0.05 - b.radius - gap / 2, 0.05, 0.05}, {b.speed / 2, 0, 0});
      spheres.add(sphere, {0.05 + b.radius + gap / 2, 0.05, 0.05}, {-b.speed / 2, 0, 0});
      const Peak peak = follow(spheres, dt, [&] { return 2 * b.radius - (spheres.position(1).x - spheres.position(0).x); });
      expect_hertz(peak, b, errors);
      EXPECT_NEAR(spheres.velocity(1).x, b.speed / 2, 1e-4 * b.speed);
      EXPECT_EQ(spheres.velocity(1).x, -spheres.velocity(0).x);
    }
  }
  record({"elastic impact of two spheres (Chung & Ooi 1)", "Hertz, closed form", errors.words(), "Kratos 0.003 % (force)"});
}

TEST(ChungOoi2, AnElasticSphereOnARigidPlaneReachesTheHertzMaxima) {
  Errors errors;
  const double rigid = std::numeric_limits<double>::infinity();
  const Benchmark benchmarks[] = {{"aluminium", 0.1, 2699, 70e9, 0.30, 0.2, 49.7172e-6, 11.36986e3, 731.6566e-6},
                                  {"magnesium", 0.1, 1800, 40e9, 0.35, 0.2, 52.1233e-6, 7.23268e3, 767.0659e-6}};
  for (const Benchmark& b : benchmarks) {
    Spheres spheres(HERTZ_MINDLIN, {{"youngs_modulus", b.youngs_modulus}, {"poisson_ratio", b.poisson_ratio}, {"partner_youngs_modulus", rigid},
                                    {"restitution", 1}, {"friction", 0}},
                    {1, 1, 1});
    const Sphere sphere{b.radius, b.density};
    const double dt = spheres.contact_time(sphere.mass(), b.radius, b.speed) / 1000;
    spheres.add(sphere, {b.radius + 0.3 * b.speed * dt, 0.5, 0.5}, {-b.speed, 0, 0});
    expect_hertz(follow(spheres, dt, [&] { return b.radius - spheres.position(0).x; }), b, errors);
  }
  record({"elastic impact on a rigid plane (Chung & Ooi 2)", "Hertz, closed form", errors.words(), "Kratos 0.005 % (force)"});
}

// The curves of the paper, all points read from its figures: F = 4/3 E* sqrt(R*) delta^(3/2) within the reading error, 2 % of
// the largest force.
TEST(ChungOoi12, TheFiguresAreHertzsCurve) {
  const struct {
    const char* file;
    double modulus, radius, largest;   // E* [Pa], R* [m], force [kN]
  } figures[] = {{"test1_glass_force_displacement.dat", 25e9, 0.005, 10.69689},
                 {"test2_al_alloy_force_displacement.dat", 76.9231e9, 0.1, 11.36986}};
  for (const auto& figure : figures) {
    const Block points = read_blocks(figure.file).at(0);
    EXPECT_GE(points.size(), 15u);
    for (const auto& point : points) {
      const double overlap = point[0] * 1e-6;
      EXPECT_NEAR(4.0 / 3 * figure.modulus * std::sqrt(figure.radius * overlap) * overlap / 1e3, point[1], 0.02 * figure.largest) << overlap;
    }
  }
}

// Opposite spins roll on each other: no slip, so nothing but the normal velocity may change, beyond rounding. With equal
// spins both surfaces slip, and the centres leave sideways, opposite to each other.
TEST(ChungOoi7, OppositeSpinsLeaveTheCentresOnTheirLine) {
  for (const char* law : {LINEAR_SPRING, HERTZ_MINDLIN, HERTZ_THORNTON}) {
    Values values = {{"restitution", 0.9}, {"friction", 0.4}};
    if (std::string(law) == LINEAR_SPRING) {
      values["stiffness"] = 1e6;
      values["tangential_stiffness_ratio"] = 2.0 / 7;
      values["tangential_damping_ratio"] = 0.5;
    } else {
      values["youngs_modulus"] = 70e9;
      values["poisson_ratio"] = 0.33;
    }
    for (const double second : {-1.0, 1.0}) {   // spin of the second over the first's
      Spheres spheres(law, values, {1, 1, 1});
      const Sphere sphere{0.1, 2700};
      const double speed = 0.2, spin = 1.3;
      spheres.add(sphere, {0.4 - 1e-6, 0.5, 0.5}, {speed, 0, 0}, {0, 0, spin});
      spheres.add(sphere, {0.6 + 1e-6, 0.5, 0.5}, {-speed, 0, 0}, {0, 0, second * spin});
      const double contact = spheres.contact_time(sphere.mass() / 2, 0.05, 2 * speed);
      spheres.advance(contact / 200, 300);
      EXPECT_FALSE(spheres.touching());
      EXPECT_NEAR(spheres.velocity(1).x, 0.9 * speed, 0.01 * speed) << law;
      if (second < 0) {
        for (const std::uint64_t id : {0u, 1u}) {
          EXPECT_NEAR(spheres.velocity(id).y, 0, 1e-15 * spin * sphere.radius) << law;
          EXPECT_EQ(spheres.velocity(id).z, 0) << law;
          EXPECT_EQ(spheres.position(id).y, 0.5) << law;
        }
        EXPECT_NEAR(spheres.spin(0).z, spin, 1e-14 * spin) << law;
        EXPECT_EQ(spheres.spin(1).z, -spheres.spin(0).z) << law;
      } else {
        EXPECT_LT(spheres.velocity(0).y, -0.01 * speed) << law;
        EXPECT_EQ(spheres.velocity(1).y, -spheres.velocity(0).y) << law;
        EXPECT_LT(spheres.spin(0).z, spin) << law;
        EXPECT_EQ(spheres.spin(1).z, spheres.spin(0).z) << law;
      }
    }
  }
}

}  // namespace
}  // namespace similitude::test
