/// A missing partner, a conflict or a parameter that nothing gives: said before anything runs, with what to add.

#include <gtest/gtest.h>

#include <similitude/effect.h>

#include "effect_case.h"
#include "scene/messages.h"
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
