/// With effects that remember contacts, hold added mass and turn particles: the same bits across a restart, for any number of
/// threads, and for a bed scaled by powers of two.

#include <gtest/gtest.h>

#include <omp.h>

#include <cstring>

#include "effect_case.h"
#include "output/state_hash.h"

namespace similitude::test {
namespace {

EffectCase lively() {
  return {.diameter = 4e-3, .density = 1500, .gas_density = 800, .gas_viscosity = 1e-3,
          .contact = "{id: hertz_mindlin, youngs_modulus: 1 MPa, poisson_ratio: 0.25, restitution: 0.5, friction: 0.4}",
          .fluid = "vans",
          .effects = "[{id: rolling_friction, coefficient: 0.05, model: epsd, stiffness: 1000 N/m}, "
                     "{id: cohesion, model: jkr, surface_energy: 0.5 J/m^2}, virtual_mass, saffman_lift, magnus_lift]",
          .dt = 2e-5, .sub_steps = 4};
}

std::vector<Placed> heap() {
  std::vector<Placed> balls;
  for (int k = 0; k < 6; ++k) {
    for (int j = 0; j < 6; ++j) {
      for (int i = 0; i < 6; ++i) {
        const double turn = i + 2.3 * j + 5.7 * k;
        balls.push_back({.place = {4e-3 + 4.1e-3 * i, 4e-3 + 4.1e-3 * j, 4e-3 + 4.1e-3 * k},
                         .velocity = {0.2 * std::sin(turn), 0.2 * std::cos(3 * turn), 0.2 * std::sin(7 * turn)},
                         .spin = {30 * std::cos(turn), 20 * std::sin(2 * turn), 10}});
      }
    }
  }
  return balls;
}

std::string hash(const SmallBed& bed) {
  return state_hash(bed.simulation->particles(), &bed.simulation->gas(), &bed.simulation->exchange().gas_fraction);
}

TEST(EffectsRestart, GoesOnWithTheSameBits) {
  const auto whole = lively().with(heap());
  for (int n = 0; n < 30; ++n) whole->simulation->step();
  SimulationState state;
  whole->simulation->save(state);
  for (int n = 0; n < 30; ++n) whole->simulation->step();

  const auto second = lively().with(heap());
  second->simulation->restore(state);
  for (int n = 0; n < 30; ++n) second->simulation->step();
  EXPECT_EQ(hash(*second), hash(*whole));
}

TEST(EffectsRestart, AnyNumberOfThreadsGivesTheSameBits) {
  const int threads = omp_get_max_threads();
  std::vector<std::string> hashes;
  for (const int n : {1, 2, 3}) {
    omp_set_num_threads(n);
    const auto bed = lively().with(heap());
    for (int step = 0; step < 30; ++step) bed->simulation->step();
    hashes.push_back(hash(*bed));
  }
  omp_set_num_threads(threads);
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace similitude::test
