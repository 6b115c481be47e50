/// A missing partner, a conflict or a parameter that nothing gives: said before anything runs, with what to add.

#include <gtest/gtest.h>

#include <similitude/effect.h>

#include "effect_case.h"
#include "scene/messages.h"
#include "similarity/ratios.h"
#include "stepper/effects.h"

namespace similitude::test {
namespace {

struct Dependent {
  const char* partners() const { return "magnus_lift|saffman_lift vans"; }
  const char* conflicts() const { return "cohesion"; }
  Relevance relevance(const Evidence&) const { return {}; }
};

std::string complaint_of(const std::string& fluid, const std::string& others) {
  const similitude_descriptor descriptor = effect<Dependent>({.id = "dependent", .version = "1.0.0", .title = "Wants others"});
  std::vector<EffectModel> effects;
  effects.push_back(create_model<similitude_effect_functions>({.descriptor = &descriptor, .file = {}, .level = {}, .hides = {}}, similitude_bed{}, {}));
  EffectCase given{.fluid = fluid, .effects = others};
  const RealScene scene = case_of(given.yaml()).scene;
  try {
    check_partners(scene, effects);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Dependencies, AMissingPartnerIsNamedWithWhatWillDo) {
  EXPECT_EQ(complaint_of("vans", "[]"),
            "models.effects: dependent works only together with magnus_lift or saffman_lift, which this case does not use.\n"
            "  Choose magnus_lift or saffman_lift, or leave dependent out of models.effects.");
  EXPECT_EQ(complaint_of("prescribed", "[saffman_lift]"),
            "models.effects: dependent works only together with vans, which this case does not use.\n"
            "  Choose vans, or leave dependent out of models.effects.");
  EXPECT_EQ(complaint_of("vans", "[saffman_lift]"), "");
}

TEST(Dependencies, AConflictIsNamed) {
  EXPECT_EQ(complaint_of("vans", "[saffman_lift, cohesion]"),
            "models.effects: dependent and cohesion are in each other's way: both would count the same thing.\n"
            "  Leave one of the two out.");
}

std::string refusal_of(const std::string& contact, const std::string& effects) {
  EffectCase given{.contact = contact, .effects = effects};
  try {
    assemble(case_of(given.yaml()).scene, built_plugins());
  } catch (const PluginError& error) {
    return error.what();
  } catch (const InputError& error) {
    return std::string(error.what()).substr(std::string(error.what()).find("models.effects"));   // without file and place
  }
  return "";
}

constexpr const char* k_hertz = "{id: hertz_mindlin, youngs_modulus: 10 MPa, poisson_ratio: 0.25, restitution: 0.5, friction: 0.3}";
constexpr const char* k_spring = "{id: linear_spring, stiffness: 1000 N/m, restitution: 0.5, friction: 0.3}";

TEST(Dependencies, WhatTheContactLawKnowsIsTakenFromThere) {
  EXPECT_EQ(refusal_of(k_hertz, "[{id: cohesion, model: jkr, surface_energy: 0.05 J/m^2}]"), "");
  EXPECT_EQ(refusal_of(k_spring, "[{id: rolling_friction, coefficient: 0.1, model: epsd}]"), "");
  EXPECT_NE(refusal_of(k_spring, "[{id: cohesion, model: jkr, surface_energy: 0.05 J/m^2}]")
                .find("jkr replaces Hertz's force, and this contact law is not Hertz's.\n  Choose contact: hertz_mindlin or hertz_thornton"),
            std::string::npos);
  EXPECT_NE(refusal_of(k_hertz, "[{id: rolling_friction, coefficient: 0.1, model: epsd}]")
                .find("the rolling spring of epsd needs the contact's normal stiffness, and this contact law declares none.\n  Give stiffness"),
            std::string::npos);
}

// JKR takes Hertz's force away and gives its own: with another E* than the contact law's a force of neither would be left.
TEST(Dependencies, UnlikePartnersAreRefusedByEffectsOfOneMaterial) {
  const auto hertz = [](const std::string& more) {
    return "{id: hertz_mindlin, youngs_modulus: 10 MPa, poisson_ratio: 0.25, restitution: 0.5, friction: 0.3" + more + "}";
  };
  const std::string jkr = "[{id: cohesion, model: jkr, surface_energy: 0.05 J/m^2}]";
  EXPECT_EQ(refusal_of(hertz(", partner_youngs_modulus: 1 MPa"), jkr),
            "models.effects: cohesion works with one youngs_modulus, but the partners in models.contact have 1e+07 Pa and 1e+06 Pa.\n"
            "  Give all pairs and partners of models.contact the same youngs_modulus, or leave cohesion out of models.effects.");
  EXPECT_NE(refusal_of(hertz(", partner_poisson_ratio: 0.4"), jkr).find("with one poisson_ratio, but"), std::string::npos);
  EXPECT_EQ(refusal_of(hertz(", partner_youngs_modulus: 10 MPa"), jkr), "");
  EXPECT_EQ(refusal_of(hertz(", partner_youngs_modulus: 1 MPa"), "[cohesion]"), "");   // van der Waals has no E*

  const std::string pairs = "{id: linear_spring, restitution: 0.5, friction: 0.3, pair: {ball-ball: {stiffness: 1000 N/m}, "
                            "ball-wall: {stiffness: 500 N/m}}}";
  EXPECT_NE(refusal_of(pairs, "[{id: rolling_friction, coefficient: 0.1, model: epsd}]").find("with one stiffness, but"), std::string::npos);
  EXPECT_EQ(refusal_of(pairs, "[{id: rolling_friction, coefficient: 0.1}]"), "");
  EXPECT_EQ(refusal_of(pairs, "[{id: rolling_friction, coefficient: 0.1, model: epsd, stiffness: 500 N/m}]"), "");
}

struct Speechless {
  Relevance relevance(const Evidence&) const { throw std::invalid_argument("a bed without walls cannot be judged."); }
};

TEST(Dependencies, WhatAnEffectSaysInsteadOfAVerdictIsHeard) {
  const similitude_descriptor descriptor = effect<Speechless>({.id = "speechless", .version = "1.0.0", .title = "Cannot judge"});
  const Catalogue catalogue(std::vector<PluginEntry>{{.descriptor = &descriptor, .file = {}, .level = {}, .hides = {}}});
  testing::internal::CaptureStderr();
  const std::vector<EffectVerdict> verdicts = judge_effects(case_of(EffectCase{}.yaml()).scene, catalogue, nullptr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: relevance: a bed without walls cannot be judged.\n");
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_EQ(verdicts[0].verdict, -1);
}

// A quarter of the length at the same density: weights fall by 4^3, and with them what holds grains together.
TEST(ScaledEffects, KeepTheBondNumber) {
  EffectCase given{.effects = "[cohesion]"};
  const RealScene real = case_of(given.yaml()).scene;
  similitude_ratios quarter = identity_ratios();
  quarter.length = quarter.diameter = quarter.drag_diameter = 0.25;
  quarter.time = quarter.velocity = 0.5;
  const ModelScene bed = simulated_bed(real, quarter);
  const auto ratio = [&](std::size_t place) {
    return bed.models.effects[0].parameters[place].real / real.models.effects[0].parameters[place].real;
  };
  EXPECT_EQ(real.models.effects[0].parameters[1].name, "hamaker");
  EXPECT_EQ(ratio(1), 1.0 / 256);   // force times length
  EXPECT_EQ(ratio(2), 0.25);        // separation
  EXPECT_EQ(ratio(3), 0.25);        // asperity
}

TEST(ScaledEffects, WhatCannotBeScaledRefusesAScaledRun) {
  EffectCase given{.effects = "[cohesion]"};
  RealScene real = case_of(given.yaml()).scene;
  real.models.effects[0].mark = {};
  real.models.effects[0].parameters[1].scales_as = SIMILITUDE_SCALES_REFUSED;
  real.models.scaling.id = "similarity";
  EXPECT_NO_THROW(simulated_bed(real, identity_ratios()));
  similitude_ratios quarter = identity_ratios();
  quarter.length = 0.25;
  try {
    simulated_bed(real, quarter);
    FAIL() << "nothing was said";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "models.effects: cohesion does not say how its hamaker scales, and models.scaling is similarity.\n"
                               "  Set models.scaling: exact, or leave cohesion out of models.effects.");
  }
}

TEST(Dependencies, FieldsExistOnlyForTheEffectsThatWantThem) {
  const auto assembly = [](const std::string& effects) {
    EffectCase given{.contact = "{id: linear_spring, stiffness: 1000 N/m, restitution: 0.5, friction: 0}", .effects = effects};
    return assemble(case_of(given.yaml()).scene, built_plugins());
  };
  EXPECT_FALSE(store_fields(assembly("[]")).rotation);
  EXPECT_FALSE(store_fields(assembly("[]")).added_mass);
  EXPECT_TRUE(store_fields(assembly("[magnus_lift]")).rotation);
  EXPECT_FALSE(store_fields(assembly("[saffman_lift]")).rotation);
  EXPECT_TRUE(store_fields(assembly("[virtual_mass]")).added_mass);
}

}  // namespace
}  // namespace similitude::test
