// Benyahia, Syamlal & O'Brien (2006), Powder Technol. 162, 166: F over Stokes' drag at the superficial velocity times eps,
// of the Reynolds number of the radius. No public table: the paper's form, written out here with its branches, and F
// evaluated from it apart from this code.
#include <gtest/gtest.h>

#include <cmath>

#include "drag_model.h"

namespace similitude {
namespace {

using namespace test;

/// The four functions of the solids fraction, as the paper lists them.
struct Paper {
  double phi, f0, f1, f2, f3;

  explicit Paper(double solids_fraction) : phi(solids_fraction) {
    const double packed = 10 * phi / std::pow(1 - phi, 3);
    const double w = std::exp(-10 * (0.4 - phi) / phi);
    const double above = 1 + 3 * std::sqrt(phi / 2) + 135.0 / 64 * phi * std::log(phi);
    f0 = f2 = packed;
    if (phi < 0.4) {
      f0 = (1 - w) * (above + 17.14 * phi) / (1 + 0.681 * phi - 8.48 * phi * phi + 8.16 * phi * phi * phi) + w * packed;
      f2 = (1 - w) * (above + 17.89 * phi) / (1 + 0.681 * phi - 11.03 * phi * phi + 15.41 * phi * phi * phi) + w * packed;
    }
    f1 = phi <= 0.1 ? std::sqrt(2 / phi) / 40 : 0.11 + 5.1e-4 * std::exp(11.6 * phi);
    f3 = phi < 0.0953 ? 0.9351 * phi + 0.03667 : 0.0673 + 0.212 * phi + 0.0232 / std::pow(1 - phi, 5);
  }

  /// The Reynolds number from which on F = F2 + F3 Re.
  double turn() const {
    if (phi <= 0.01) return (f2 - 1) / (3.0 / 8 - f3);
    return (f3 + std::sqrt(f3 * f3 - 4 * f1 * (f0 - f2))) / (2 * f1);
  }

