// The pressure solver: manufactured solutions, iteration counts, closed regions, same bits for any number of threads.
#include <gtest/gtest.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "boxes.h"
#include "fluid/multigrid_cg.h"

namespace similitude {
namespace {

using test::Box;
using test::BoxOptions;
using Faces = std::array<std::vector<double>, 3>;

constexpr double k_pi = std::numbers::pi;
std::size_t u(Index i) { return static_cast<std::size_t>(i); }

Faces uniform_coefficients(const Staggered& mesh, double value = 1) {
  Faces c;
  for (std::size_t a = 0; a < 3; ++a) c[a].assign(u(mesh.face_count[a]), value);
  return c;
}

std::array<const double*, 3> rows(const Faces& c) { return {c[0].data(), c[1].data(), c[2].data()}; }

/// A bed: `contrast` times the coefficient above a quarter of the height.
Faces bed_coefficients(const Staggered& mesh, double contrast) {
  Faces c = uniform_coefficients(mesh);
  for (std::size_t a = 0; a < 3; ++a) {
    for (Index f = 0; f < mesh.face_count[a]; ++f) {
      const Index k = f / (mesh.face_extent[a][0] * mesh.face_extent[a][1]);
      c[a][u(f)] = k > mesh.cells[2] / 4 ? contrast : 1;
    }
  }
  return c;
}

/// Every cell its own random value up to `contrast`, faces the mean of their cells.
Faces random_coefficients(const Staggered& mesh, double contrast) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> exponent(0, std::log10(contrast));
  std::vector<double> cells(u(mesh.cell_count));
  for (double& value : cells) value = std::pow(10, exponent(engine));
  Faces c = uniform_coefficients(mesh);
  for (std::size_t a = 0; a < 3; ++a) {
    Triple at{};
    for (at[2] = 0; at[2] < mesh.face_extent[a][2]; ++at[2]) {
      for (at[1] = 0; at[1] < mesh.face_extent[a][1]; ++at[1]) {
        for (at[0] = 0; at[0] < mesh.face_extent[a][0]; ++at[0]) {
          const auto [below, above] = mesh.cells_of_face(a, at);
          c[a][u(mesh.face(a, at))] = 0.5 * (cells[u(below >= 0 ? below : above)] + cells[u(above >= 0 ? above : below)]);
        }
      }
    }
  }
  return c;
}

std::vector<double> random_field(Index count, bool zero_mean) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> field(u(count));
  double sum = 0;
  for (double& value : field) sum += value = uniform(engine);
  if (zero_mean) {
    for (double& value : field) value -= sum / static_cast<double>(count);
  }
  return field;
}

/// div(c grad p) as the solver's documentation states it, written out once more.
std::vector<double> divergence_of_gradient(const Staggered& mesh, const Faces& c, const std::vector<double>& p) {
  std::vector<double> out(u(mesh.cell_count), 0.0);
  for (std::size_t a = 0; a < 3; ++a) {
    const double h = mesh.spacing[a];
    Triple at{};
    for (at[2] = 0; at[2] < mesh.face_extent[a][2]; ++at[2]) {
      for (at[1] = 0; at[1] < mesh.face_extent[a][1]; ++at[1]) {
        for (at[0] = 0; at[0] < mesh.face_extent[a][0]; ++at[0]) {
          if (at[a] == mesh.cells[a] && mesh.periodic[a]) continue;
          const Index f = mesh.face(a, at);
          const auto [below, above] = mesh.cells_of_face(a, at);
          if (mesh.is_open(a, f)) {
            const double flux = c[a][u(f)] * (p[u(above)] - p[u(below)]) / h;
            out[u(below)] += flux / h;
            out[u(above)] -= flux / h;
          } else if (mesh.is_pressure(a, f)) {
            const Index inside = below >= 0 ? below : above;
            out[u(inside)] += c[a][u(f)] * (0 - p[u(inside)]) / (h / 2) / h;
          }
        }
      }
    }
  }
  return out;
}

