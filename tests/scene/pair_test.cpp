// models.contact.pair: contact parameters by pairs of materials, and every message that it can give.
#include <gtest/gtest.h>

#include <cmath>

#include "case_text.h"
#include "scene/material_pairs.h"

namespace similitude {
namespace {

using testing::complaint;
using testing::example_with;
using testing::k_example;
using testing::read_text_case;

const std::string k_binary = R"(similitude: 1
scene:
  domain:    {size: [20 mm, 10 mm, 60 mm], cell: 2.5 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles:
    alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 1000}
    glass:   {diameter: 1.5 mm, density: 2500 kg/m^3, count: 500}
models:
  drag: gidaspow
  contact:
    id: linear_spring
    stiffness: 500 N/m
    terms: 7
    pair:
      alumina-alumina: {restitution: 0.74, friction: 0.2}
      glass-alumina:   {restitution: 0.85, friction: 0.15}
      glass-wall:      {restitution: 0.97, friction: 0.1, stiffness: 800 N/m}
      glass-glass:     {restitution: 0.97}
      alumina-wall:    {restitution: 0.74, friction: 0.2, tangential: slip}
  fluid: vans
time: {end: 1 s}
)";

std::string binary_with(const std::string& old_text, const std::string& new_text) {
  std::string text = k_binary;
  const std::size_t at = text.find(old_text);
  return at == std::string::npos ? "there is no: " + old_text : text.replace(at, old_text.size(), new_text);
}

std::string without_pair(const std::string& key) {
  const std::size_t begin = k_binary.find("      " + key), end = k_binary.find('\n', begin);
  return k_binary.substr(0, begin) + k_binary.substr(end + 1);
}

const ModelChoice& set_of(const RealScene& scene, std::size_t one, std::size_t other) {
  return scene.models.contact_pairs.at(pair_place(scene.particles.size(), one, other));
}

const ModelParameter& parameter(const ModelChoice& choice, const std::string& name) {
  for (const ModelParameter& one : choice.parameters)
    if (one.name == name) return one;
  throw std::out_of_range(name);
}

TEST(Pairs, WinOverWhatIsCommonInEitherOrderOfTheMaterials) {
  const RealScene scene = read_text_case(k_binary).scene;
  ASSERT_EQ(scene.models.contact_pairs.size(), 5u);
  const std::size_t alumina = 0, glass = 1, wall = 2;
  EXPECT_EQ(parameter(set_of(scene, alumina, alumina), "restitution").real, 0.74);
  EXPECT_EQ(parameter(set_of(scene, alumina, glass), "restitution").real, 0.85);
  EXPECT_EQ(parameter(set_of(scene, glass, alumina), "friction").real, 0.15);
  EXPECT_EQ(parameter(set_of(scene, alumina, glass), "stiffness").real, 500);
  EXPECT_EQ(parameter(set_of(scene, glass, wall), "stiffness").real, 800);
  EXPECT_EQ(parameter(set_of(scene, glass, glass), "friction").real, 0);   // the default
  EXPECT_EQ(parameter(set_of(scene, alumina, wall), "tangential").text, "slip");
  EXPECT_EQ(parameter(set_of(scene, glass, wall), "tangential").text, "history");
  EXPECT_EQ(parameter(set_of(scene, glass, wall), "terms").real, 7);
  EXPECT_EQ(contact_sets(scene.models).size(), 5u);
}

TEST(Pairs, AreOneSetForAllWhereTheyAreLeftOut) {
  const RealScene scene = read_text_case(k_example).scene;
  EXPECT_TRUE(scene.models.contact_pairs.empty());
  ASSERT_EQ(contact_sets(scene.models).size(), 1u);
  EXPECT_EQ(contact_sets(scene.models)[0].parameters[0].real, 500);
  EXPECT_TRUE(read_text_case(k_example, {"models.contact.pair="}).scene.models.contact_pairs.empty());
}

TEST(Pairs, OfOneClassGiveTheWallItsOwnFriction) {
  const RealScene scene =
      read_text_case(example_with("friction: 0.2}", "friction: 0.2, pair: {alumina-alumina: , wall-alumina: {friction: 0.4}}}")).scene;
  ASSERT_EQ(scene.models.contact_pairs.size(), 2u);
  EXPECT_EQ(parameter(set_of(scene, 0, 0), "friction").real, 0.2);
  EXPECT_EQ(parameter(set_of(scene, 0, 1), "friction").real, 0.4);
}

TEST(Pairs, FollowTheCommandLine) {
  const RealScene scene = read_text_case(k_binary, {"models.contact.pair.alumina-wall.friction=0.3"}).scene;
  EXPECT_EQ(parameter(set_of(scene, 0, 2), "friction").real, 0.3);
  EXPECT_EQ(parameter(set_of(scene, 0, 2), "restitution").real, 0.74);
}

TEST(Pairs, MatchNamesThatHoldHyphens) {
  std::string text = k_binary;
  for (std::size_t at = text.find("glass"); at != std::string::npos; at = text.find("glass", at + 8)) text.replace(at, 5, "soda-lime");
  const RealScene scene = read_text_case(text).scene;
  EXPECT_EQ(parameter(set_of(scene, 0, 1), "restitution").real, 0.85);
  EXPECT_EQ(parameter(set_of(scene, 1, 2), "stiffness").real, 800);
}

TEST(Pairs, ReadTheSameFromTheResolvedCase) {
  const CaseFile first = read_text_case(k_binary), again = read_text_case(first.resolved);
  EXPECT_EQ(again.resolved, first.resolved);
  ASSERT_EQ(again.scene.models.contact_pairs.size(), 5u);
  for (std::size_t p = 0; p < 5; ++p) {
    const ModelChoice &a = first.scene.models.contact_pairs[p], &b = again.scene.models.contact_pairs[p];
    ASSERT_EQ(a.parameters.size(), b.parameters.size());
    for (std::size_t k = 0; k < a.parameters.size(); ++k) {
      const ModelParameter &one = a.parameters[k], &other = b.parameters[k];
      EXPECT_TRUE(one.real == other.real || (std::isnan(one.real) && std::isnan(other.real))) << one.name;
      EXPECT_EQ(one.text, other.text);
    }
  }
}

// What is common is written once, so that the command line reaches it in a resolved case as in the first.
TEST(Pairs, OfAResolvedCaseFollowTheCommonParameters) {
  const std::string resolved = read_text_case(k_binary).resolved;
  const RealScene scene = read_text_case(resolved, {"models.contact.stiffness=600 N/m"}).scene;
  EXPECT_EQ(parameter(set_of(scene, 0, 1), "stiffness").real, 600);
  EXPECT_EQ(parameter(set_of(scene, 1, 2), "stiffness").real, 800);
}

TEST(Pairs, WarnOfWhatIsUnusual) {
  const auto warnings = read_text_case(k_binary, {"models.contact.pair.glass-wall.stiffness=5 N/m"}).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "--set: models.contact.pair.glass-wall.stiffness: 5 N/m is unusual: stiffness of linear_spring is mostly from 10 "
            "N/m to 1e+06 N/m.");
}

