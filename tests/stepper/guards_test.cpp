#include "stepper/guards.h"

#include <gtest/gtest.h>

#include "particles/errors.h"

namespace similitude {
namespace {

/// Guards of an unscaled bed that keep what they warn of.
struct Watched {
  std::vector<std::string> warnings;
  Guards guards{ResultRatios{}, [this](const std::string& text) { warnings.push_back(text); },
                Hardness{"models.contact.stiffness", " (the overlap falls with its square root)"}};
};

template <class Work>
std::string message_of(Work&& work) {
  try {
    work();
  } catch (const SimulationError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Guards, ParticlesWhoseMomentumCameFromNowhereStopTheRun) {
  Watched watched;
  EXPECT_EQ(message_of([&] { watched.guards.check_balances({.momentum = 2e-6}, 0.5); }),
            "the particles' momentum and what they were given differ by 2e-06 of it at t = 0.5 s: more than rounding explains.\n"
            "  That is a fault of the program or of one of the models in use, not of the case.");
  EXPECT_EQ(message_of([&] { watched.guards.check_balances({.momentum = 9e-7}, 0.5); }), "no error");
}

TEST(Guards, ParticlesWhoseEnergyCameFromNowhereStopTheRun) {
  Watched watched;
  EXPECT_EQ(message_of([&] { watched.guards.check_balances({.energy = 1e-3}, 0.5); }),
            "the particles' energy and what they were given differ by 0.001 of it at t = 0.5 s: more than rounding explains.\n"
            "  That is a fault of the program or of one of the models in use, not of the case.");
}

TEST(Guards, ABalanceThatIsNotANumberStopsTheRun) {
  Watched watched;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of([&] { watched.guards.check_balances({.momentum = nan}, 0.5); }), "no error");
  EXPECT_NE(message_of([&] { watched.guards.check_balances({.energy = nan}, 0.5); }), "no error");
  EXPECT_NE(message_of([&] { watched.guards.check_balances({.gas_mass = nan}, 0.5); }), "no error");
}

TEST(Guards, DriftingGasWarnsOnceAndThenStops) {
  Watched watched;
  watched.guards.check_balances({.gas_mass = 9e-6}, 0.5);
  EXPECT_TRUE(watched.warnings.empty());
  watched.guards.check_balances({.gas_mass = 2e-5}, 0.5);
  watched.guards.check_balances({.gas_mass = 3e-5}, 0.6);
  ASSERT_EQ(watched.warnings.size(), 1u);
  EXPECT_EQ(watched.warnings[0],
            "the gas in the bed and what flowed in and out differ by 2e-05 of what flowed or was there at t = 0.5 s; beyond 0.01 the run stops.");
  EXPECT_EQ(message_of([&] { watched.guards.check_balances({.gas_mass = 0.02}, 0.7); }),
            "the gas in the bed and what flowed in and out differ by 0.02 of what flowed or was there at t = 0.7 s; more than 0.01 makes every gas "
            "flow doubtful.\n"
            "  Lower the gas solver's tolerance or time.gas_dt.");
}

TEST(Guards, AGasFractionDenserThanAnyPackingStopsTheRun) {
  Watched watched;
  EXPECT_EQ(message_of([&] { watched.guards.check_gas_fraction(0.05, {0.001, 0.002, 0.003}, 0.5); }),
            "the gas fraction is 0.050 at (1, 2, 3) mm, t = 0.5 s: particles have piled into each other.\n"
            "  Raise models.contact.stiffness, or coupling.smoothing if particles are larger than cells.");
}

TEST(Guards, AnOverlapOverFivePercentAndACourantNumberNearOneWarn) {
  Watched watched;
  EngineReport report;
  report.largest_overlap = {.overlap_ratio = 0.06, .particle = 3, .partner = 4, .place = {0.001, 0.002, 0.003}};
  watched.guards.check_particles(report, 0.5);
  similitude_gas_report gas{};
  gas.courant = 0.9;
  watched.guards.check_gas(gas, {}, 0.5);
  ASSERT_EQ(watched.warnings.size(), 2u);
  EXPECT_EQ(watched.warnings[0],
            "particle 3 overlaps particle 4 by 6.0 % of its diameter at (1, 2, 3) mm, t = 0.5 s: above 5 %. Raise "
            "models.contact.stiffness if that matters here.");
  EXPECT_EQ(watched.warnings[1],
            "the gas moves 0.90 cells in one gas step (CFL) at t = 0.5 s; beyond 1 the run stops. Lower time.gas_dt if that matters "
            "here.");
}

/// The hardness of a law whose table holds one parameter beside its restitution.
Hardness hardness_with(const char* name, int scales_as) {
  similitude_parameter rows[2]{};
  rows[0].name = "restitution";
  rows[0].scales_as = SIMILITUDE_SCALES_AS_RESTITUTION;
  rows[1].name = name;
  rows[1].scales_as = scales_as;
  similitude_descriptor contact{};
  contact.parameters = rows;
  contact.parameter_count = 2;
  return hardness_of(contact);
}

TEST(Guards, AdviceNamesTheParameterThatTheContactLawHas) {
  EXPECT_EQ(hardness_with("stiffness", SIMILITUDE_SCALES_AS_STIFFNESS).key, "models.contact.stiffness");
  const Hardness hertz = hardness_with("youngs_modulus", SIMILITUDE_SCALES_AS_MODULUS);
  EXPECT_EQ(hertz.key, "models.contact.youngs_modulus");
  EXPECT_EQ(hertz.falling, " (the overlap falls with its power 2/5)");
  EXPECT_EQ(hardness_with("friction", 0).key, "the contact law's stiffness");
}

TEST(Guards, WarningsGivenBeforeARestartAreNotRepeated) {
  Watched before, after;
  before.guards.check_balances({.gas_mass = 2e-5}, 0.5);
  after.guards.restore_warnings_given(before.guards.warnings_given());
  after.guards.check_balances({.gas_mass = 2e-5}, 0.6);
  EXPECT_TRUE(after.warnings.empty());
}

}  // namespace
}  // namespace similitude
