/// Which effects a scene calls for, where one class of particles or one number of the scene decides.

#include <gtest/gtest.h>

#include "effect_case.h"
#include "stepper/effect_price.h"
#include "stepper/effects.h"

namespace similitude::test {
namespace {

/// A scene at rest, with these classes of particles and these keys of the gas.
RealScene scene_of(const std::string& classes, const std::string& gas = "", const std::string& fluid = "prescribed") {
  return case_of(fmt::format(R"(
similitude: 1
title: classes
scene:
  domain:    {{size: [20 mm, 20 mm, 60 mm], cell: 5 mm}}
  gas:       {{density: 1.2 kg/m^3, viscosity: 1.8e-5 Pa s{}}}
  particles: {{{}}}
  bed:       {{fill: lattice}}
models: {{drag: schiller_naumann, fluid: {}, scaling: exact, effects: auto,
         contact: {{id: linear_spring, stiffness: 1000 N/m, restitution: 0.5, friction: 0.3}}}}
time: {{end: 1 s, dt: auto}}
)",
                             gas, classes, fluid)).scene;
}

EffectVerdict verdict_on(const std::string& effect, const RealScene& scene) {
  for (const EffectVerdict& verdict : judge_effects(scene, built_plugins(), nullptr))
    if (verdict.id == effect) return verdict;
  throw std::invalid_argument(effect);
}

constexpr const char* k_coarse = "coarse: {diameter: 1 mm, density: 2500 kg/m^3, count: 1000}";
constexpr const char* k_fine = "fine: {diameter: 0.05 mm, density: 2500 kg/m^3, count: 1000}";

// The Bond number of the fine class alone: whichever class a case writes first.
TEST(Verdicts, TheClassMostInNeedDecides) {
  const EffectVerdict alone = verdict_on("cohesion", scene_of(k_fine));
  ASSERT_EQ(alone.verdict, 1);
  EXPECT_EQ(alone.because.find("fine"), std::string::npos) << alone.because;
  for (const auto& classes : {fmt::format("{}, {}", k_coarse, k_fine), fmt::format("{}, {}", k_fine, k_coarse)}) {
    const EffectVerdict verdict = verdict_on("cohesion", scene_of(classes));
    EXPECT_EQ(verdict.verdict, 1) << classes;
    EXPECT_EQ(verdict.value, alone.value);
    EXPECT_EQ(verdict.because, fmt::format("Bo = {:.2g} for fine{}", alone.value, alone.because.substr(alone.because.find(", needed above 1 ("))));
  }
}

TEST(Verdicts, OfTwoNegligibleClassesTheNearerToTheThresholdIsShown) {
  const EffectVerdict verdict = verdict_on("cohesion", scene_of(fmt::format("{}, huge: {{diameter: 4 mm, density: 2500 kg/m^3, count: 10}}", k_coarse)));
  EXPECT_EQ(verdict.verdict, 0);
  EXPECT_EQ(verdict.value, verdict_on("cohesion", scene_of(k_coarse)).value);
}

TEST(Verdicts, WhatIsTheSameForAllClassesNamesNone) {
  const EffectVerdict verdict = verdict_on("subgrid_turbulence", scene_of(fmt::format("{}, {}", k_coarse, k_fine)));
  EXPECT_EQ(verdict.because, verdict_on("subgrid_turbulence", scene_of(k_coarse)).because);
}

std::string of_temperature(const char* name, double kelvin) {
  return fmt::format("{}: {{diameter: 1 mm, density: 2500 kg/m^3, count: 100, temperature: {} K, heat_capacity: 800 J/(kg K), "
                     "conductivity: 1 W/(m K)}}",
                     name, kelvin);
}

TEST(Verdicts, HeatSeesTheTemperaturesOfAllClasses) {
  const auto heat = [](double first, double second) {
    return verdict_on("heat", scene_of(of_temperature("one", first) + ", " + of_temperature("other", second), ", temperature: 300 K"));
  };
  EXPECT_EQ(heat(300, 1200).value, 3);
  EXPECT_EQ(heat(300, 1200).verdict, 1);
  EXPECT_EQ(heat(1200, 300).verdict, 1);
  // Either class is within 5 % of the gas, but not of the other.
  EXPECT_NEAR(heat(291, 309).value, 18.0 / 291, 1e-12);
  EXPECT_EQ(heat(291, 309).verdict, 1);
}

TEST(Verdicts, AutoTakesWhatTheSecondClassNeeds) {
  RealScene scene = scene_of(of_temperature("cold", 300) + ", " + of_temperature("hot", 1200), ", temperature: 300 K");
  choose_effects(scene, built_plugins());
  ASSERT_EQ(scene.models.effects.size(), 1u);
  EXPECT_EQ(scene.models.effects[0].id, "heat");
}

// Whatever an effect does, in contacts, to particles, in cells or to what the gas carries, takes longer than a nanosecond per particle
// and gas step.
TEST(EffectPrice, CountsEveryPass) {
  const RealScene scene = scene_of("ball: {diameter: 1 mm, density: 2500 kg/m^3, count: 1000, temperature: 400 K, heat_capacity: 800 J/(kg K), "
                                   "conductivity: 1 W/(m K), oxygen_capacity: 0.08, conversion: 0}",
                                   ", temperature: 300 K, fuel: 0.3", "vans");
  const TimeSteps steps = choose_time_steps(assemble(scene, built_plugins()));
  const double least = 1e-9 * 1000 * static_cast<double>(steps.gas_steps_until(1));
  for (const char* effect : {"cohesion", "heat", "magnus_lift", "oxygen_carrier", "rolling_friction", "saffman_lift", "subgrid_turbulence", "virtual_mass"}) {
    EXPECT_GT(effect_price(scene, steps, built_plugins(), effect), least) << effect;
  }
}

// Damkoehler's number is a residence time over a reaction time: in a gas that stands still there is all the time.
TEST(Verdicts, FuelAtRestReactsWithACarrier) {
  const std::string carrier = "ball: {diameter: 1 mm, density: 2500 kg/m^3, count: 100, oxygen_capacity: 0.08, conversion: 0}";
  const EffectVerdict fuel = verdict_on("oxygen_carrier", scene_of(carrier, ", fuel: 0.3"));
  EXPECT_EQ(fuel.value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(fuel.verdict, 1);
  EXPECT_EQ(fuel.because.substr(0, 29), "Da = inf, needed above 0.1 (L");
  EXPECT_EQ(verdict_on("oxygen_carrier", scene_of(carrier, ", fuel: 0")).verdict, 0);
}

}  // namespace
}  // namespace similitude::test
