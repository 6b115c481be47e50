// Many spheres in free flight: the energy of an elastic gas, the cooling of one that is not. No gravity, no gas between them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "record.h"
#include "spheres.h"

namespace similitude::test {
namespace {

/// A cubic lattice of `per_edge`^3 places, of which the first `count` are taken, in a periodic box.
void scatter(Spheres& gas, const Sphere& sphere, int count, int per_edge, double edge, double speed) {
  std::mt19937_64 random(3);
  const auto unit = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto normal = [&unit] {   // Box & Muller 1958
    return std::sqrt(-2 * std::log(1 - unit())) * std::cos(2 * k_pi * unit());
  };
  std::vector<std::array<double, 3>> velocities(static_cast<std::size_t>(count));
  std::array<double, 3> mean{};
  for (auto& v : velocities) {
    for (std::size_t a = 0; a < 3; ++a) v[a] = speed * normal(), mean[a] += v[a] / count;
  }
  int n = 0;
  const double pitch = edge / per_edge;
  for (int k = 0; k < per_edge; ++k) {
    for (int j = 0; j < per_edge; ++j) {
      for (int i = 0; i < per_edge && n < count; ++i, ++n) {
        auto& v = velocities[static_cast<std::size_t>(n)];
        gas.add(sphere, {pitch * (i + 0.5), pitch * (j + 0.5), pitch * (k + 0.5)}, {v[0] - mean[0], v[1] - mean[1], v[2] - mean[2]});
      }
    }
  }
}

/// [m^2/s^2], a third of the mean square of the velocities.
double temperature(const Spheres& gas, int count) {
  double squares = 0;
  for (int id = 0; id < count; ++id) {
    const Row& v = gas.velocity(static_cast<std::uint64_t>(id));
    squares += v.x * v.x + v.y * v.y + v.z * v.z;
  }
  return squares / (3 * count);
}

}  // namespace

// MFIX's legacy case of a homogeneous gas: 195 spheres of 1 cm and 1 g/cm^3 in 8 cm, k_n = 1e6 dyn/cm, e = 1, no friction. MFIX holds the
// kinetic energy to 1 %.
TEST(ElasticGas, KeepsItsEnergy) {
  constexpr int k_count = 195;
  constexpr Sphere k_sphere{5e-3, 1000};
  Spheres gas(LINEAR_SPRING, {{"stiffness", 1000}, {"restitution", 1}, {"friction", 0}}, {0.08, 0.08, 0.08});
  gas.make_periodic();
  scatter(gas, k_sphere, k_count, 6, 0.08, 0.02);
  const double before = temperature(gas, k_count);
  const double dt = gas.contact_time(k_sphere.mass() / 2, k_sphere.radius / 2, 0.02) / 50;
  // A pair in contact holds some of its energy in the spring: the mean over many instants, of which contacts take some per cent.
  double mean = 0;
  for (int n = 0; n < 50; ++n) {
    gas.advance(dt, 1000);
    if (n >= 25) mean += temperature(gas, k_count) / 25;
  }
  const double error = std::abs(mean / before - 1);
  std::printf("  energy after %.3g s: %.3f %% off\n", 50'000 * dt, 100 * error);
  EXPECT_LT(error, 0.01);
  record({"energy of an elastic gas, 50 000 steps", "constant", percent(error), "MFIX 1 %"});
}

// Haff (1983), J. Fluid Mech. 134, 401: T = T0/(1 + t/tau)^2, 1/tau = 4/sqrt(pi) (1 - e^2) phi g0 sqrt(T0)/d, g0 of Carnahan & Starling.
TEST(CoolingGas, FollowsHaffsLaw) {
  constexpr int k_count = 1000;
  constexpr double k_fraction = 0.05, k_restitution = 0.8;
  constexpr Sphere k_sphere{5e-4, 1040};
  const double d = 2 * k_sphere.radius, edge = std::cbrt(k_count * k_pi / 6 * d * d * d / k_fraction);
  Spheres gas(LINEAR_SPRING, {{"stiffness", 50}, {"restitution", k_restitution}, {"friction", 0}}, {edge, edge, edge});
  gas.make_periodic();
  scatter(gas, k_sphere, k_count, 10, edge, 0.1);
  const double dt = gas.contact_time(k_sphere.mass() / 2, k_sphere.radius / 2, 0.1) / 15;
  // The lattice is forgotten after two collisions a particle; the clock starts then.
  gas.advance(dt, 4000);
  const double start = temperature(gas, k_count);
  const double g0 = (1 - k_fraction / 2) / ((1 - k_fraction) * (1 - k_fraction) * (1 - k_fraction));
  const double tau = d * std::sqrt(k_pi) / (4 * (1 - k_restitution * k_restitution) * k_fraction * g0 * std::sqrt(start));
  std::vector<std::array<double, 3>> curve;
  double worst = 0;
  for (int n = 1; n <= 20; ++n) {
    gas.advance(dt, 1000);
    const double time = n * 1000 * dt, exact = 1 / ((1 + time / tau) * (1 + time / tau)), ours = temperature(gas, k_count) / start;
    curve.push_back({time / tau, ours, exact});
    worst = std::max(worst, std::abs(ours / exact - 1));
  }
  std::printf("  to t = %.2f tau, T/T0 = %.3f: %.1f %% from Haff's law at worst\n", curve.back()[0], curve.back()[1], 100 * worst);
  EXPECT_GT(curve.back()[0], 1.0);
  EXPECT_LT(worst, 0.10);   // 5 % of the rate, which counts twice in T at t = tau and later
  record({"cooling of an inelastic gas", "Haff 1983", percent(worst) + " of T", ""});
  record_curve("haff", "t / tau,T / T0,Haff's law", curve);
}

}  // namespace similitude::test
