// Two hundred particles at rest, for as many sub-steps as SIMILITUDE_STEPS says: nothing may creep and nothing may warm up.
#include <cstdlib>
#include <numbers>

#include "hard_case.h"

namespace similitude::test {

TEST(AtRest, ABedNeitherCreepsNorHeats) {
  const char* asked = std::getenv("SIMILITUDE_STEPS");
  const std::int64_t sub_steps = asked != nullptr ? std::atoll(asked) : 10'000;
  HardCase c;
  c.size = "[5 mm, 5 mm, 20 mm]";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 200}";
  const auto bed = small_bed(text_of(c));
  Simulation& simulation = *bed->simulation;
  Watch watch(*bed);
  watch.until(0.1);   // [s]: filling ends when the bed rests on the whole
  const std::int64_t gas_steps = std::max<std::int64_t>(sub_steps / bed->steps.sub_steps, 20);
  ParticleStore start = empty_store();
  start.copy_rows(simulation.particles());
  double energy_early = 0, energy_late = 0;   // [J], the largest in a tenth of the run
  for (std::int64_t n = 0; n < gas_steps; ++n) {
    watch.step();
    double& largest = n < gas_steps / 10 ? energy_early : energy_late;
    if (n < gas_steps / 10 || n >= gas_steps - gas_steps / 10) largest = std::max(largest, energy_of(simulation.particles()));
  }
  ASSERT_EQ(simulation.particles().size(), start.size());
  std::vector<double> moved;   // [m]
  for (std::size_t row = 0; row < start.size(); ++row) {
    for (std::size_t now = 0; now < start.size(); ++now) {
      if (simulation.particles().id[now] != start.id[row]) continue;
      const Row &a = start.position[row], &b = simulation.particles().position[now];
      moved.push_back(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z));
    }
  }
  // A particle that nothing holds from above rocks in its dent for half a second: nothing but the gas brakes a sphere that rolls.
  std::ranges::sort(moved);
  const double farthest = moved[moved.size() * 95 / 100];
  std::printf("  %lld sub-steps: 95 of 100 moved by less than %.3g diameters, kinetic energy %.3g J early, %.3g J late\n",
              static_cast<long long>(gas_steps * bed->steps.sub_steps), farthest / 1e-3, energy_early, energy_late);
  EXPECT_LT(farthest, 1e-3 * 1e-3);   // a thousandth of a diameter
  // At rest a particle's kinetic energy is next to nothing against lifting it by its diameter.
  constexpr double k_lift = 1040 * std::numbers::pi / 6 * 1e-9 * 9.81 * 1e-3;   // [J], m g d
  EXPECT_LT(energy_late / 200, 1e-4 * k_lift);
  // What rocks trades kinetic energy for height: the largest of two windows can be compared where each holds a swing.
  constexpr double k_swing = 0.5;   // [s]
  if (static_cast<double>(gas_steps) / 10 * bed->steps.gas_dt() >= k_swing) {
    EXPECT_LE(energy_late, 2 * energy_early);
  }
  watch.expect_sound(0.01);
}

}  // namespace similitude::test
