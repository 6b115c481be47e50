#include <gtest/gtest.h>

#include <cmath>

#include "case_text.h"

namespace similitude {
namespace {

using testing::CaseFolder;
using testing::example_with;
using testing::fake_catalogue;
using testing::k_example;
using testing::read_text_case;

double parameter(const ModelChoice& model, const std::string& name) {
  for (const ModelParameter& one : model.parameters)
    if (one.name == name) return one.real;
  ADD_FAILURE() << "no parameter " << name;
  return 0;
}

TEST(CaseFile, ReadsTheExampleAsPrinted) {
  const CaseFile read = read_text_case(k_example);
  const RealScene& bed = read.scene;
  EXPECT_EQ(bed.title, "Spouted bed with draft plates, gamma-alumina");
  EXPECT_EQ(bed.name, "spout");
  EXPECT_EQ(bed.size, (std::array{0.15, 0.02, 1.0}));
  EXPECT_EQ(bed.cell, (std::array{0.005, 0.005, 0.005}));
  EXPECT_EQ(bed.gas_density, 1.225);
  EXPECT_EQ(bed.gas_viscosity, 1.79e-5);
  ASSERT_EQ(bed.particles.size(), 1u);
  EXPECT_EQ(bed.particles[0].name, "alumina");
  EXPECT_EQ(bed.particles[0].diameter, 1e-3);
  EXPECT_EQ(bed.particles[0].drag_diameter, 1e-3);
  EXPECT_EQ(bed.particles[0].material_diameter, 1e-3);
  EXPECT_EQ(bed.particles[0].density, 1040);
  EXPECT_EQ(bed.particles[0].weight, 1);
  EXPECT_EQ(bed.particles[0].count, 461000);
  EXPECT_EQ(bed.bed.kind, FillKind::settle);
  EXPECT_TRUE(read.warnings.empty());

  EXPECT_EQ(bed.models.drag.id, "syamlal_obrien");
  EXPECT_EQ(parameter(bed.models.drag, "c1"), 0.8);
  EXPECT_EQ(parameter(bed.models.contact, "stiffness"), 500);
  EXPECT_EQ(parameter(bed.models.contact, "restitution"), 0.74);
  EXPECT_EQ(bed.models.fluid.id, "vans");
  EXPECT_EQ(bed.models.scaling.id, "terminal_velocity");
  EXPECT_EQ(parameter(bed.models.scaling, "geometry"), 0.25);
  EXPECT_TRUE(bed.models.effects_auto);
  EXPECT_EQ(bed.time.end, 5);
  EXPECT_FALSE(bed.time.dt);
  EXPECT_EQ(bed.output.vtk_every, 0.05);
  EXPECT_EQ(bed.output.profiles.z, (std::vector{0.1, 0.3}));
  EXPECT_EQ(bed.output.profiles.from, 1);
}

TEST(CaseFile, PatchesLieOnTheirFaces) {
  const RealScene bed = read_text_case(k_example).scene;
  ASSERT_EQ(bed.patches.size(), 3u);
  const Patch& spout = bed.patches[0];
  EXPECT_EQ(spout.name, "spout");
  EXPECT_EQ(face_name(spout.face), "bottom");
  EXPECT_EQ(spout.extent[0].low, 0.07);
  EXPECT_EQ(spout.extent[0].high, 0.08);
  EXPECT_EQ(spout.extent[1].low, 0);  // left out: the whole depth
  EXPECT_EQ(spout.extent[1].high, 0.02);
  EXPECT_EQ(spout.extent[2].high, 0);
  EXPECT_EQ(spout.velocity, 13.2);
  EXPECT_EQ(spout.ramp, 0.05);  // by default
  EXPECT_EQ(spout.mark.line, 9);
  EXPECT_EQ(spout.mark.column, 17);
  EXPECT_EQ(spout.extent_mark[0].column, 35);
  EXPECT_EQ(spout.extent_mark[1].column, 17);
  EXPECT_TRUE(bed.patches[1].rest);
  EXPECT_EQ(bed.patches[2].kind, PatchKind::pressure);
  EXPECT_EQ(bed.patches[2].extent[2].low, 1.0);
}

TEST(CaseFile, AListOfPlatePositionsMakesNumberedPlates) {
  const RealScene bed = read_text_case(k_example).scene;
  ASSERT_EQ(bed.baffles.size(), 2u);
  EXPECT_EQ(bed.baffles[0].name, "plates.0");
  EXPECT_EQ(bed.baffles[1].name, "plates.1");
  EXPECT_EQ(bed.baffles[1].position, 0.09);
  EXPECT_EQ(bed.baffles[1].extent[0].low, 0.09);
  EXPECT_EQ(bed.baffles[1].extent[1].high, 0.02);
  EXPECT_EQ(bed.baffles[1].extent[2].low, 0.03);
  EXPECT_EQ(bed.baffles[1].thickness, 0.002);
}

TEST(CaseFile, ASinglePlateKeepsItsName) {
  const RealScene bed =
      read_text_case(example_with("at_x: [60 mm, 90 mm], z: [30 mm, 250 mm], thickness: 2 mm", "at_z: 60 mm")).scene;
  ASSERT_EQ(bed.baffles.size(), 1u);
  EXPECT_EQ(bed.baffles[0].name, "plates");
  EXPECT_EQ(bed.baffles[0].normal, Axis::z);
  EXPECT_EQ(bed.baffles[0].extent[0].high, 0.15);
  EXPECT_EQ(bed.baffles[0].thickness, 0.002);
}

TEST(CaseFile, WhatIsLeftOutHasSensibleValues) {
  const RealScene bed =
      read_text_case(example_with("output: {vtk: every 50 ms, profiles: {z: [100 mm, 300 mm], from: 1 s}}\n", ""))
          .scene;
  EXPECT_EQ(bed.gravity, (std::array{0.0, 0.0, -9.81}));
  EXPECT_EQ(bed.periodic, (std::array{false, false, false}));
  EXPECT_EQ(bed.walls[2][1], WallKind::no_slip);
  EXPECT_FALSE(bed.smoothing_length);
  EXPECT_EQ(bed.output.vtk_every, 0.05);
  EXPECT_EQ(bed.output.monitor_every, 0.01);
  EXPECT_TRUE(bed.output.profiles.z.empty());
  EXPECT_EQ(bed.bed.seed, 1u);
  EXPECT_TRUE(bed.bed.cache);
}

TEST(CaseFile, ReadsEveryOtherKey) {
  const RealScene bed = read_text_case(R"(
similitude: 1
scene:
  domain: {size: [40 mm, 40 mm, 80 mm], cell: [5 mm, 10 mm, 4 mm]}
  gas: {density: 1.2 kg/m^3, viscosity: 18 uPa*s}
  particles:
    small: {diameter: 1 mm, density: 2500 kg/m^3, count: 100}
    large: {diameter: 2 mm, density: 2500 kg/m^3, count: 50}
  bed: {fill: lattice, seed: 7, cache: false}
  patches:
    in: {face: left, y: [10 mm, 20 mm], z: [8 mm, 16 mm], velocity: 1 m/s, ramp: 0 s}
    out: {face: right, pressure: 10 Pa}
  walls: {bottom: slip, top: no_slip}
  periodic: [y]
  gravity: [0 m/s^2, 1 m/s^2, -9.8 m/s^2]
models:
  drag: {id: syamlal_obrien, c1: 0.7, d1: 3.5}
  contact: {id: linear_spring, stiffness: 0.5 kN/m, restitution: 90 %, attraction: true, tangential: slip, terms: 5, youngs_modulus: 70 GPa}
  fluid: vans
  effects: [magnus, {id: saffman}]
coupling: {smoothing: 8 mm}
time: {end: 100 ms, dt: 1e-6 s, gas_dt: 20 us}
output: {vtk: none, monitors: every 1 ms, profiles: {z: 20 mm}, probes: {tap: {at: [5 mm, 1 cm, 8 mm]}}}
)")
                            .scene;
  EXPECT_EQ(bed.title, "spout");
  EXPECT_EQ(bed.cell, (std::array{0.005, 0.01, 0.004}));
  EXPECT_EQ(bed.gas_viscosity, 1.8e-5);
  ASSERT_EQ(bed.particles.size(), 2u);
  EXPECT_EQ(bed.particles[1].name, "large");
  EXPECT_EQ(bed.bed.kind, FillKind::lattice);
  EXPECT_EQ(bed.bed.seed, 7u);
  EXPECT_FALSE(bed.bed.cache);
  EXPECT_EQ(bed.patches[0].face, (Face{Axis::x, Side::low}));
  EXPECT_EQ(bed.patches[0].extent[1].low, 0.01);
  EXPECT_EQ(bed.patches[0].extent[2].high, 0.016);
  EXPECT_EQ(bed.patches[0].ramp, 0);
  EXPECT_EQ(bed.patches[1].extent[0].low, 0.04);
  EXPECT_EQ(bed.patches[1].pressure, 10);
  EXPECT_EQ(bed.walls[2][0], WallKind::slip);
  EXPECT_EQ(bed.periodic, (std::array{false, true, false}));
  EXPECT_EQ(bed.gravity, (std::array{0.0, 1.0, -9.8}));
  EXPECT_EQ(bed.models.scaling.id, "exact");
  EXPECT_FALSE(bed.models.effects_auto);
  ASSERT_EQ(bed.models.effects.size(), 2u);
  EXPECT_EQ(bed.models.effects[1].id, "saffman");
  const ModelChoice& contact = bed.models.contact;
  EXPECT_EQ(parameter(contact, "stiffness"), 500);
  EXPECT_EQ(parameter(contact, "restitution"), 0.9);
  EXPECT_EQ(parameter(contact, "attraction"), 1);
  EXPECT_EQ(parameter(contact, "terms"), 5);
  EXPECT_EQ(parameter(contact, "youngs_modulus"), 70e9);
  EXPECT_EQ(contact.parameters[9].text, "slip");
  EXPECT_TRUE(contact.parameters[9].given);
  EXPECT_FALSE(contact.parameters[2].given);
  EXPECT_EQ(bed.smoothing_length, 0.008);
  EXPECT_EQ(bed.time.dt, 1e-6);
  EXPECT_EQ(bed.time.gas_dt, 20e-6);
  EXPECT_EQ(bed.output.vtk_every, 0);
  EXPECT_EQ(bed.output.monitor_every, 0.001);
  EXPECT_EQ(bed.output.profiles.z, (std::vector{0.02}));
  EXPECT_EQ(bed.output.profiles.from, 0);
  ASSERT_EQ(bed.output.probes.size(), 1u);
  EXPECT_EQ(bed.output.probes[0].name, "tap");
  EXPECT_EQ(bed.output.probes[0].place, (std::array{0.005, 0.01, 0.008}));
}

TEST(CaseFile, ParametersStandInTheOrderOfThePluginsTable) {
  const ModelChoice contact = read_text_case(k_example).scene.models.contact;
  ASSERT_EQ(contact.parameters.size(), 11u);
  EXPECT_EQ(contact.parameters[0].name, "stiffness");
  EXPECT_EQ(contact.parameters[0].scales_as, SIMILITUDE_SCALES_AS_STIFFNESS);
  EXPECT_TRUE(std::isnan(contact.parameters[4].real));  // no default: not given
  EXPECT_EQ(contact.parameters[9].text, "history");
}

TEST(CaseFile, AHeightMayStandForACount) {
  const RealScene bed =
      read_text_case(example_with(", count: 461000}}\n  bed:       {fill: settle}", "}}\n  bed: {height: 140 mm}"))
          .scene;
  EXPECT_EQ(bed.bed.height, 0.14);
  EXPECT_FALSE(bed.particles[0].count);
}

TEST(CaseFile, ABedIsReadFromAFileNextToTheCase) {
  const CaseFolder folder;
  const auto grains = folder.write("bed.csv", "x,y,z\n");
  const auto file = folder.write("spout.yaml", example_with(", count: 461000}}\n  bed:       {fill: settle}",
                                                            "}}\n  bed: {fill: file, file: bed.csv}"));
  EXPECT_EQ(read_case(file, fake_catalogue()).scene.bed.file, grains.string());
}

TEST(CaseFile, AScalingLawsOwnStiffnessIsNotTheSimulatedSprings) {
  static const similitude_parameter ratio[] = {testing::real("stiffness", "1", "ratio of springs", 1, 0, testing::k_open)};
  std::vector<PluginEntry> plugins = testing::fake_catalogue().plugins();
  plugins.push_back(testing::model("scaling", "by_hand", ratio));
  const CaseFolder folder;
  const std::string text = example_with("{id: terminal_velocity, geometry: 0.25}", "{id: by_hand, stiffness: 0.3}");
  const RealScene bed = read_case(folder.write("spout.yaml", text), Catalogue(plugins)).scene;
  EXPECT_EQ(bed.models.scaling.parameters.front().real, 0.3);
  EXPECT_FALSE(bed.models.simulated_stiffness.has_value());
}

TEST(CaseFile, ASimulatedStiffnessIsTheFrameworksOwnKey) {
  const RealScene bed = read_text_case(k_example, {"models.scaling.stiffness=60 N/m"}).scene;
  EXPECT_EQ(bed.models.simulated_stiffness, 60);
  EXPECT_EQ(bed.models.scaling.parameters.size(), 1u);
}

TEST(CaseFile, WhatIsUnusualIsAWarningWithItsPlace) {
  const auto warnings = read_text_case(k_example, {"models.contact.stiffness=5 N/m"}).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "--set: models.contact.stiffness: 5 N/m is unusual: stiffness of linear_spring is mostly from 10 N/m to "
            "1e+06 N/m.");
}

TEST(CaseFile, ATightFitIsAWarning) {
  const auto warnings = read_text_case(k_example, {"scene.particles.alumina.count=3000000"}).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(
      warnings[0],
      "--set: scene.particles.alumina.count: these particles may make a bed higher than the domain of 1000 mm: "
      "818.123 mm to 1047.2 mm (solids fraction 0.64 to 0.5).");
}

TEST(Set, ReplacesAddsAndReachesIntoLists) {
  const RealScene bed =
      read_text_case(k_example, {"models.scaling.geometry=0.5", "time.dt=1 us", "scene.domain.size.2=1.2 m",
                                 "output.profiles={z: [50 mm]}", "models.effects=[]", "coupling.smoothing=9 mm"})
          .scene;
  EXPECT_EQ(parameter(bed.models.scaling, "geometry"), 0.5);
  EXPECT_EQ(bed.time.dt, 1e-6);
  EXPECT_EQ(bed.size[2], 1.2);
  EXPECT_EQ(bed.output.profiles.z, (std::vector{0.05}));
  EXPECT_FALSE(bed.models.effects_auto);
  EXPECT_EQ(bed.smoothing_length, 0.009);
}

TEST(Set, GivesParametersToAModelInShortForm) {
  const RealScene bed = read_text_case(k_example, {"models.drag.c1=0.7", "models.scaling=exact"}).scene;
  EXPECT_EQ(bed.models.drag.id, "syamlal_obrien");
  EXPECT_EQ(parameter(bed.models.drag, "c1"), 0.7);
  EXPECT_EQ(bed.models.scaling.id, "exact");
}

TEST(PluginPaths, AreReadBeforeTheRestAndStartAtTheCase) {
  const CaseFolder folder;
  std::filesystem::create_directories(folder.path() / "mine");
  const auto file = folder.write("a.yaml", "similitude: 1\nplugin_paths: [mine]\nnonsense: 3\n");
  EXPECT_EQ(plugin_paths_of(file), std::vector{folder.path() / "mine"});
  const auto none = folder.write("b.yaml", "similitude: 1\n");
  EXPECT_TRUE(plugin_paths_of(none).empty());
}

void expect_same(const RealScene& a, const RealScene& b) {
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.cell, b.cell);
  EXPECT_EQ(a.gravity, b.gravity);
  EXPECT_EQ(a.gas_viscosity, b.gas_viscosity);
  ASSERT_EQ(a.patches.size(), b.patches.size());
  for (std::size_t i = 0; i < a.patches.size(); ++i) {
    EXPECT_EQ(a.patches[i].name, b.patches[i].name);
    EXPECT_EQ(a.patches[i].extent[0].low, b.patches[i].extent[0].low);
    EXPECT_EQ(a.patches[i].velocity, b.patches[i].velocity);
    EXPECT_EQ(a.patches[i].ramp, b.patches[i].ramp);
  }
  ASSERT_EQ(a.baffles.size(), b.baffles.size());
  for (std::size_t i = 0; i < a.baffles.size(); ++i) {
    EXPECT_EQ(a.baffles[i].name, b.baffles[i].name);
    EXPECT_EQ(a.baffles[i].position, b.baffles[i].position);
    EXPECT_EQ(a.baffles[i].extent[2].high, b.baffles[i].extent[2].high);
  }
  ASSERT_EQ(a.models.contact.parameters.size(), b.models.contact.parameters.size());
  for (std::size_t i = 0; i < a.models.contact.parameters.size(); ++i) {
    const ModelParameter &p = a.models.contact.parameters[i], &q = b.models.contact.parameters[i];
    EXPECT_TRUE(p.real == q.real || (std::isnan(p.real) && std::isnan(q.real))) << p.name;
    EXPECT_EQ(p.text, q.text);
  }
  EXPECT_EQ(a.models.simulated_stiffness, b.models.simulated_stiffness);
  EXPECT_EQ(a.smoothing_length, b.smoothing_length);
  EXPECT_EQ(a.time.dt, b.time.dt);
  EXPECT_EQ(a.output.vtk_every, b.output.vtk_every);
  EXPECT_EQ(a.output.profiles.z, b.output.profiles.z);
  ASSERT_EQ(a.output.probes.size(), b.output.probes.size());
  for (std::size_t i = 0; i < a.output.probes.size(); ++i) {
    EXPECT_EQ(a.output.probes[i].name, b.output.probes[i].name);
    EXPECT_EQ(a.output.probes[i].place, b.output.probes[i].place);
  }
}

