// Several openings and several inlets, for every solver: who shares a pressure equation shares these.
#include <gtest/gtest.h>

#include <cmath>

#include "gas_run.h"
#include "porous_solver.h"

namespace similitude {
namespace {

using test::Box;
using test::u;

struct Vans {
  using Run = test::RunOf<vans::GasSolver, vans::GasOptions>;
  static constexpr vans::GasOptions options{.density = 1.225, .viscosity = 1.79e-5, .tolerance = 1e-10};
};
struct Porous {
  using Run = test::RunOf<porous::PorousSolver, porous::GasOptions>;
  static constexpr porous::GasOptions options{.density = 1.225, .tolerance = 1e-10};
};

template <class Gas>
class Outlets : public testing::Test {
 protected:
  using Run = typename Gas::Run;

  static Run run_in(const Box& box) { return Run(box, Gas::options); }

  /// [m^3/s], out of the faces at index `at` along `axis`, over cells [low, high) of the direction `across`.
  static double outflow(const Run& run, std::size_t axis, Index at, std::size_t across, Index low, Index high) {
    double sum = 0;
    for (Index other = 0; other < run.mesh.cells[3 - axis - across]; ++other) {
      for (Index n = low; n < high; ++n) {
        Triple place{};
        place[axis] = at;
        place[across] = n;
        place[3 - axis - across] = other;
        const auto [below, above] = run.mesh.cells_of_face(axis, place);
        const double fraction = run.gas_fraction[u(below >= 0 ? below : above)];
        sum += fraction * run.solver.face_velocity(axis)[u(run.mesh.face(axis, place))] * run.mesh.face_area(axis);
      }
    }
    return at == 0 ? -sum : sum;
  }

  template <class Bed>
  static void fill(Run& run, Bed&& bed) {
    for (Index c = 0; c < run.mesh.cell_count; ++c) {
      const Triple at{c % run.mesh.cells[0], c / run.mesh.cells[0] % run.mesh.cells[1], c / (run.mesh.cells[0] * run.mesh.cells[1])};
      const auto [fraction, exchange] = bed(at);
      run.gas_fraction[u(c)] = fraction;
      run.exchange[u(c)] = exchange;
    }
    run.gas_fraction_old = run.gas_fraction;
  }
};

using Solvers = testing::Types<Vans, Porous>;
TYPED_TEST_SUITE(Outlets, Solvers);

using Place = std::pair<double, double>;   // gas fraction, resistance

constexpr int k_wide = 12, k_deep = 2, k_high = 24;
constexpr double k_cell = 0.01, k_inflow = 0.5;   // [m], [m/s]

// Two openings in the top, left and right of a closed middle, over a bed that is the same on both sides.
TYPED_TEST(Outlets, ShareTheFlowEvenlyInASymmetricBed) {
  Box box({.cells = {k_wide, k_deep, k_high}, .spacing = {k_cell, k_cell, k_cell}, .walls = SIMILITUDE_FACE_SLIP});
  box.set_side(2, 0, box.velocity_patch("inlet", {0, 0, k_inflow}));
  box.set_faces(2, k_high, {0, 0, 0}, {4, k_deep, 0}, box.pressure_patch("left", 0));
  box.set_faces(2, k_high, {8, 0, 0}, {12, k_deep, 0}, box.pressure_patch("right", 0));
  auto run = this->run_in(box);
  this->fill(run, [](const Triple& at) { return at[2] < 10 ? Place{0.45, 5000} : Place{1, 0}; });
  for (int n = 0; n < 100; ++n) run.advance(1e-3);
  const double left = this->outflow(run, 2, k_high, 0, 0, 4), right = this->outflow(run, 2, k_high, 0, 8, 12);
  const double inflow = k_inflow * k_wide * k_deep * k_cell * k_cell;
  EXPECT_NEAR(left + right, inflow, 1e-8 * inflow);
  EXPECT_NEAR(left, right, 1e-13 * inflow);   // rounding: the pressure solver treats both sides alike
  EXPECT_NEAR(run.report.outflow, 1.225 * inflow, 1e-8 * inflow);
}

/// A shaft whose foot is empty: gas rises through packing to the top, or leaves aside through more packing to a window.
struct Branches {
  static constexpr double fraction[2] = {0.4, 0.5}, exchange[2] = {20000, 25000};   // [-], [kg/(m^3 s)]; up, aside
  static constexpr int wall = 4, foot = 8;                                           // cells
  static constexpr int length[2] = {k_high - foot, k_wide - wall}, breadth[2] = {wall, foot};   // cells