TEST(PairErrors, NameThePairsThatAreMissing) {
  EXPECT_EQ(complaint(without_pair("glass-alumina")),
            "spout.yaml:15:7: models.contact.pair: alumina-glass is missing: 2 classes of particles make 5 pairs with the "
            "walls.\n"
            "  Add for example alumina-glass: {restitution: 0.74, friction: 0.2}.");
  EXPECT_EQ(complaint(k_binary, {"models.contact.pair={glass-wall: }"}),
            "--set: models.contact.pair: alumina-alumina, alumina-glass, glass-glass, alumina-wall are missing: 2 classes of "
            "particles make 5 pairs with the walls.\n"
            "  Add for example alumina-alumina: {restitution: 1}.");
  EXPECT_EQ(complaint(example_with("friction: 0.2}", "friction: 0.2, pair: {alumina-wall: {friction: 0.4}}}")),
            "spout.yaml:15:92: models.contact.pair: alumina-alumina is missing: 1 class of particles makes 2 pairs with the "
            "walls.\n"
            "  Add for example alumina-alumina: {friction: 0.4}.");
}

TEST(PairErrors, NameTheNearestMaterial) {
  const std::string list = "  Materials: alumina, glass, wall. A pair is two of them joined by a hyphen.";
  EXPECT_EQ(complaint(binary_with("glass-alumina:", "glass-alumna:")),
            "spout.yaml:16:7: models.contact.pair.glass-alumna: there is no material alumna.\n"
            "  Did you mean \"alumina\"?\n" + list);
  EXPECT_EQ(complaint(binary_with("glass-alumina:", "glas-alumina:")),
            "spout.yaml:16:7: models.contact.pair.glas-alumina: there is no material glas.\n"
            "  Did you mean \"glass\"?\n" + list);
  EXPECT_EQ(complaint(binary_with("glass-alumina:", "glas-alumna:")),
            "spout.yaml:16:7: models.contact.pair.glas-alumna: this is no pair of materials.\n"
            "  Did you mean \"glass-alumina\"?\n" + list);
  EXPECT_EQ(complaint(binary_with("glass-alumina:", "steel:")),
            "spout.yaml:16:7: models.contact.pair.steel: this is no pair of materials.\n" + list);
  EXPECT_EQ(complaint(binary_with("glass-alumina:", "wall-wall:")),
            "spout.yaml:16:7: models.contact.pair.wall-wall: walls do not move, so no two of them meet.\n  Remove this key.");
}

TEST(PairErrors, RefuseAPairThatIsGivenTwice) {
  EXPECT_EQ(complaint(binary_with("glass-glass:", "alumina-glass:")),
            "spout.yaml:18:7: models.contact.pair.alumina-glass: this pair was given before, as glass-alumina in line 16.\n"
            "  Keep one of the two.");
  EXPECT_EQ(complaint(binary_with("glass-glass:", "glass-alumina:")),
            "spout.yaml:18:7: models.contact.pair.glass-alumina: this key was given before, in line 16.\n"
            "  Keep one of the two.");
  EXPECT_EQ(complaint(k_binary, {"models.contact.pair.alumina-glass.friction=0.3"}),
            "--set: models.contact.pair.alumina-glass: this pair was given before, as glass-alumina in line 16.\n"
            "  Keep one of the two.");
}

