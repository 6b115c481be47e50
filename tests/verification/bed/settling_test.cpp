// Hindered settling: Richardson & Zaki (1954), Trans. Inst. Chem. Eng. 32, 35: u/u_t = eps^n, n = 4.65 for Re_t < 0.2. Wen & Yu's drag was
// fitted to it: in Stokes flow its eps^-2.65 gives the same n. Here it must come out of the whole program: particles, drag, back-flow.
#include <cmath>
#include <numbers>
#include <random>

#include "record.h"
#include "small_bed.h"

namespace similitude::test {
namespace {

constexpr double k_diameter = 1e-3, k_density = 2500, k_gas_density = 1000, k_viscosity = 0.1;   // [m], [kg/m^3], [Pa s]

/// [m/s], mean of those between a third and two thirds of the height, over the second half of the time, downward.
double settling_velocity(int nx, int nz) {
  const double edge = 8e-3, height = 40e-3;
  ParticleStore particles({.rotation = false, .coupling = true});
  std::mt19937_64 random(1);
  const auto jitter = [&random] { return 0.2 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5); };
  const double px = edge / nx, pz = height / nz, mass = k_density * std::numbers::pi / 6 * k_diameter * k_diameter * k_diameter;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < nx; ++j) {
      for (int i = 0; i < nx; ++i) {
        particles.add(particles.size(), 0, px * (i + 0.5 + jitter()), px * (j + 0.5 + jitter()), pz * (k + 0.5 + jitter()),
                      k_diameter / 2, mass);
      }
    }
  }
  const auto bed = small_bed(R"(
similitude: 1
title: a suspension that settles
scene:
  domain:    {size: [8 mm, 8 mm, 40 mm], cell: 2 mm}
  periodic:  [x, y]
  gas:       {density: 1000 kg/m^3, viscosity: 0.1 Pa s}
  particles: {sphere: {diameter: 1 mm, density: 2500 kg/m^3}}
  bed:       {fill: none}
models:
  drag: wen_yu
  contact: {id: linear_spring, stiffness: 2 N/m, restitution: 0.5, friction: 0}
  fluid: vans
  scaling: exact
  effects: []   # the law was fitted to what drag alone does
coupling: {smoothing: 6 mm}
time: {end: 1 s, dt: auto}
)",
                             &particles);
  double sum = 0;
  std::size_t samples = 0;
  while (bed->simulation->time() < 0.2) {
    bed->simulation->step();
    if (bed->simulation->time() < 0.1) continue;
    const ParticleStore& now = bed->simulation->particles();
    for (std::size_t row = 0; row < now.size(); ++row) {
      if (now.position[row].z < height / 3 || now.position[row].z > 2 * height / 3) continue;
      sum -= now.velocity[row].z;
      ++samples;
    }
  }
  return sum / static_cast<double>(samples);
}

}  // namespace

TEST(RichardsonZaki, ASuspensionSettlesWithTheExponentOfStokesFlow) {
  const double stokes = (k_density - k_gas_density) * 9.81 * k_diameter * k_diameter / (18 * k_viscosity);
  // Schiller & Naumann's correction at the Reynolds number of the single sphere, 0.08: 1 + 0.15 Re^0.687.
  double single = stokes;
  for (int n = 0; n < 20; ++n) single = stokes / (1 + 0.15 * std::pow(k_gas_density * single * k_diameter / k_viscosity, 0.687));
  std::vector<std::array<double, 3>> curve;
  double worst = 0;
  for (const auto& [nx, nz] : {std::pair{4, 20}, std::pair{5, 25}, std::pair{6, 29}, std::pair{7, 30}}) {
    const double fraction = 1 - nx * nx * nz * std::numbers::pi / 6 * 1e-9 / (64e-6 * 40e-3);
    const double expected = std::pow(fraction, 4.65), ours = settling_velocity(nx, nz) / single;
    curve.push_back({fraction, ours, expected});
    std::printf("  eps %.3f: u/u_t %.4f, Richardson-Zaki %.4f, n %.2f\n", fraction, ours, expected, std::log(ours) / std::log(fraction));
    worst = std::max(worst, std::abs(std::log(ours) / std::log(fraction) / 4.65 - 1));
  }
  EXPECT_LT(worst, 0.03);   // of n: Re is not 0, and a suspension does not stay uniform
  record({"hindered settling, gas fraction 0.7 to 0.93", "Richardson & Zaki 1954, n = 4.65", percent(worst) + " of n", ""});
  record_curve("settling", "gas fraction,u / u_t,Richardson-Zaki", curve);
}

}  // namespace similitude::test
