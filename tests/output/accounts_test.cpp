#include "output/accounts.h"

#include <gtest/gtest.h>

using namespace similitude;

// Two particles that fly apart and nothing that acts on them: their total momentum is rounding, and no measure of rounding.
TEST(Accounts, JudgeMomentaThatCancelByWhatEachParticleHas) {
  constexpr double mass = 1e-6, speed = 0.3, rounding = 1e-16;   // [kg], [m/s], relative
  ParticleStore particles;
  for (const double v : {speed, -speed}) {
    const std::size_t row = particles.add(particles.size(), 0, 0.01, 0.01, 0.01, 5e-4, mass);
    particles.velocity[row].x = v;
  }
  const Accounts accounts(particles, 0);
  particles.velocity[0].x *= 1 + 4 * rounding;
  EXPECT_LT(accounts.balances(particles, {}, {}).momentum, 1e-14);

  // What is no rounding is still seen: a thousandth of one of them, over the two of them.
  particles.velocity[0].x = speed * 1.001;
  EXPECT_NEAR(accounts.balances(particles, {}, {}).momentum, 0.001 / 2.001, 1e-9);
}