TEST(ResolvedCase, IsACaseThatReadsAsTheSameBed) {
  const CaseFile first =
      read_text_case(k_example, {"time.dt=1.1 us", "coupling.smoothing=8.5 mm", "models.scaling.stiffness=61.7 N/m"});
  const CaseFile again = read_text_case(first.resolved);
  expect_same(first.scene, again.scene);
  EXPECT_EQ(again.resolved, first.resolved);
}

TEST(ResolvedCase, HoldsTheDefaults) {
  const std::string resolved = read_text_case(k_example).resolved;
  EXPECT_NE(resolved.find("\"ramp\": \"0.05 s\""), std::string::npos);
  EXPECT_NE(resolved.find("\"c1\": 0.8"), std::string::npos);
  EXPECT_NE(resolved.find("\"film\": \"2e-06 m\""), std::string::npos);
}

// The real bed is described once: what is simulated in its place is models.scaling's business only.
TEST(ShippedCases, DifferInTheScalingOnly) {
  const std::filesystem::path folder = SIMILITUDE_CONFIGS;
  const CaseFile exact = read_case(folder / "spouted_bed/exact.yaml", fake_catalogue());
  const CaseFile scaled =
      read_case(folder / "spouted_bed/terminal_velocity.yaml", fake_catalogue(), {"models.scaling=exact"});
  EXPECT_EQ(exact.resolved, scaled.resolved);
  const CaseFile as_shipped = read_case(folder / "spouted_bed/terminal_velocity.yaml", fake_catalogue());
  EXPECT_EQ(as_shipped.scene.models.scaling.id, "terminal_velocity");
}

TEST(ShippedCases, QuickstartIsTheSameBedForAShorterTime) {
  const std::filesystem::path folder = SIMILITUDE_CONFIGS;
  const RealScene quick = read_case(folder / "quickstart.yaml", fake_catalogue()).scene;
  const RealScene paper = read_case(folder / "spouted_bed/terminal_velocity.yaml", fake_catalogue()).scene;
  EXPECT_EQ(quick.size, paper.size);
  EXPECT_EQ(quick.patches[0].velocity, paper.patches[0].velocity);
  EXPECT_EQ(quick.time.end, 0.8);
  EXPECT_EQ(quick.output.vtk_every, 0.02);
  EXPECT_EQ(quick.output.monitor_every, 0.005);
  EXPECT_EQ(quick.output.profiles.from, 0.4);
}

}  // namespace
}  // namespace similitude
