// MFIX DEM03: two spheres pressed together between two walls, released.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record.h"
#include "spheres.h"

namespace similitude::test {
namespace {

constexpr Sphere k_lower{5e-4, 20000}, k_upper{5e-4, 10000};
constexpr double k_gap = 1.8e-3, k_stiffness = 1000, k_gravity = 9.80665;   // [m], [N/m], [m/s^2]

double dashpot(double restitution, double mass) {   // [kg/s]
  const double loss = std::log(restitution);
  return -2 * loss / std::sqrt(k_pi * k_pi + loss * loss) * std::sqrt(k_stiffness * mass);
}

/// Heights and velocities of the lower and the upper sphere.
struct Stack {
  double z1, z2, v1, v2;
};

/// d/dt of a stack: spring and dashpot at both walls and between the spheres, the dashpot may attract.
Stack rate(const Stack& s, double restitution) {
  const double m1 = k_lower.mass(), m2 = k_upper.mass(), r1 = k_lower.radius, r2 = k_upper.radius;
  const double floor = r1 - s.z1, middle = r1 + r2 - (s.z2 - s.z1), ceiling = s.z2 + r2 - k_gap;   // overlaps
  const double push_floor = floor > 0 ? k_stiffness * floor - dashpot(restitution, m1) * s.v1 : 0;
  const double push_middle = middle > 0 ? k_stiffness * middle - dashpot(restitution, m1 * m2 / (m1 + m2)) * (s.v2 - s.v1) : 0;
  const double push_ceiling = ceiling > 0 ? k_stiffness * ceiling + dashpot(restitution, m2) * s.v2 : 0;
  return {s.v1, s.v2, (push_floor - push_middle) / m1 - k_gravity, (push_middle - push_ceiling) / m2 - k_gravity};
}

Stack runge_kutta(const Stack& s, double dt, double restitution) {
  const auto moved = [&s](const Stack& k, double h) { return Stack{s.z1 + h * k.z1, s.z2 + h * k.z2, s.v1 + h * k.v1, s.v2 + h * k.v2}; };
  const Stack a = rate(s, restitution), b = rate(moved(a, dt / 2), restitution), c = rate(moved(b, dt / 2), restitution),
              d = rate(moved(c, dt), restitution);
  const Stack mean = {(a.z1 + 2 * b.z1 + 2 * c.z1 + d.z1) / 6, (a.z2 + 2 * b.z2 + 2 * c.z2 + d.z2) / 6,
                      (a.v1 + 2 * b.v1 + 2 * c.v1 + d.v1) / 6, (a.v2 + 2 * b.v2 + 2 * c.v2 + d.v2) / 6};
  return moved(mean, dt);
}

// Restitutions of the file's blocks, in order.
constexpr double k_restitutions[] = {1.0, 0.9, 0.8, 0.7, 0.6, 0.5};

TEST(MfixDem03, TheStackMovesAsItsEquationsAndAsMfix) {
  const std::vector<Block> lower = read_blocks("dem03_pos1.dat"), upper = read_blocks("dem03_pos2.dat");
  ASSERT_EQ(lower.size(), std::size(k_restitutions));
  double worst = 0, worst_file = 0, worst_mfix = 0;
  for (std::size_t block = 0; block < lower.size(); ++block) {
    const double e = k_restitutions[block];
    const double dt = 1e-8;
    Spheres spheres(LINEAR_SPRING, {{"stiffness", k_stiffness}, {"restitution", e}, {"friction", 0}, {"attraction", 1}},
                    {0.01, 0.01, k_gap}, k_gravity);
    spheres.add(k_lower, {5e-3, 5e-3, 0.45e-3});
    spheres.add(k_upper, {5e-3, 5e-3, 1.35e-3});
    Stack exact{0.45e-3, 1.35e-3, 0, 0};
    std::int64_t step = 0;
    for (std::size_t row = 0; row < lower[block].size(); ++row) {
      const auto wanted = static_cast<std::int64_t>(std::llround(lower[block][row][0] / dt));
      spheres.advance(dt, wanted - step);
      for (; step < wanted; ++step) exact = runge_kutta(exact, dt, e);
      const double z1 = spheres.position(0).z, z2 = spheres.position(1).z;
      const auto note = [](double& most, double a, double b) { most = std::max(most, std::abs(a / b - 1)); };
      note(worst, z1, exact.z1);
      note(worst, z2, exact.z2);
      note(worst_file, z1, lower[block][row][1]);
      note(worst_file, z2, upper[block][row][1]);
      note(worst_mfix, z1, lower[block][row][2]);
      note(worst_mfix, z2, upper[block][row][2]);
    }
  }
  EXPECT_LT(worst, 1e-4);        // of the height
  EXPECT_LT(worst_file, 1e-3);   // the file's own integration, five digits
  EXPECT_LT(worst_mfix, 1e-3);
  RecordProperty("worst_percent_from_equations", std::to_string(100 * worst));
  RecordProperty("worst_percent_from_file", std::to_string(100 * worst_file));
  record({"two stacked, compressed spheres (MFIX DEM03)", "Runge-Kutta of the equations", percent(worst), "MFIX 0.09 %"});
  std::printf("DEM03: %.5f %% from the equations, %.5f %% from MFIX's reference, %.5f %% from MFIX\n", 100 * worst, 100 * worst_file,
              100 * worst_mfix);
}

}  // namespace
}  // namespace similitude::test