  Branches(double top_pressure, double window_pressure)
      : box({.cells = {k_wide, k_deep, k_high}, .spacing = {k_cell, k_cell, k_cell}, .walls = SIMILITUDE_FACE_SLIP}) {
    box.set_faces(2, 0, {0, 0, 0}, {wall, k_deep, 0}, box.velocity_patch("inlet", {0, 0, k_inflow}));
    box.set_faces(0, wall, {0, 0, foot}, {0, k_deep, k_high}, SIMILITUDE_FACE_SLIP);
    box.set_faces(2, foot, {wall, 0, 0}, {k_wide, k_deep, 0}, SIMILITUDE_FACE_SLIP);
    box.set_faces(2, k_high, {0, 0, 0}, {wall, k_deep, 0}, box.pressure_patch("top", top_pressure));
    box.set_faces(0, k_wide, {0, 0, 0}, {0, k_deep, foot}, box.pressure_patch("window", window_pressure));
  }
  static Place bed(const Triple& at) {
    if (at[0] < wall && at[2] < foot) return {1, 0};
    return at[0] < wall ? Place{fraction[0], exchange[0]} : Place{fraction[1], exchange[1]};
  }
  static double area(int branch) { return breadth[branch] * k_deep * k_cell * k_cell; }   // [m^2]
  /// [Pa s/m], pressure over superficial velocity: E L / eps^2. The first face lies half in the foot.
  static double resistance(int branch) {
    const double mean_fraction = 0.5 * (1 + fraction[branch]);
    const double inside = (length[branch] - 0.5) / (fraction[branch] * fraction[branch]);
    return exchange[branch] * k_cell * (inside + 0.5 / (mean_fraction * mean_fraction));
  }
  Box box;
};

// Pressure P in the foot: U_i = (P - p_i) / R_i and sum U_i A_i = Q.
TYPED_TEST(Outlets, ShareTheFlowByTheResistanceBeforeThemAndByTheirPressure) {
  for (const double top : {0.0, 400.0, -300.0}) {
    const Branches branches(top, 0);
    auto run = this->run_in(branches.box);
    this->fill(run, Branches::bed);
    for (int n = 0; n < 300; ++n) run.advance(1e-3);
    const double conductance[2] = {Branches::area(0) / Branches::resistance(0), Branches::area(1) / Branches::resistance(1)};
    const double inflow = k_inflow * Branches::wall * k_deep * k_cell * k_cell;
    const double foot = (inflow + conductance[0] * top) / (conductance[0] + conductance[1]);
    const double up = this->outflow(run, 2, k_high, 0, 0, Branches::wall);
    const double aside = this->outflow(run, 0, k_wide, 2, 0, Branches::foot);
    // What is left: the foot's own resistance and the flow's head, rho U^2 = 0.3 Pa beside hundreds.
    EXPECT_NEAR(up, conductance[0] * (foot - top), 0.005 * inflow) << top;
    EXPECT_NEAR(aside, conductance[1] * foot, 0.005 * inflow) << top;
    EXPECT_NEAR(up + aside, inflow, 1e-8 * inflow);
  }
}

// Gas in through two inlets at the floor and one in a side, out through the top and the other side; one opening far below
// the other's pressure draws gas in through the other.
TYPED_TEST(Outlets, BalanceSeveralInletsAndASideOutlet) {
  Box box({.cells = {k_wide, k_deep, k_high}, .spacing = {k_cell, k_cell, k_cell}});
  box.set_faces(2, 0, {0, 0, 0}, {4, k_deep, 0}, box.velocity_patch("slow", {0, 0, 0.3}));
  box.set_faces(2, 0, {8, 0, 0}, {12, k_deep, 0}, box.velocity_patch("fast", {0, 0, 0.9}));
  box.set_faces(0, 0, {0, 0, 2}, {0, k_deep, 5}, box.velocity_patch("side", {0.4, 0, 0}));
  box.set_faces(0, k_wide, {0, 0, 14}, {0, k_deep, 20}, box.pressure_patch("window", -2000));
  box.set_side(2, 1, box.pressure_patch("top", 0));
  auto run = this->run_in(box);
  this->fill(run, [](const Triple& at) { return at[2] < 20 ? Place{0.45, 20000} : Place{1, 0}; });
  for (int n = 0; n < 200; ++n) run.advance(1e-3);
  const double face = k_cell * k_cell;
  const double inflow = (4 * 0.3 + 4 * 0.9 + 3 * 0.4) * k_deep * face;
  const double window = this->outflow(run, 0, k_wide, 2, 14, 20), top = this->outflow(run, 2, k_high, 0, 0, k_wide);
  EXPECT_NEAR(window + top, inflow, 1e-7 * inflow);
  EXPECT_LT(top, 0);   // drawn in
  EXPECT_GT(window, inflow);
  EXPECT_NEAR(run.report.outflow - run.report.inflow, 0, 1e-7 * run.report.outflow);
  EXPECT_LT(run.report.mass_residual, 1.1e-10);
}

}  // namespace
}  // namespace similitude
