// MFIX DEM01 and DEM02: a sphere falls on a wall and bounces, against the equation of motion with gravity in the contact.
#include <gtest/gtest.h>
#include <similitude/restitution.h>

#include <algorithm>
#include <cmath>

#include "record.h"
#include "spheres.h"

namespace similitude::test {
namespace {

constexpr Sphere k_ball{0.1, 2600};
constexpr double k_release = 0.5, k_gravity = 9.80665;   // [m], height of the centre; [m/s^2]
constexpr int k_bounces = 6;

struct Law {
  double stiffness, restitution;   // [N/m], [-]
  bool attraction;
  double damping() const {   // [kg/s]
    const double zeta = attraction ? damping_ratio(restitution) : damping_ratio_without_attraction(restitution);
    return 2 * zeta * std::sqrt(stiffness * k_ball.mass());
  }
  double scale() const { return std::sqrt(k_ball.mass() / stiffness); }   // [s], 1 / w0
};

/// Bounce heights of the centre: parabolas between contacts, y'' = F / m - g in them, F = k (r - y) - eta y', cut off at zero
/// unless it may attract; fourth-order Runge-Kutta. Ends where the sphere no longer leaves the wall.
std::vector<double> exact_heights(const Law& law) {
  const double mass = k_ball.mass(), dt = law.scale() / 2000;
  const auto acceleration = [&](double overlap, double velocity) {
    const double force = law.stiffness * overlap - law.damping() * velocity;
    return (law.attraction ? force : std::max(force, 0.0)) / mass - k_gravity;
  };
  std::vector<double> heights = {k_release};
  while (static_cast<int>(heights.size()) <= k_bounces) {
    double y = 0, v = -std::sqrt(2 * k_gravity * (heights.back() - k_ball.radius));   // y from the place of first touch
    double before_y = 0, before_v = v;
    for (int step = 0; y <= 0; ++step) {
      if (step > 40000) return heights;   // twenty times the contact: it rests
      before_y = y, before_v = v;
      const double a1 = acceleration(-y, v), v2 = v + dt / 2 * a1;
      const double a2 = acceleration(-(y + dt / 2 * v), v2), v3 = v + dt / 2 * a2;
      const double a3 = acceleration(-(y + dt / 2 * v2), v3), v4 = v + dt * a3;
      const double a4 = acceleration(-(y + dt * v3), v4);
      y += dt / 6 * (v + 2 * v2 + 2 * v3 + v4);
      v += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    const double leaves = before_v + (v - before_v) * before_y / (before_y - y);   // at y = 0
    heights.push_back(k_ball.radius + leaves * leaves / (2 * k_gravity));
  }
  return heights;
}

/// Of the engine: the highest place between two contacts. A step is 1/`fineness` of the contact time scale.
std::vector<double> simulated_heights(const Law& law, std::size_t bounces, double fineness) {
  Spheres spheres(LINEAR_SPRING,
                  {{"stiffness", law.stiffness}, {"restitution", law.restitution}, {"friction", 0}, {"attraction", law.attraction ? 1.0 : 0.0}},
                  {1, 1, 1}, k_gravity);
  spheres.add(k_ball, {0.5, 0.5, k_release});
  const double dt = law.scale() / fineness;
  std::vector<double> heights = {k_release};
  double highest = 0, before = 0;
  while (heights.size() <= bounces) {
    spheres.advance(dt);
    const double y = spheres.position(0).z, v = spheres.velocity(0).z;
    if (y > k_ball.radius && before > 0 && v <= 0) heights.push_back(highest);
    highest = v > 0 ? y : highest;
    before = v;
  }
  return heights;
}

class Bounce : public testing::TestWithParam<Law> {};

TEST_P(Bounce, HeightsAreThoseOfTheEquationOfMotion) {
  const Law law = GetParam();
  const std::vector<double> exact = exact_heights(law);
  ASSERT_GE(exact.size(), 2u);
  const std::vector<double> heights = simulated_heights(law, exact.size() - 1, 300);
  double worst = 0, worst_rise = 0, hard = 0;
  for (std::size_t k = 1; k < exact.size(); ++k) {
    const double rise = exact[k] - k_ball.radius;
    worst = std::max(worst, std::abs(heights[k] / exact[k] - 1));
    worst_rise = std::max(worst_rise, std::abs(heights[k] - exact[k]) / (k_release - k_ball.radius));
    const double hard_sphere = k_ball.radius + (k_release - k_ball.radius) * std::pow(law.restitution, 2.0 * static_cast<double>(k));
    hard = std::max(hard, std::abs(exact[k] / hard_sphere - 1));
    EXPECT_NEAR(heights[k], exact[k], 0.005 * exact[k]) << k;
    EXPECT_NEAR(heights[k] - k_ball.radius, rise, 0.005 * (k_release - k_ball.radius)) << k;
  }
  RecordProperty("worst_percent", std::to_string(100 * worst));
  RecordProperty("distance_of_the_model_from_the_hard_sphere_percent", std::to_string(100 * hard));
  record({"bouncing sphere (MFIX DEM02), every height", "equation of motion", percent(worst), "MFIX 0.1 % to 8.5 %"});
  std::printf("k %.0e e %.1f %s: %zu bounces, worst %.4f %% of the height, %.4f %% of the first fall; the model itself is %.2f %% from the hard sphere\n",
              law.stiffness, law.restitution, law.attraction ? "attracting" : "cut off", exact.size() - 1, 100 * worst, 100 * worst_rise, 100 * hard);
}

std::vector<Law> all_laws() {
  std::vector<Law> laws;
  for (const bool attraction : {true, false}) {
    for (const double stiffness : {5e4, 5e5, 5e6}) {
      for (const double e : {1.0, 0.9, 0.8, 0.7, 0.6, 0.5}) laws.push_back({stiffness, e, attraction});
    }
  }
  return laws;
}

INSTANTIATE_TEST_SUITE_P(MfixDem02, Bounce, testing::ValuesIn(all_laws()), [](const auto& info) {
  return (info.param.attraction ? "attracting_k" : "cut_off_k") + std::to_string(static_cast<int>(info.param.stiffness)) + "_e" +
         std::to_string(static_cast<int>(std::lround(100 * info.param.restitution)));
});

// MFIX's own heights are those of the same equation, with a dashpot that attracts: the first bounces of its file.
TEST(MfixDem02, TheFilesBouncesAreThoseOfTheEquationOfMotion) {
  const double stiffnesses[] = {5e4, 5e5, 5e6}, restitutions[] = {1.0, 0.9, 0.8, 0.7, 0.6, 0.5};
  const std::vector<Block> blocks = read_blocks("dem02_height.dat");
  ASSERT_EQ(blocks.size(), 18u);
  double worst = 0, worst_formula = 0;
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    const std::vector<double> exact = exact_heights({stiffnesses[block / 6], restitutions[block % 6], true});
    for (std::size_t k = 1; k < std::min(exact.size(), blocks[block].size()); ++k) {
      worst = std::max(worst, std::abs(blocks[block][k][2] / exact[k] - 1));
      worst_formula = std::max(worst_formula, std::abs(blocks[block][k][1] / exact[k] - 1));
    }
  }
  std::printf("MFIX's bounces 1 to %d are within %.3f %% of the equation of motion, its reference column within %.2f %%\n", k_bounces,
              100 * worst, 100 * worst_formula);
  RecordProperty("mfix_from_the_equation_percent", std::to_string(100 * worst));
  RecordProperty("hard_sphere_from_the_equation_percent", std::to_string(100 * worst_formula));
  EXPECT_LT(worst, 0.02);   // at t_c/50: a tenth of what is between the hard sphere and the equation
  EXPECT_GT(worst_formula, 0.08);
}

// DEM01: time and speed at each stage of the first bounce, with the contact in closed form.
TEST(MfixDem01, FallContactAndRiseAreTheThreeClosedForms) {
  Worst worst;   // [-], of the first fall
  for (const double e : {1.0, 0.8, 0.6}) {
    const Law law{5e4, e, true};
    Spheres spheres(LINEAR_SPRING, {{"stiffness", law.stiffness}, {"restitution", e}, {"friction", 0}, {"attraction", 1}}, {1, 1, 1}, k_gravity);
    spheres.add(k_ball, {0.5, 0.5, k_release});
    const double dt = law.scale() / 1000, r = k_ball.radius;
    const double w0 = 1 / law.scale(), zeta = damping_ratio(e), wd = w0 * std::sqrt(1 - zeta * zeta);
    const double touch = std::sqrt(2 * (k_release - r) / k_gravity), speed = k_gravity * touch;
    // y - r = -g/w0^2 + exp(-zeta w0 t) (A cos wd t + B sin wd t), y = r and y' = -speed at the touch.
    const double sag = k_gravity / (w0 * w0), a = sag, b = (-speed + zeta * w0 * a) / wd;
    const auto in_contact = [&](double t) {
      return r - sag + std::exp(-zeta * w0 * t) * (a * std::cos(wd * t) + b * std::sin(wd * t));
    };
    double low = 0.5 * k_pi / wd, high = 1.5 * k_pi / wd;   // it leaves after about half a swing
    for (int halving = 0; halving < 60; ++halving) (in_contact(0.5 * (low + high)) < r ? low : high) = 0.5 * (low + high);
    const double contact = 0.5 * (low + high);
    const double leaves = (in_contact(contact) - in_contact(contact * (1 - 1e-7))) / (contact * 1e-7);
    std::int64_t step = 0;
    const auto height_at = [&](double t) {
      const auto wanted = static_cast<std::int64_t>(std::llround(t / dt));
      spheres.advance(dt, wanted - step);
      step = wanted;
      return spheres.position(0).z;
    };
    const auto at = [&](double t) { return std::round(t / dt) * dt; };   // the time really simulated
    const double bound = 0.005 * (k_release - r);
    const auto expect = [&](double ours, double exact, double most) {
      worst.see((ours - exact) / (k_release - r));
      EXPECT_NEAR(ours, exact, most) << e;
    };
    expect(height_at(0.5 * touch), k_release - 0.5 * k_gravity * at(0.5 * touch) * at(0.5 * touch), bound);
    for (const double share : {0.25, 0.5, 0.75}) {
      const double t = touch + share * contact;
      expect(height_at(t), in_contact(at(t) - touch), 0.05 * bound);
    }
    const double t = touch + contact + 0.5 * leaves / k_gravity, risen = at(t) - touch - contact;
    expect(height_at(t), r + leaves * risen - 0.5 * k_gravity * risen * risen, bound);
  }
  record({"fall, contact and rise of a sphere (MFIX DEM01)", "closed forms of the three stages", percent(worst.value) + " of the fall", "MFIX passes at 5 %"});
}

}  // namespace
}  // namespace similitude::test
