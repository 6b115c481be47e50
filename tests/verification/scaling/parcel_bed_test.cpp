// Grains that stand for many particles: the gas must carry all of them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "../bed/small_bed.h"
#include "../record.h"

namespace similitude::test {
namespace {

constexpr double k_edge = 12e-3;   // [m], laterally periodic
constexpr double k_full_speed = 0.45, k_carried_from = 0.38;   // [m/s]: the law's u_mf is 0.33 m/s at a gas fraction of 0.42
constexpr double k_ramp = 0.9;   // [s], slow: a bed that is shaken rests on the bottom in part
constexpr int k_count = 8000;
std::string bed_case(const std::string& scaling) {
  return fmt::format(R"(
similitude: 1
title: a laterally periodic bed slowly lifted by the gas
scene:
  domain:    {{size: [12 mm, 12 mm, 200 mm], cell: 4 mm}}
  periodic:  [x, y]
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{alumina: {{diameter: 1 mm, density: 1040 kg/m^3, count: {}}}}}
  bed:       {{fill: settle, cache: false}}
  patches:
    inlet:  {{face: bottom, velocity: {} m/s, ramp: {} s}}
    outlet: {{face: top, pressure: 0 Pa}}
models:
  drag: gidaspow
  contact: {{id: linear_spring, stiffness: 100 N/m, restitution: 0.74, friction: 0.2}}
  fluid: vans
  scaling: {}
time: {{end: 1 s, dt: auto}}
)",
                     k_count, k_full_speed, k_ramp, scaling);
}

}  // namespace

class ParcelBed : public testing::TestWithParam<double> {};

// The plateau of a fluidized bed is the weight less buoyancy of all particles that the parcels stand for: n = 2 and
// n = 1.5, a weight that is no whole number. 2 %, as for the real bed:
// what bubbles shake rests on the bottom in part.
TEST_P(ParcelBed, RestsOnTheGasWithTheWeightOfAllItsParticles) {
  const double n = GetParam();
  const auto bed = small_bed(bed_case(fmt::format("{{id: parcel, n: {}}}", n)));
  const auto parcels = static_cast<double>(bed->simulation->particles().size());
  EXPECT_NEAR(parcels * n * n * n, k_count, 0.5 * n * n * n);
  const double d = 1e-3, weight = parcels * (n * n * n) * std::numbers::pi / 6 * (d * d * d) * (1040 - 1.225) * 9.81 / (k_edge * k_edge);
  double sum = 0;
  int samples = 0;
  while (bed->simulation->time() < k_ramp) {
    bed->simulation->step();
    if (bed->simulation->time() < k_ramp * k_carried_from / k_full_speed) continue;
    sum += pressure_drop(*bed);
    ++samples;
  }
  EXPECT_NEAR(sum / samples, weight, 0.02 * weight);
  record({fmt::format("fluidised bed of parcels, n = {}", n), "weight of all particles that they stand for", percent(std::abs(sum / samples / weight - 1)), ""});
  std::printf("  n = %g: %.0f parcels, %.1f Pa carry %.1f Pa\n", n, parcels, sum / samples, weight);
}

INSTANTIATE_TEST_SUITE_P(CoarseFactors, ParcelBed, testing::Values(1.5, 2.0),
                         [](const auto& info) { return info.param == 2 ? "two" : "one_and_a_half"; });

}  // namespace similitude::test