SolveReport solve(MultigridCG& solver, const std::vector<double>& rhs, std::vector<double>& p, double tolerance = 1e-8) {
  p.assign(rhs.size(), 0.0);
  return solver.solve(rhs.data(), p.data(), {.tolerance = tolerance});
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// p = product of sines that vanish on the pressure patches of all six sides: the error against the exact solution.
double error_of_sines(int n) {
  Box box({.cells = {n, n, n}, .spacing = {1.0 / n, 1.0 / n, 1.0 / n}});
  const std::uint8_t outlet = box.pressure_patch("all", 0);
  for (std::size_t a = 0; a < 3; ++a) {
    box.set_side(a, 0, outlet);
    box.set_side(a, 1, outlet);
  }
  const Staggered mesh = box.mesh();
  MultigridCG solver(box.table());
  const Faces c = uniform_coefficients(mesh);
  solver.set_coefficients(rows(c));
  std::vector<double> exact(u(mesh.cell_count)), rhs(u(mesh.cell_count)), p;
  for (Index cell = 0; cell < mesh.cell_count; ++cell) {
    const auto sine = [&](Index i) { return std::sin(k_pi * (static_cast<double>(i) + 0.5) / n); };
    exact[u(cell)] = sine(cell % n) * sine(cell / n % n) * sine(cell / (Index{n} * n));
    rhs[u(cell)] = -3 * k_pi * k_pi * exact[u(cell)];
  }
  EXPECT_TRUE(solve(solver, rhs, p, 1e-10).converged);
  return largest_difference(p, exact);
}

TEST(MultigridCG, ConvergesAtSecondOrderToAProductOfSines) {
  const double coarse = error_of_sines(12), fine = error_of_sines(24);
  EXPECT_GT(coarse / fine, 3.6);  // 4 in the limit
  EXPECT_LT(fine, 3e-3);          // pi^2 / (12 n^2) and the patches' half cells
}

struct Count {
  const char* name;
  std::array<int, 3> cells;
  int most;
};

// The bound is what a textbook V-cycle needs for eight digits, and the same for every size.
TEST(MultigridCG, NeedsAsFewIterationsOnFineGridsAsOnCoarseOnes) {
  for (const auto& [name, cells, most] : {Count{"16^3", {16, 16, 16}, 12}, Count{"32^3", {32, 32, 32}, 12},
                                          Count{"64^3", {64, 64, 64}, 12}, Count{"bed", {30, 4, 200}, 12},
                                          Count{"odd", {17, 5, 83}, 12}, Count{"sheet", {31, 1, 97}, 12}}) {
    Box box({.cells = cells});
    box.set_side(2, 1, box.pressure_patch("outlet", 0));
    const Staggered mesh = box.mesh();
    MultigridCG solver(box.table());
    for (const double contrast : {1.0, 1e4}) {
      const Faces c = bed_coefficients(mesh, contrast);
      solver.set_coefficients(rows(c));
      std::vector<double> p;
      const SolveReport report = solve(solver, random_field(mesh.cell_count, false), p);
      std::printf("%s, bed %g: %d iterations\n", name, contrast, report.iterations);
      EXPECT_TRUE(report.converged);
      EXPECT_LE(report.iterations, most) << name;
    }
    // Neighbours that differ by up to 1e4 at random have no smooth errors to speak of: slower, but it converges.
    const Faces rough = random_coefficients(mesh, 1e4);
    solver.set_coefficients(rows(rough));
    std::vector<double> p;
    const SolveReport report = solve(solver, random_field(mesh.cell_count, false), p);
    std::printf("%s, random 1e4: %d iterations\n", name, report.iterations);
    EXPECT_TRUE(report.converged) << name;
  }
}

Box& with_plates(Box& box) {
  box.set_faces(0, 12, {0, 0, 6}, {0, 4, 50}, SIMILITUDE_FACE_NO_SLIP);
  box.set_faces(0, 18, {0, 0, 6}, {0, 4, 50}, SIMILITUDE_FACE_NO_SLIP);
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  return box;
}

TEST(MultigridCG, SolvesTheSpoutedBedWithPlatesInAFewIterations) {
  Box box({.cells = {30, 4, 200}});
  with_plates(box);
  const Staggered mesh = box.mesh();
  MultigridCG solver(box.table());
  const Faces c = bed_coefficients(mesh, 1e2);
  solver.set_coefficients(rows(c));
  const std::vector<double> rhs = random_field(mesh.cell_count, false);
  std::vector<double> p(rhs.size());
  const auto clock = [] { return std::chrono::steady_clock::now(); };
  double best = 1, best_setup = 1;
  SolveReport report;
  for (int round = 0; round < 10; ++round) {
    const auto begin = clock();
    solver.set_coefficients(rows(c));
    const auto ready = clock();
    report = solver.solve(rhs.data(), p.data(), {.tolerance = 1e-8});
    best_setup = std::min(best_setup, std::chrono::duration<double>(ready - begin).count());
    best = std::min(best, std::chrono::duration<double>(clock() - ready).count());
  }
  std::printf("24 000 cells with plates: %d iterations, %.2f ms, coefficients %.2f ms\n", report.iterations, best * 1e3,
              best_setup * 1e3);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.iterations, 14);
  EXPECT_LT(largest_difference(divergence_of_gradient(mesh, c, p), rhs), 1.1e-8);  // the tolerance, largest |rhs| is 1
}

