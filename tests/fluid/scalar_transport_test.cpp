// What the gas carries: closed forms of advection, diffusion and exchange; budgets; what must not change a bit.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "boxes.h"
#include "fluid/scalar_transport.h"

namespace similitude {
namespace {

using test::Box;
constexpr double k_closed = std::numeric_limits<double>::quiet_NaN();

std::size_t u(Index row) { return static_cast<std::size_t>(row); }

/// A scalar in a given flow.
struct Carried {
  explicit Carried(const Box& box) : mesh(box.table()), transport(box.table()), patch_value(box.table().patch_count, 0.0) {
    for (std::size_t a = 0; a < 3; ++a) flux[a].assign(u(mesh.face_count[a]), 0.0);
    for (auto* field : {&fraction, &fraction_old}) field->assign(u(mesh.cell_count), 1.0);
    for (auto* field : {&phi, &mean}) field->assign(u(mesh.cell_count), 0.0);
    terms.wall = k_closed;
  }
  void set_flux(std::size_t axis, double value) { std::fill(flux[axis].begin(), flux[axis].end(), value); }
  void set_exchange(double rate, double level) {
    exchange.assign(u(mesh.cell_count), rate);
    source.assign(u(mesh.cell_count), rate * level);
  }
  ScalarStep step(double dt) const {
    return {dt, fraction.data(), fraction_old.data(), {flux[0].data(), flux[1].data(), flux[2].data()}};
  }
  ScalarBudget advance(double dt) {
    terms.patch_value = patch_value.data();
    terms.exchange = exchange.empty() ? nullptr : exchange.data();
    terms.exchange_source = exchange.empty() ? nullptr : source.data();
    return transport.advance(step(dt), terms, phi.data(), mean.data());
  }
  double at(const Triple& cell) const { return phi[u(mesh.cell(cell))]; }

