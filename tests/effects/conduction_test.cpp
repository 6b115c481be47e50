/// Heat through contacts, where lists are made anew.

#include <gtest/gtest.h>

#include "effect_case.h"

namespace similitude::test {
namespace {

constexpr const char* k_pair_and_one_more = R"(
similitude: 1
title: two that touch, and one below the opening
scene:
  domain:    {size: [20 mm, 20 mm, 20 mm], cell: 5 mm}
  gas:       {density: 1e-9 kg/m^3, viscosity: 1e-12 Pa s, temperature: 300 K, heat_capacity: 1000 J/(kg K), conductivity: 1e-6 W/(m K)}
  particles:
    hot:  {diameter: 1 mm, density: 2500 kg/m^3, temperature: 400 K, heat_capacity: 800 J/(kg K), conductivity: 2 W/(m K)}
    cold: {diameter: 1 mm, density: 2500 kg/m^3, temperature: 300 K, heat_capacity: 800 J/(kg K), conductivity: 2 W/(m K)}
  gravity:   0 m/s^2
  bed:       {fill: none}
  patches:   {outlet: {face: top, pressure: 0 Pa}}
models:
  drag: schiller_naumann
  contact: {id: linear_spring, stiffness: 1000 N/m, restitution: 0.5, friction: 0}
  fluid: prescribed
  scaling: exact
  effects: [heat]
time: {end: 1 s, dt: 1 us, gas_dt: 10 us}
)";

/// [K], of the hot one after a gas step of ten sub-steps, in the last of which the third leaves or stays.
double hot_after_a_step(bool leaves) {
  const Assembly assembly = assemble(case_of(k_pair_and_one_more).scene, built_plugins());
  ParticleStore particles(store_fields(assembly));
  const double mass = 2500 * k_pi / 6 * 1e-9, way = 9.5e-6;
  const auto add = [&](std::uint32_t species, double x, double z, double speed) {
    const std::size_t row = particles.add(particles.size(), species, x, 10e-3, z, 0.5e-3, mass);
    particles.velocity[row] = {0, 0, speed, mass};
  };
  add(0, 5e-3, 5e-3, 0);
  add(1, 5.999e-3, 5e-3, 0);
  add(1, 15e-3, 20e-3 - way, leaves ? 1 : 0);
  const auto bed = small_bed(k_pair_and_one_more, &particles);
  bed->simulation->step();
  const ParticleStore& after = bed->simulation->particles();
  EXPECT_EQ(after.size(), leaves ? 2u : 3u);
  for (std::size_t row = 0; row < after.size(); ++row) {
    if (after.id[row] == 0) return after.scalars[0].value[row];
  }
  return 0;
}

TEST(Conduction, GoesOnWhenSomebodyLeavesThoughContactsRememberNothing) {
  const double hot = hot_after_a_step(false);
  EXPECT_LT(hot, 400);
  EXPECT_EQ(hot_after_a_step(true), hot);
}

}  // namespace
}  // namespace similitude::test
