/// Which effects a scene calls for, where one class of particles or one number of the scene decides.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "effect_case.h"
#include "stepper/effect_price.h"
#include "stepper/effects.h"
#include "stepper/occurred.h"

namespace similitude::test {
namespace {

/// A scene at rest, with these classes of particles and these keys of the gas.
RealScene scene_of(const std::string& classes, const std::string& gas = "", const std::string& fluid = "prescribed",
                   const std::string& patches = "{}") {
  return case_of(fmt::format(R"(
similitude: 1
title: classes
scene:
  domain:    {{size: [20 mm, 20 mm, 60 mm], cell: 5 mm}}
  gas:       {{density: 1.2 kg/m^3, viscosity: 1.8e-5 Pa s{}}}
  particles: {{{}}}
  bed:       {{fill: lattice}}
  patches:   {}
models: {{drag: schiller_naumann, fluid: {}, scaling: exact, effects: auto,
         contact: {{id: linear_spring, stiffness: 1000 N/m, restitution: 0.5, friction: 0.3}}}}
time: {{end: 1 s, dt: auto}}
)",
                             gas, classes, patches, fluid)).scene;
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

std::vector<std::string> idle_warnings(RealScene scene) {
  choose_effects(scene, built_plugins());
  return idle_value_warnings(scene, built_plugins());
}

// 310 K over 300 K is 0.033: less than heat asks for.
TEST(IdleValues, TemperaturesThatAutoLeavesOutAreWarnedOfOnceWithTheVerdict) {
  const std::vector<std::string> warnings = idle_warnings(scene_of(of_temperature("ball", 300), ", temperature: 310 K"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("scene.gas.temperature: heat is not part of this run, so this and 3 more of its values do nothing: "
                             "(T_max - T_min)/T_min = 0.033, needed above 0.05 ("),
            std::string::npos)
      << warnings[0];
  EXPECT_TRUE(warnings[0].ends_with("\n  Write models.effects: [heat] to have it, or remove these keys.")) << warnings[0];
}

TEST(IdleValues, TheListToWriteKeepsWhatTheBedCallsFor) {
  const std::vector<std::string> warnings = idle_warnings(scene_of(k_fine, ", temperature: 300 K"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find(": heat is not part of this run, so this value does nothing: "), std::string::npos) << warnings[0];
  EXPECT_TRUE(warnings[0].ends_with("\n  Write models.effects: [cohesion, heat] to have it, or remove this key.")) << warnings[0];
}

// The law that auto takes burns a fuel: oxygen alone is no reason for it.
TEST(IdleValues, OxygenWithoutFuelIsLeftOutAndWarnedOf) {
  const RealScene scene = scene_of("ball: {diameter: 1 mm, density: 2500 kg/m^3, count: 100, oxygen_capacity: 0.08, conversion: 1}", ", oxygen: 0.21");
  EXPECT_EQ(verdict_on("oxygen_carrier", scene).verdict, -1);
  const std::vector<std::string> warnings = idle_warnings(scene);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("; give scene.gas.fuel, or list the effect with gas: O2, to tell.\n"), std::string::npos) << warnings[0];
}

TEST(IdleValues, ValuesInUseAreNotWarnedOf) {
  EXPECT_TRUE(idle_warnings(scene_of(of_temperature("ball", 1200), ", temperature: 300 K")).empty());
}

TEST(Defaults, StandAsACaseWouldWriteThem) {
  EXPECT_EQ(with_its_defaults(*built_plugins().find("effect", "cohesion")->descriptor),
            "{id: cohesion, model: van_der_waals, hamaker: 6.5e-20 J, separation: 4e-10 m, asperity: 1e-07 m}");
}

// A list in place of auto loses what it does not name; in a list the others stand already.
TEST(SecondThoughts, AdviceOnAutoNamesTheWholeList) {
  Models models;
  models.effects.push_back({.kind = "effect", .id = "heat", .parameters = {}, .mark = {}});
  EffectVerdict heat{.id = "heat", .group = {}, .source = {}, .because = "dT = 0.01", .species = {}, .value = 0.3, .verdict = 0, .chosen = true};
  EffectVerdict lift{.id = "lift", .group = {}, .source = {}, .because = "L = 0.2", .species = {}, .value = 0.01, .verdict = 1};
  const std::vector<EffectVerdict> seen{heat, lift};
  std::vector<EffectVerdict> before = seen;
  EXPECT_EQ(second_thoughts(models, before, seen).size(), 1u);   // called for from the start: the solver could not use the lift
  before[1].verdict = 0;
  EXPECT_EQ(second_thoughts(models, before, seen),
            (std::vector<std::string>{"heat was in the run, but what occurred does not call for it: dT = 0.01. Before the run: 0.3. It may be left "
                                      "out: models.effects: [].",
                                      "lift was left out, but what occurred calls for it: L = 0.2. Before the run: 0.01. Write "
                                      "models.effects: [heat, lift]."}));
  models.effects_auto = false;
  const std::vector<std::string> listed = second_thoughts(models, before, seen);
  EXPECT_TRUE(listed[0].ends_with("It may be left out of models.effects."));
  EXPECT_TRUE(listed[1].ends_with("Add lift to models.effects."));
}

// A jet of Re = 1.3e4 calls for turbulence, but flow through a packing has no viscosity to add it to.
TEST(Verdicts, AutoLeavesOutAllOfWhatTheSolverCannotUse) {
  const Assembly assembly =
      assemble(scene_of(k_coarse, "", "porous", "{jet: {face: bottom, x: [5 mm, 15 mm], velocity: 20 m/s}, top: {face: top, pressure: 0 Pa}}"),
               built_plugins());
  constexpr const char* k_left_out = "subgrid_turbulence";
  EXPECT_THAT(assembly.warnings, testing::Contains("models.effects: this bed calls for subgrid_turbulence, but porous has no viscosity that it "
                                                   "could add to."));
  for (const EffectModel& effect : assembly.effects) EXPECT_STRNE(effect.descriptor().id, k_left_out);
  for (const Models* models : {&assembly.real.models, &assembly.model.models}) {
    for (const ModelChoice& effect : models->effects) EXPECT_NE(effect.id, k_left_out);
  }
  for (const PluginEntry& plugin : assembly.plugins) EXPECT_STRNE(plugin.descriptor->id, k_left_out);
}

/// How often the passes of a plugin's effect were called.
struct Calls {
  std::atomic<int> particles, contacts, cells, exchange, take;
};
Calls calls;
similitude_effect_functions counted;   // whose passes are called on

/// The plugins of the build with one effect whose passes are counted on the way.
class Counted {
 public:
  explicit Counted(const std::string& effect) {
    calls.particles = calls.contacts = calls.cells = calls.exchange = calls.take = 0;
    std::vector<PluginEntry> plugins = built_plugins().plugins();
    for (PluginEntry& plugin : plugins) {
      if (plugin.descriptor->kind != std::string("effect") || plugin.descriptor->id != effect) continue;
      counted = as_known_here(static_cast<const similitude_effect_functions*>(plugin.descriptor->functions));
      put_between();
      descriptor_ = *plugin.descriptor;
      descriptor_.functions = &between_;
      plugin.descriptor = &descriptor_;
    }
    plugins_ = std::make_unique<Catalogue>(std::move(plugins));
  }
  const Catalogue& plugins() const { return *plugins_; }

 private:
  void put_between() {
    between_ = counted;
    if (counted.particles) between_.particles = [](const void* m, const similitude_particle_block* b, similitude_status* s) { ++calls.particles, counted.particles(m, b, s); };
    if (counted.contacts) between_.contacts = [](const void* m, const similitude_contact_effect_block* b, similitude_status* s) { ++calls.contacts, counted.contacts(m, b, s); };
    if (counted.cells) between_.cells = [](const void* m, const similitude_cell_block* b, similitude_status* s) { ++calls.cells, counted.cells(m, b, s); };
    if (counted.exchange) between_.exchange = [](const void* m, const similitude_scalar_block* b, similitude_status* s) { ++calls.exchange, counted.exchange(m, b, s); };
    if (counted.take) between_.take = [](const void* m, const similitude_scalar_block* b, similitude_status* s) { ++calls.take, counted.take(m, b, s); };
  }

  similitude_effect_functions between_{};
  similitude_descriptor descriptor_{};
  std::unique_ptr<Catalogue> plugins_;
};

// How long they take is for tests/performance: here the clock may stand still or jump.
TEST(EffectPrice, CountsEveryPass) {
  const RealScene scene = scene_of("ball: {diameter: 1 mm, density: 2500 kg/m^3, count: 1000, temperature: 400 K, heat_capacity: 800 J/(kg K), "
                                   "conductivity: 1 W/(m K), oxygen_capacity: 0.08, conversion: 0}",
                                   ", temperature: 300 K, fuel: 0.3", "vans");
  const TimeSteps steps = choose_time_steps(assemble(scene, built_plugins()));
  for (const std::string effect : {"cohesion", "heat", "magnus_lift", "oxygen_carrier", "rolling_friction", "saffman_lift", "subgrid_turbulence", "virtual_mass"}) {
    const Counted through(effect);
    EXPECT_GE(effect_price(scene, steps, through.plugins(), effect), 0) << effect;
    EXPECT_EQ(calls.particles > 0, counted.particles != nullptr) << effect;
    EXPECT_EQ(calls.contacts > 0, counted.contacts != nullptr) << effect;
    EXPECT_EQ(calls.cells > 0, counted.cells != nullptr) << effect;
    EXPECT_EQ(calls.exchange > 0, counted.exchange != nullptr) << effect;
    EXPECT_EQ(calls.take > 0, counted.take != nullptr) << effect;
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