TEST(MultigridCG, InvertsTheOperatorInClosedAndPeriodicBoxesOfAnySize) {
  for (const std::array<int, 3> cells : {std::array{7, 1, 13}, std::array{1, 1, 9}, std::array{2, 3, 5}, std::array{16, 3, 12},
                                         std::array{1, 1, 1}, std::array{33, 2, 1}}) {
    for (int wrap = 0; wrap < 8; ++wrap) {
      Box box({.cells = cells, .periodic = {(wrap & 1) != 0, (wrap & 2) != 0, (wrap & 4) != 0}});
      const Staggered mesh = box.mesh();
      MultigridCG solver(box.table());
      const Faces c = random_coefficients(mesh, 10);
      solver.set_coefficients(rows(c));
      EXPECT_TRUE(solver.has_closed_region());
      const std::vector<double> rhs = random_field(mesh.cell_count, true);
      std::vector<double> p;
      const SolveReport report = solve(solver, rhs, p);
      EXPECT_TRUE(report.converged) << cells[0] << " " << cells[1] << " " << cells[2] << " wrap " << wrap;
      EXPECT_LT(report.imbalance, 1e-14);
      EXPECT_LT(largest_difference(divergence_of_gradient(mesh, c, p), rhs), 2e-8)
          << cells[0] << " " << cells[1] << " " << cells[2] << " wrap " << wrap;
    }
  }
}

TEST(MultigridCG, SubtractsTheMeanOfEveryChamberThatNoOutletReaches) {
  Box box({.cells = {8, 2, 8}});
  box.set_faces(0, 3, {0, 0, 0}, {0, 2, 8}, SIMILITUDE_FACE_NO_SLIP);  // a wall from bottom to top
  box.set_faces(2, 8, {3, 0, 0}, {8, 2, 0}, box.pressure_patch("outlet", 0));
  const Staggered mesh = box.mesh();
  MultigridCG solver(box.table());
  const Faces c = uniform_coefficients(mesh);
  solver.set_coefficients(rows(c));
  std::vector<double> rhs(u(mesh.cell_count), 0.25), p;
  const SolveReport report = solve(solver, rhs, p);
  EXPECT_TRUE(report.converged);
  EXPECT_DOUBLE_EQ(report.imbalance, 1.0);  // the chamber on the left sees nothing but its mean
  EXPECT_EQ(p[0], 0);
  const std::vector<double> image = divergence_of_gradient(mesh, c, p);
  EXPECT_NEAR(image[7], 0.25, 0.25 * 1e-8);
}

TEST(MultigridCG, ReturnsTheSameBitsForAnyNumberOfThreads) {
  Box box({.cells = {30, 4, 80}});  // large enough that work is shared
  box.set_side(2, 1, box.pressure_patch("outlet", 0));
  const Staggered mesh = box.mesh();
  MultigridCG solver(box.table());
  const Faces c = random_coefficients(mesh, 1e3);
  const std::vector<double> rhs = random_field(mesh.cell_count, false);
  std::vector<std::vector<double>> answers;
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    solver.set_coefficients(rows(c));
    answers.emplace_back();
    solve(solver, rhs, answers.back());
  }
  omp_set_num_threads(before);
  EXPECT_EQ(answers[0], answers[1]);
  EXPECT_EQ(answers[0], answers[2]);
}

TEST(MultigridCG, KeepsEveryBitWhenUnitsChangeByOddPowersOfTwo) {
  std::vector<std::vector<double>> answers;
  for (const double factor : {1.0, 0.125}) {
    Box box({.cells = {9, 3, 40}, .spacing = {factor, factor, factor}});
    box.set_side(2, 1, box.pressure_patch("outlet", 0));
    const Staggered mesh = box.mesh();
    MultigridCG solver(box.table());
    Faces c = random_coefficients(mesh, 1e3);
    for (auto& axis : c) {
      for (double& value : axis) value *= factor == 1 ? 1 : 4 * factor;
    }
    solver.set_coefficients(rows(c));
    std::vector<double> rhs = random_field(mesh.cell_count, false);
    for (double& value : rhs) value /= factor;
    answers.emplace_back();
    solve(solver, rhs, answers.back());
  }
  for (double& value : answers[1]) value *= 4;  // p goes with rhs h^2 / c: (1/f) f^2 / (4 f)
  EXPECT_EQ(answers[0], answers[1]);
}

}  // namespace
}  // namespace similitude