  double drag(double reynolds) const {
    if (reynolds > turn()) return f2 + f3 * reynolds;
    return phi <= 0.01 ? 1 + 3.0 / 8 * reynolds : f0 + f1 * reynolds * reynolds;
  }
};

const DragModel& law() {
  static const DragModel model(KOCH_HILL_LADD, {Values{}});
  return model;
}

/// F at a solids fraction and a Reynolds number of the radius, eps Re / 2.
double drag(const DragModel& model, double phi, double reynolds) {
  const double eps = 1 - phi;
  return factor(model, eps, 2 * reynolds / eps) / (eps * eps);
}
double drag(double phi, double reynolds) { return drag(law(), phi, reynolds); }

TEST(DragKochHillLadd, HasTheHandComputedDragInEveryBranch) {
  struct Row {
    double phi, reynolds, drag;
  };
  const Row table[] = {{0.005, 0.2, 1.075},  {0.005, 2, 1.262566}, {0.05, 0.5, 2.027343}, {0.05, 20, 3.704282},
                       {0.2, 1, 5.56312},    {0.2, 10, 7.729174},  {0.3, 2, 10.35624},    {0.3, 20, 16.08732},
                       {0.39, 1, 17.50337},  {0.39, 50, 38.37096}, {0.5, 2, 41.11381},    {0.5, 100, 131.57}};
  for (const Row& row : table) {   // seven digits
    EXPECT_NEAR(drag(row.phi, row.reynolds), row.drag, 1e-6 * row.drag) << row.phi << ' ' << row.reynolds;
  }
}

TEST(DragKochHillLadd, IsThePapersFormEverywhere) {
  for (double phi = 0.002; phi < 0.7; phi += 0.0061) {
    const Paper paper(phi);
    for (const double reynolds : {0.0, 0.1, 0.4, 1.0, 3.0, 10.0, 100.0, 3000.0}) {
      const double expected = paper.drag(reynolds);
      EXPECT_NEAR(drag(phi, reynolds), expected, 1e-11 * expected) << phi << ' ' << reynolds;
    }
  }
}

// Slow and fast flow meet where their formulas are equal; without a root there the law would be broken.
TEST(DragKochHillLadd, IsContinuousWhereSlowFlowTurnsFast) {
  for (const double phi : {0.001, 0.0099, 0.0101, 0.05, 0.1, 0.2, 0.3, 0.37, 0.39, 0.395, 0.4, 0.5, 0.65}) {
    const double turn = Paper(phi).turn();
    ASSERT_GT(turn, 0) << phi;
    const double before = drag(phi, turn * (1 - 1e-9)), after = drag(phi, turn * (1 + 1e-9));
    EXPECT_NEAR(after, before, 1e-7 * before) << phi;
    EXPECT_GT(drag(phi, 0.9 * turn), drag(phi, 0.5 * turn)) << phi;
  }
}

TEST(DragKochHillLadd, IsContinuousInTheSolidsFractionAt04) {
  for (const double reynolds : {0.0, 1.0, 10.0, 1000.0}) {
    const double before = drag(0.4 - 1e-9, reynolds);
    EXPECT_NEAR(drag(0.4 + 1e-9, reynolds), before, 1e-6 * before) << reynolds;
  }
}

// The paper switches there from a single sphere's 1 + 3/8 Re to arrays. In fast flow both use the same line.
TEST(DragKochHillLadd, JumpsBy28PerCentAtRestAtSolidsFraction001) {
  EXPECT_DOUBLE_EQ(drag(0.01 - 1e-9, 0), 1);
  EXPECT_NEAR(drag(0.01 + 1e-9, 0), 1.2788, 5e-5);
  EXPECT_NEAR(drag(0.01 + 1e-9, 10), drag(0.01 - 1e-9, 10), 1e-6 * drag(0.01, 10));
}

// sqrt(20)/40 = 0.11180 against 0.11 + 5.1e-4 exp(1.16) = 0.11163.
TEST(DragKochHillLadd, StepsLittleWhereItsFitsMeet) {
  const double reynolds = 1.7;   // just below the turn
  EXPECT_NEAR(drag(0.1 + 1e-9, reynolds), drag(0.1 - 1e-9, reynolds), 2.5e-4 * drag(0.1, reynolds));
  EXPECT_NEAR(drag(0.0953 + 1e-9, 100), drag(0.0953 - 1e-9, 100), 1e-4 * drag(0.0953, 100));
}

TEST(DragKochHillLadd, IsStokesAtRestAndNearlyStraightInAnEmptyGas) {
  EXPECT_DOUBLE_EQ(factor(law(), 1, 0), 1);
  EXPECT_NEAR(factor(law(), 1, 100), 1 + 0.03667 * 50, 1e-12);
}

// The short form has neither the slow flow's curvature nor the dilute fits: 12 % above solids fractions of 0.1, twice the
// drag in an empty gas. In fast flow through packed beds they are one formula.
TEST(DragKochHillLadd, AgreesWithTheShortFormInDenseBeds) {
  const DragModel short_form(KOCH_HILL, {Values{}});
  for (double phi = 0.1; phi < 0.65; phi += 0.01) {
    for (const double reynolds : {0.0, 0.3, 1.0, 3.0, 10.0, 100.0, 1000.0}) {
      const double here = drag(phi, reynolds);
      EXPECT_NEAR(drag(short_form, phi, reynolds), here, 0.13 * here) << phi << ' ' << reynolds;
      if (phi > 0.4 && reynolds > Paper(phi).turn()) {
        EXPECT_NEAR(drag(short_form, phi, reynolds), here, 1e-11 * here);
      }
    }
  }
  EXPECT_GT(factor(short_form, 1, 1000), 2 * factor(law(), 1, 1000));
}

}  // namespace
}  // namespace similitude
