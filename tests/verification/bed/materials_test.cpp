// Several materials through the whole program: case text, settling, steps.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "small_bed.h"

namespace similitude::test {
namespace {

std::string binary_bed(const std::string& contact) {
  return R"(
similitude: 1
title: two materials
scene:
  domain:    {size: [10 mm, 10 mm, 40 mm], cell: 2.5 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles:
    alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 300}
    glass:   {diameter: 1.5 mm, density: 2500 kg/m^3, count: 100}
  bed:       {fill: settle, cache: false}
  patches:
    inlet:  {face: bottom, velocity: 0.8 m/s, ramp: 0 s}
    outlet: {face: top, pressure: 0 Pa}
models:
  drag: gidaspow
  contact: )" + contact + R"(
  fluid: vans
time: {end: 1 s}
)";
}

const std::string k_pairs = R"(
    id: linear_spring
    stiffness: 500 N/m
    pair:
      alumina-alumina: {restitution: 0.74, friction: 0.2}
      alumina-glass:   {restitution: 0.85, friction: 0.15}
      glass-glass:     {restitution: 0.97, friction: 0.1, stiffness: 50 kN/m}
      alumina-wall:    {restitution: 0.74, friction: 0.2}
      glass-wall:      {restitution: 0.97, friction: 0.1})";

const std::string k_alike = R"(
    id: linear_spring
    stiffness: 500 N/m
    friction: 0.2
    pair:
      alumina-alumina: {restitution: 0.74}
      alumina-glass:   {restitution: 0.74}
      glass-glass:     {restitution: 0.74}
      alumina-wall:    {restitution: 0.74}
      glass-wall:      {restitution: 0.74})";

std::vector<std::uint64_t> bits_after(const SmallBed& bed, int steps) {
  for (int n = 0; n < steps; ++n) bed.simulation->step();
  std::vector<std::uint64_t> bits;
  for (const auto* rows : {&bed.simulation->particles().position, &bed.simulation->particles().velocity})
    for (const Row& row : *rows)
      for (const double number : {row.x, row.y, row.z, row.w}) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

double sphere_mass(double diameter, double density) { return density * std::numbers::pi / 6 * std::pow(diameter, 3); }

}  // namespace

TEST(TwoMaterials, SettleAndAreFluidised) {
  const auto bed = small_bed(binary_bed(k_pairs));
  EXPECT_EQ(bed->assembly->contact.sets(), 5u);
  EXPECT_EQ(bed->simulation->particles().size(), 400u);
  EXPECT_GT(bed->filled.solids_fraction, 0.5);
  EXPECT_LT(bed->filled.solids_fraction, 0.66);
  for (int n = 0; n < 50; ++n) bed->simulation->step();
  EXPECT_EQ(bed->simulation->particles().size(), 400u);
}

// Settling, time steps and every contact: sets that are alike change nothing.
TEST(TwoMaterials, WhosePairsAreAllAlikeHaveTheBitsOfOneSet) {
  const auto alike = small_bed(binary_bed(k_alike));
  const auto one = small_bed(binary_bed("{id: linear_spring, stiffness: 500 N/m, friction: 0.2, restitution: 0.74}"));
  EXPECT_EQ(alike->assembly->contact.sets(), 5u);
  EXPECT_EQ(one->assembly->contact.sets(), 1u);
  EXPECT_EQ(alike->steps.dt, one->steps.dt);
  EXPECT_EQ(alike->filled.sub_steps, one->filled.sub_steps);
  EXPECT_EQ(bits_after(*alike, 20), bits_after(*one, 20));
}

// Glass is the heavier, but its own springs are a hundred times stiffer: t_c = pi sqrt(m*/k) / sqrt(1 - zeta^2).
TEST(TwoMaterials, TakeTheirStepFromTheQuickestPair) {
  const auto attracting = [](std::string pairs) { return pairs.replace(pairs.find("500 N/m"), 7, "500 N/m\n    attraction: true"); };
  const auto bed = small_bed(binary_bed(attracting(k_pairs)));
  const TimeStepLimit& limit = bed->steps.limits[0];
  const double log_e = std::log(0.97), zeta = -log_e / std::hypot(std::numbers::pi, log_e);
  const double contact_time = std::numbers::pi * std::sqrt(sphere_mass(1.5e-3, 2500) / 2 / 50e3 / (1 - zeta * zeta));
  EXPECT_NEAR(limit.advised, contact_time / 20, 1e-9 * contact_time);
  EXPECT_EQ(limit.because, "20 steps per contact of the quickest pair, glass-glass");
}

TEST(TwoMaterials, NameTheLightestPairWhereOneSetHoldsForAll) {
  const auto bed = small_bed(binary_bed("{id: linear_spring, stiffness: 500 N/m, friction: 0.2, restitution: 0.74}"));
  EXPECT_EQ(bed->steps.limits[0].because, "20 steps per contact of the quickest pair, alumina-alumina");
}

}  // namespace similitude::test