TEST(PairErrors, AreThoseOfParametersElsewhere) {
  EXPECT_EQ(complaint(binary_with("0.85, friction", "0.85, fricton")),
            "spout.yaml:16:44: models.contact.pair.glass-alumina.fricton: linear_spring has no such parameter.\n"
            "  Did you mean \"friction\"?\n"
            "  Parameters of linear_spring: stiffness, restitution, friction, glide_speed, youngs_modulus, film, "
            "cut_off, relaxation, attraction, tangential, terms.");
  EXPECT_EQ(complaint(binary_with("restitution: 0.85", "restitution: 1.4")),
            "spout.yaml:16:38: models.contact.pair.glass-alumina.restitution: 1.4 is out of range: linear_spring takes "
            "restitution from 0.01 to 1.\n"
            "  restitution: normal restitution.");
  EXPECT_EQ(complaint(binary_with("800 N/m", "800")),
            "spout.yaml:17:70: models.contact.pair.glass-wall.stiffness: 800 has no unit; a stiffness (force per length) is "
            "needed.\n  Write for example 800 N/m.");
  EXPECT_TRUE(complaint(binary_with("{restitution: 0.97}", "{restitution: 0.97, id: linear_spring}"))
                  .starts_with("spout.yaml:18:44: models.contact.pair.glass-glass.id: linear_spring has no such parameter.\n"));
}

TEST(PairErrors, NameThePairThatLacksAParameter) {
  EXPECT_EQ(complaint(binary_with("{restitution: 0.97}", "{friction: 0.1}")),
            "spout.yaml:18:24: models.contact.pair.glass-glass: linear_spring needs the parameter restitution (normal "
            "restitution), and it is neither here nor common to all pairs.\n"
            "  Add for example restitution: 1, here or beside pair.");
  EXPECT_EQ(complaint(binary_with("glass-glass:     {restitution: 0.97}", "glass-glass:")),
            "spout.yaml:18:7: models.contact.pair.glass-glass: linear_spring needs the parameter restitution (normal "
            "restitution), and it is neither here nor common to all pairs.\n"
            "  Add for example restitution: 1, here or beside pair.");
}

TEST(PairErrors, WantMaps) {
  EXPECT_EQ(complaint(k_binary, {"models.contact.pair=0.3"}),
            "--set: models.contact.pair: a map of pairs is needed, but this is \"0.3\".\n"
            "  Write for example pair: {alumina-alumina: {restitution: 1}}.");
  EXPECT_EQ(complaint(k_binary, {"models.contact.pair.glass-glass=0.3"}),
            "--set: models.contact.pair.glass-glass: a map of parameters is needed, but this is \"0.3\".\n"
            "  Write for example glass-glass: {restitution: 0.74, friction: 0.2}.");
}

TEST(PairErrors, RefuseNamesThatCannotBeToldApart) {
  EXPECT_EQ(complaint(binary_with("    glass:  ", "    wall:  ")),
            "spout.yaml:7:13: scene.particles.wall: in models.contact.pair wall means every wall, baffle and inlet, not a "
            "class.\n"
            "  Give this class another name.");
  EXPECT_EQ(complaint(binary_with("    glass:  ",
                                  "    a: {diameter: 1 mm, density: 1 kg/m^3, count: 1}\n"
                                  "    b-c: {diameter: 1 mm, density: 1 kg/m^3, count: 1}\n"
                                  "    a-b: {diameter: 1 mm, density: 1 kg/m^3, count: 1}\n"
                                  "    c: {diameter: 1 mm, density: 1 kg/m^3, count: 1}\n"
                                  "    glass:  ")),
            "spout.yaml:10:8: scene.particles.c: in models.contact.pair the name a-b-c could mean two different pairs of "
            "materials.\n"
            "  Give this class another name.");
  // Without `pair` any name will do.
  EXPECT_EQ(complaint(example_with("{alumina:", "{wall:")), "");
}

TEST(PairErrors, RefuseOneSimulatedStiffnessForPairsThatDiffer) {
  EXPECT_EQ(complaint(k_binary, {"models.scaling.stiffness=50 N/m", "models.scaling.id=exact"}),
            "--set: models.scaling.stiffness: it would replace the stiffness of every contact, but models.contact.pair gives "
            "pairs of materials different ones.\n"
            "  Remove this key, or give all pairs one stiffness.");
  EXPECT_EQ(complaint(k_binary, {"models.scaling.stiffness=50 N/m", "models.scaling.id=exact",
                                 "models.contact.pair.glass-wall.stiffness=500 N/m"}),
            "");
}

TEST(PairErrors, OtherModelsHaveNoPairs) {
  EXPECT_TRUE(complaint(k_binary, {"models.drag.pair={}"}).starts_with("--set: models.drag.pair: gidaspow has no such parameter.\n"));
}

}  // namespace
}  // namespace similitude
