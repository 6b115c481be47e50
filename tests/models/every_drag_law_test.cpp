// What every drag law that is installed here must do, whatever its formula: found by the catalogue, made with its
// defaults for the alumina bed.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "drag_model.h"
#include "loader/catalogue.h"

namespace similitude {
namespace {

using test::Particle;

const Catalogue& installed() {
  static const Catalogue catalogue(std::vector<SearchLevel>{search_levels({}).back()});
  return catalogue;
}

DragModel made(const std::string& id, const similitude_bed& bed = test::alumina_bed()) {
  const PluginEntry* plugin = installed().find("drag", id);
  if (!plugin) throw std::runtime_error("there is no drag law " + id);
  std::vector<similitude_value> defaults;
  for (std::uint32_t p = 0; p < plugin->descriptor->parameter_count; ++p) {
    defaults.push_back({plugin->descriptor->parameters[p].default_value, nullptr});
  }
  return create_model<similitude_drag_functions>(*plugin, bed, defaults);
}

double exchange(const DragModel& law, const Particle& particle) {
  return test::exchange(law.functions(), law.instance(), particle);
}

class EveryDragLaw : public testing::TestWithParam<std::string> {
 protected:
  DragModel law_ = made(GetParam());
};

constexpr double k_gas_fractions[] = {0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.52, 0.599999, 0.6, 0.66, 0.7, 0.79, 0.8,
                                      0.81, 0.85, 0.9, 0.91, 0.95, 0.98, 0.985, 0.99, 0.991, 0.999, 1 - 1e-9, 1 - 1e-16, 1};
constexpr double k_reynolds[] = {0, 1e-300, 1e-9, 1e-3, 0.1, 1, 3, 10, 30, 100, 300, 900, 1001, 3000, 1e4};

// Ergun's alone has nothing left where there are no neighbours and nothing moves.
TEST_P(EveryDragLaw, IsFiniteAndPositiveFromPackedToEmptyAndFromRestToFast) {
  for (const double eps : k_gas_fractions) {
    for (const double re : k_reynolds) {
      const double k = exchange(law_, {eps, test::slip_for(re)});
      EXPECT_TRUE(std::isfinite(k)) << eps << ' ' << re;
      const bool nothing_left = GetParam() == "ergun" && eps == 1 && re == 0;
      EXPECT_TRUE(nothing_left ? k == 0 : k > 0) << k << " at " << eps << ' ' << re;
    }
  }
}

// A particle that leaves the others is not to feel a step. The steepest law grows as 0.48 phi^(1/3), 2e-5 at this phi.
TEST_P(EveryDragLaw, IsContinuousTowardsAnEmptyGas) {
  for (const double re : {0.0, 1.0, 100.0, 900.0}) {
    const double empty = exchange(law_, {1, test::slip_for(re)});
    EXPECT_NEAR(exchange(law_, {1 - 1e-13, test::slip_for(re)}), empty, 3e-5 * (empty + test::k_stokes)) << re;
  }
}

// The force, K times the slip, grows with the slip: else a bed has two answers to one gas flow.
TEST_P(EveryDragLaw, PushesHarderTheFasterTheGas) {
  for (const double eps : {0.35, 0.45, 0.6, 0.75, 0.85, 0.95, 0.995, 1.0}) {
    double last = 0;
    for (double re = 1e-3; re < 1e4; re *= 1.01) {
      const double slip = test::slip_for(re), force = exchange(law_, {eps, slip}) * slip;
      EXPECT_GT(force, last) << eps << ' ' << re;
      last = force;
    }
  }
}

// A single sphere in creeping flow: Stokes' drag to 5 %, which is what Dalla Valle (-4 %) and Huilin's tail allow.
TEST_P(EveryDragLaw, IsNearStokesForASingleSphereAtRest) {
  if (GetParam() == "ergun") GTEST_SKIP() << "a packed bed's law has no viscous drag without neighbours";
  EXPECT_NEAR(exchange(law_, {1, 0}), test::k_stokes, 0.05 * test::k_stokes);
}

// r = 1/4 of the exactly similar family: d, cell 2^-2, u 2^-1, mu 2^-3, rho 1; K scales as r^(5/2) = 2^-5.
TEST_P(EveryDragLaw, KeepsItsBitsInABedScaledByPowersOfTwo) {
  similitude_bed small_bed = test::alumina_bed();
  small_bed.particle_diameter = small_bed.drag_diameter /= 4;
  small_bed.gas_viscosity /= 8;
  const DragModel small_law = made(GetParam(), small_bed);
  for (const test::State& state : test::k_states) {
    const Particle real{state.gas_fraction, 0.7 * state.slip};
    Particle small = real;
    small.slip /= 2;
    small.diameter /= 4;
    small.cell_size /= 4;
    small.viscosity /= 8;
    EXPECT_EQ(exchange(small_law, small) * 32, exchange(law_, real)) << state.gas_fraction;
  }
}

// Asking for a column costs memory and time in every gas step.
TEST_P(EveryDragLaw, AsksForNoMoreThanItUses) {
  similitude_drag_needs needs{};
  needs.struct_size = sizeof needs;
  law_.functions().needs(law_.instance(), &needs);
  EXPECT_EQ(needs.sauter_diameter, 0);
  EXPECT_EQ(needs.cell_size, GetParam() == "radl_filtered" ? 1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Installed, EveryDragLaw, testing::ValuesIn(installed().ids("drag")),
                         [](const auto& info) { return info.param; });

TEST(DragLaws, AreAllInstalled) {
  for (const char* id : {"beetstra", "di_felice", "ergun", "gidaspow", "haider_levenspiel", "huilin_gidaspow", "koch_hill",
                         "koch_hill_ladd", "radl_filtered", "rong", "schiller_naumann", "syamlal_obrien", "tang", "tenneti",
                         "wen_yu"}) {
    EXPECT_NE(installed().find("drag", id), nullptr) << id;
  }
}

}  // namespace
}  // namespace similitude