  Staggered mesh;
  ScalarTransport transport;
  ScalarTerms terms;
  std::array<std::vector<double>, 3> flux;
  std::vector<double> fraction, fraction_old, phi, mean, exchange, source, patch_value;
};

double wave_error(int cells, double courant) {
  Box box({.cells = {cells, 1, 1}, .spacing = {1.0 / cells, 1, 1}, .periodic = {true, true, true}});
  Carried run(box);
  run.set_flux(0, 1);
  const auto exact = [](double x) { return std::sin(2 * std::numbers::pi * x); };
  for (Index i = 0; i < cells; ++i) run.phi[u(i)] = exact((static_cast<double>(i) + 0.5) / cells);
  const int steps = static_cast<int>(std::lround(cells / courant));
  for (int n = 0; n < steps; ++n) run.advance(courant / cells);
  double error = 0;
  for (Index i = 0; i < cells; ++i) error += std::abs(run.phi[u(i)] - exact((static_cast<double>(i) + 0.5) / cells)) / cells;
  return error;
}

// The limiter clips the two extremes, so the mean error falls a little slower than with h^2 at worst.
TEST(ScalarTransport, CarriesASmoothWaveToSecondOrder) {
  const double coarse = wave_error(64, 0.25), fine = wave_error(128, 0.25);
  EXPECT_GT(std::log2(coarse / fine), 1.9) << coarse << " " << fine;
}

TEST(ScalarTransport, MakesNoNewExtremesOfAStepHoweverLongTheTimeStep) {
  for (const double courant : {0.3, 0.5, 1.7, 6.0}) {
    Box box({.cells = {50, 1, 1}, .spacing = {1, 1, 1}, .periodic = {true, true, true}});
    Carried run(box);
    run.set_flux(0, 1);
    for (Index i = 10; i < 30; ++i) run.phi[u(i)] = 1;
    const double before = run.transport.amount(run.fraction.data(), run.phi.data(), 0);
    for (int n = 0; n < 20; ++n) run.advance(courant);
    for (const double phi : run.phi) {
      EXPECT_GE(phi, -1e-14) << courant;
      EXPECT_LE(phi, 1 + 1e-14) << courant;
    }
    EXPECT_NEAR(run.transport.amount(run.fraction.data(), run.phi.data(), 0), before, 1e-12 * before);
  }
}

// A gas solver balances to its tolerance only. A gas that is the same everywhere must not notice.
TEST(ScalarTransport, LeavesAUniformGasAloneThoughFluxesDoNotBalance) {
  Box box({.cells = {4, 4, 6}, .spacing = {1, 1, 1}});
  box.set_side(2, 0, box.velocity_patch("inlet", {0, 0, 1}));
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  Carried run(box);
  run.set_flux(2, 1);
  for (std::size_t f = 0; f < run.flux[2].size(); ++f) run.flux[2][f] += 1e-3 * static_cast<double>(f % 7);
  run.patch_value = {300, 300};
  run.terms.reference = 300;
  std::fill(run.phi.begin(), run.phi.end(), 300.0);
  for (int n = 0; n < 10; ++n) run.advance(0.4);
  for (const double phi : run.phi) EXPECT_EQ(phi, 300.0);
}

// Between two walls that hold 1 and (by the reference that only shifts the amounts) a source-free gas: phi is 1 everywhere;
// with a uniform source b the profile is b/(2D) x (L - x), exact at the cells' centres but for the wall cells' half step.
TEST(ScalarTransport, ReachesTheParabolaOfAHeatedGasBetweenWalls) {
  const int cells = 20;
  Box box({.cells = {cells, 1, 1}, .spacing = {1.0 / cells, 1, 1}, .periodic = {false, true, true}});
  Carried run(box);
  run.terms.wall = 2;
  run.terms.diffusivity = 0.5;
  run.exchange.assign(u(cells), 0.0);
  run.source.assign(u(cells), 1.0);
  for (int n = 0; n < 4000; ++n) run.advance(2e-3);
  for (Index i = 0; i < cells; ++i) {
    const double x = (static_cast<double>(i) + 0.5) / cells;
    const double h = 1.0 / cells;
    EXPECT_NEAR(run.phi[u(i)], 2 + x * (1 - x) + 0.25 * h * h, 1e-9) << i;   // the wall's one-sided half step adds h^2/(8 D)
  }
}

// Hot gas through a packed bed held at 0: phi = exp(-a z / F). The flux is given, so the length is F/a.
double packed_bed_error(int cells, double dt) {
  Box box({.cells = {2, 2, cells}, .spacing = {1, 1, 2.0 / cells}});
  box.set_side(2, 0, box.velocity_patch("inlet", {0, 0, 0.5}));
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  Carried run(box);
  run.set_flux(2, 0.5);
  std::fill(run.fraction.begin(), run.fraction.end(), 0.4);
  run.fraction_old = run.fraction;
  run.set_exchange(1, 0);
  run.patch_value = {1, 0};
  for (double time = 0; time < 12; time += dt) run.advance(dt);
  double error = 0;
  // An opening lets out what its cell holds, which makes no extremes but is of first order; the face before it sees that cell.
  for (int k = 0; k + 2 < cells; ++k) {
    const double z = 2.0 * (k + 0.5) / cells;
    error = std::max(error, std::abs(run.at({1, 0, k}) - std::exp(-z / 0.5)));
  }
  return error;
}

TEST(ScalarTransport, CoolsInAPackedBedOverTheLengthOfItsExchange) {
  const double coarse = packed_bed_error(40, 0.02), fine = packed_bed_error(80, 0.01);
  EXPECT_LT(fine, 2e-3);
  EXPECT_GT(std::log2(coarse / fine), 1.8) << coarse << " " << fine;
}

TEST(ScalarTransport, ReachesASteadyStateThatDoesNotDependOnTheStep) {
  EXPECT_NEAR(packed_bed_error(20, 0.03), packed_bed_error(20, 0.015), 1e-12);
}

// Everything at once: inflow, outflow, walls, exchange, diffusion, a bed that settles, a step cut into parts.
TEST(ScalarTransport, ClosesItsBudget) {
  Box box({.cells = {5, 4, 9}, .spacing = {0.01, 0.01, 0.02}});
  box.set_faces(2, 0, {1, 1, 0}, {4, 3, 0}, box.velocity_patch("inlet", {0, 0, 1}));
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  Carried run(box);
  const Staggered& mesh = run.mesh;
  for (Index k = 0; k <= 9; ++k) {
    for (Index j = 1; j < 3; ++j) {
      for (Index i = 1; i < 4; ++i) run.flux[2][u(mesh.face(2, {i, j, k}))] = 1 + 0.1 * static_cast<double>(k);
    }
  }
  run.terms = {.diffusivity = 2e-5, .reference = 300, .wall = 350};
  run.set_exchange(40, 900);
  run.patch_value = {600, 300};
  std::fill(run.phi.begin(), run.phi.end(), 320.0);
  double given = 0, largest = 0;
  const double before = run.transport.amount(run.fraction.data(), run.phi.data(), 300);
  for (int n = 0; n < 50; ++n) {
    run.fraction_old = run.fraction;
    for (Index c = 0; c < mesh.cell_count; ++c) run.fraction[u(c)] = 0.7 + 0.2 * std::sin(0.1 * static_cast<double>(n + c));
    const ScalarBudget budget = run.advance(0.02);
    given += budget.in - budget.out + budget.walls + budget.exchanged;
    largest = std::max({largest, budget.in, budget.out, budget.walls, budget.exchanged});
  }
  const double after = run.transport.amount(run.fraction.data(), run.phi.data(), 300);
  EXPECT_NEAR(after - before, given, 1e-12 * 50 * largest);
}

// Particles take a (mean) - b: the gas's own sum of it.
TEST(ScalarTransport, GivesParticlesWhatTheGasLost) {
  Box box({.cells = {6, 1, 1}, .spacing = {0.1, 0.1, 0.1}, .periodic = {true, true, true}});
  Carried run(box);
  run.set_flux(0, 1);
  run.set_exchange(30, 2);
  for (Index i = 0; i < 3; ++i) run.phi[u(i)] = 5;
  const double dt = 0.3;   // three cells: cut into parts
  const ScalarBudget budget = run.advance(dt);
  double received = 0;
  for (const double mean : run.mean) received += 30 * (mean - 2) * dt * 1e-3;
  EXPECT_NEAR(received, -budget.exchanged, 1e-13 * std::abs(received));
}

TEST(ScalarTransport, HasTheSameBitsForAnyNumberOfThreadsAndABedScaledByPowersOfTwo) {
  const auto run_of = [](int threads, double scale) {
    omp_set_num_threads(threads);
    Box box({.cells = {24, 24, 24}, .spacing = {0.01 * scale, 0.01 * scale, 0.01 * scale}, .periodic = {true, true, false}});
    Carried run(box);
    for (std::size_t a = 0; a < 2; ++a) run.set_flux(a, scale * (a == 0 ? 0.3 : -0.2));
    run.terms = {.diffusivity = 1e-4 * scale * scale, .reference = 1, .wall = 2};
    run.set_exchange(3, 5);
    for (std::size_t c = 0; c < run.phi.size(); ++c) run.phi[c] = static_cast<double>(c % 17);
    double exchanged = 0;
    for (int n = 0; n < 3; ++n) exchanged += run.advance(0.02).exchanged;
    return std::pair(run.phi, exchanged);
  };
  const int threads = omp_get_max_threads();
  const auto one = run_of(1, 1), four = run_of(4, 1), half = run_of(1, 0.5);
  omp_set_num_threads(threads);
  EXPECT_EQ(one, four);
  EXPECT_EQ(one.first, half.first);
  EXPECT_EQ(one.second, half.second * 8);
}

}  // namespace
}  // namespace similitude
