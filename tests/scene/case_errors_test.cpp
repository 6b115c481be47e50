// Every text is the whole message: place, what was given, why it is wrong, what to type instead.
#include <gtest/gtest.h>

#include "case_text.h"

namespace similitude {
namespace {

using testing::CaseFolder;
using testing::complaint;
using testing::example_with;
using testing::fake_catalogue;
using testing::k_example;

TEST(CaseErrors, UnknownKeysNameTheNearest) {
  EXPECT_EQ(complaint(example_with("diameter: 1 mm", "diamter: 1 mm")),
            "spout.yaml:6:25: scene.particles.alumina.diamter: there is no such key.\n"
            "  Did you mean \"diameter\"?\n"
            "  Keys of scene.particles.alumina: diameter, density, count.");
  EXPECT_EQ(complaint(k_example + "colour: red\n"),
            "spout.yaml:21:1: colour: there is no such key.\n"
            "  Keys of a case file: similitude, title, plugin_paths, scene, models, coupling, time, output.");
}

TEST(CaseErrors, UnitsAreChecked) {
  EXPECT_EQ(complaint(example_with("cell: 5 mm", "cell: 5")),
            "spout.yaml:4:49: scene.domain.cell: 5 has no unit; a length is needed.\n  Write for example 5 mm.");
  EXPECT_EQ(complaint(example_with("velocity: 13.2 m/s", "velocity: 13.2 m")),
            "spout.yaml:9:61: scene.patches.spout.velocity: 13.2 m is a length; a velocity is needed.\n  Write for "
            "example 13.2 m/s.");
  EXPECT_EQ(
      complaint(example_with("[70 mm, 80 mm]", "[70 mm, 80]")),
      "spout.yaml:9:43: scene.patches.spout.x.1: 80 has no unit; a length is needed.\n  Write for example 80 mm.");
  EXPECT_EQ(complaint(example_with("friction: 0.2", "friction: 0.2 mm")),
            "spout.yaml:15:81: models.contact.friction: 0.2 mm is a length; a pure number is needed.\n"
            "  Write it without a unit, for example 0.2.");
}

TEST(CaseErrors, AUnitThatAPluginMadeUpIsThePluginsFault) {
  static const similitude_parameter rows[] = {testing::real("length", "furlong", "a length", 1, 0, testing::k_open)};
  const Catalogue catalogue(std::vector<PluginEntry>{testing::model("drag", "imperial", rows)});
  const CaseFolder folder;
  const std::filesystem::path file = folder.write("spout.yaml", example_with("drag: syamlal_obrien", "drag: imperial"));
  try {
    read_case(file, catalogue);
    FAIL() << "the case was read";
  } catch (const PluginError& error) {
    EXPECT_EQ(error.what(), file.string() +
                                ":14:9: models.drag: imperial declares its parameter length in \"furlong\", which is no unit.\n"
                                "  This is for the plugin's author to mend: SI units as in a case file, \"1\" for a pure number.\n"
                                "  (from /plugins/drag_imperial.so, version 1.0.0)");
  }
}

TEST(CaseErrors, NegativeSizesAreRefused) {
  EXPECT_EQ(
      complaint(example_with("diameter: 1 mm", "diameter: -1 mm")),
      "spout.yaml:6:35: scene.particles.alumina.diameter: -1 mm is out of range: a length here must be above zero.");
  EXPECT_EQ(complaint(example_with("count: 461000", "count: 0")),
            "spout.yaml:6:70: scene.particles.alumina.count: 0 is out of range: this number must be above zero.");
}

TEST(CaseErrors, TypesAreChecked) {
  EXPECT_EQ(complaint(example_with("count: 461000", "count: many")),
            "spout.yaml:6:70: scene.particles.alumina.count: \"many\" is not a whole number.\n  Write digits only, for "
            "example 461000.");
  EXPECT_EQ(
      complaint(example_with("rest: true", "rest: maybe")),
      "spout.yaml:10:38: scene.patches.background.rest: \"maybe\" is neither true nor false.\n  Write true or false.");
  EXPECT_EQ(complaint(example_with("face: bottom, x", "face: botom, x")),
            "spout.yaml:9:24: scene.patches.spout.face: \"botom\" is not possible here.\n"
            "  Did you mean \"bottom\"?\n  Possible: left, right, front, back, bottom, top.");
  EXPECT_EQ(complaint(example_with("[150 mm, 20 mm, 1 m]", "[150 mm, 20 mm]")),
            "spout.yaml:4:21: scene.domain.size: three values (x, y, z) are needed, but this is a list of 2.\n"
            "  Write for example [1 mm, 1 mm, 1 mm].");
  EXPECT_EQ(complaint(example_with("x: [70 mm, 80 mm]", "x: 70 mm")),
            "spout.yaml:9:35: scene.patches.spout.x: two ends are needed, but this is \"70 mm\".\n"
            "  Write for example [10 mm, 20 mm].");
  EXPECT_EQ(complaint(example_with("x: [70 mm, 80 mm]", "x: [80 mm, 70 mm]")),
            "spout.yaml:9:35: scene.patches.spout.x: the first end, 80 mm, is not below the second, 70 mm.\n  Write "
            "[70 mm, 80 mm].");
  EXPECT_EQ(complaint(example_with("vtk: every 50 ms", "vtk: 50 ms")),
            "spout.yaml:20:15: output.vtk: \"50 ms\" is not an interval.\n  Write for example every 50 ms, or none.");
  EXPECT_EQ(complaint(example_with("{fill: settle}", "settle")),
            "spout.yaml:7:14: scene.bed: a map of keys is needed, but this is \"settle\".\n"
            "  Keys of scene.bed: fill, file, height, seed, cache.");
}

TEST(CaseErrors, MissingKeysSayWhatTheyAre) {
  EXPECT_EQ(complaint(example_with(", viscosity: 1.79e-5 Pa s", "")),
            "spout.yaml:5:14: scene.gas: the key viscosity is missing (dynamic viscosity).\n  Add for example "
            "viscosity: 1 Pa s.");
  EXPECT_EQ(complaint(example_with("  fluid: vans\n", "")),
            "spout.yaml:14:3: models: the key fluid is missing (gas solver).");
}

TEST(CaseErrors, KeysGivenTwiceAreRefused) {
  EXPECT_EQ(complaint(k_example + "time: {end: 6 s}\n"),
            "spout.yaml:21:1: time: this key was given before, in line 19.\n  Keep one of the two.");
}

TEST(CaseErrors, TheVersionComesFirst) {
  EXPECT_EQ(
      complaint(example_with("similitude: 1\n", "")),
      "spout.yaml:1:1: similitude: this key is missing: it says for which version of the format a case is written.\n"
      "  Start the file with the line similitude: 1.");
  EXPECT_EQ(complaint("similitude: 2\nunheard_of: 3\n"),
            "spout.yaml:1:13: similitude: \"2\" is no version of the format that this program knows.\n"
            "  Write similitude: 1, or use a program made for that version.");
}

TEST(CaseErrors, FilesThatAreNoCases) {
  EXPECT_EQ(complaint("similitude: [1\nscene: {\n").substr(0, 40), "spout.yaml:2:6: this is not YAML: end of");
  EXPECT_EQ(complaint(""),
            "spout.yaml: a case file is a map of keys, but this is nothing.\n  Start with the line similitude: 1.");
  try {
    read_case("no/such.yaml", fake_catalogue());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "no/such.yaml: there is no such file.");
  }
}

// An alias inside itself would be read for ever.
TEST(CaseErrors, EndlessAliasesEnd) {
  EXPECT_NE(complaint("a: &x [*x]\nsimilitude: 1\n").find("nested too deeply.\n  Does an alias contain itself?"),
            std::string::npos);
}

TEST(CaseErrors, ModelsThatNoPluginProvides) {
  const std::string text = complaint(example_with("drag: syamlal_obrien", "drag: gidaspo"));
  EXPECT_TRUE(text.starts_with("[plugin] spout.yaml:14:9: models.drag: there is no drag model \"gidaspo\".")) << text;
  EXPECT_NE(text.find("Did you mean \"gidaspow\""), std::string::npos) << text;
}

TEST(CaseErrors, ParametersFollowThePluginsTable) {
  EXPECT_EQ(complaint(example_with("restitution: 0.74", "restitution: 1.4")),
            "spout.yaml:15:65: models.contact.restitution: 1.4 is out of range: linear_spring takes restitution from "
            "0.01 to 1.\n"
            "  restitution: normal restitution.");
  EXPECT_EQ(complaint(example_with("friction: 0.2", "fricton: 0.2")),
            "spout.yaml:15:71: models.contact.fricton: linear_spring has no such parameter.\n"
            "  Did you mean \"friction\"?\n"
            "  Parameters of linear_spring: stiffness, restitution, friction, glide_speed, youngs_modulus, film, "
            "cut_off, relaxation, "
            "attraction, tangential, terms, pair.");
  EXPECT_EQ(complaint(example_with("stiffness: 500 N/m, ", "")),
            "spout.yaml:15:12: models.contact: linear_spring needs the parameter stiffness (normal spring).\n"
            "  Add for example stiffness: 2000 N/m.");
  EXPECT_EQ(complaint(example_with("{id: linear_spring, stiffness: 500 N/m, restitution: 0.74, friction: 0.2}",
                                   "linear_spring")),
            "spout.yaml:15:12: models.contact: linear_spring needs the parameter stiffness (normal spring).\n"
            "  Write for example {id: linear_spring, stiffness: 2000 N/m, restitution: 1}.");
  EXPECT_EQ(complaint(k_example, {"models.contact.tangential=histroy"}),
            "--set: models.contact.tangential: \"histroy\" is not possible here.\n"
            "  Did you mean \"history\"?\n  Possible: history, slip.");
  EXPECT_EQ(complaint(k_example, {"models.contact.film=2 mm"}),
            "--set: models.contact.film: 2 mm is out of range: linear_spring takes film from 0 um to 1000 um.\n  film: "
            "liquid film.");
  EXPECT_EQ(complaint(example_with("{id: terminal_velocity, geometry: 0.25}", "{geometry: 0.25}")),
            "spout.yaml:17:12: models.scaling: the id of a scaling model is missing.\n"
            "  Write its id, or {id: …, parameter: value}. Models found: exact, terminal_velocity.");
  EXPECT_EQ(complaint(k_example, {"models.effects=magnus"}),
            "--set: models.effects: \"magnus\" is neither auto nor a list of effects.\n"
            "  Write auto, [] for none, or for example [magnus].");
  EXPECT_EQ(complaint(k_example, {"models.effects=[magnus, magnus]"}),
            "--set: models.effects.1: magnus is in the list twice.\n  Keep one of the two.");
}

TEST(CaseErrors, CellsDivideTheDomain) {
  EXPECT_EQ(complaint(example_with("[150 mm, 20 mm, 1 m]", "[152 mm, 20 mm, 1 m]")),
            "spout.yaml:4:22: scene.domain.size: x = 152 mm is not a whole number of cells of 5 mm.\n"
            "  Use 150 mm or 155 mm, or set scene.domain.cell: 1 mm.");
  EXPECT_EQ(complaint(example_with("[150 mm, 20 mm, 1 m]", "[150 mm, 4 mm, 1 m]")),
            "spout.yaml:4:30: scene.domain.size: y = 4 mm is not a whole number of cells of 5 mm.\n"
            "  Use 5 mm, or set scene.domain.cell: 4 mm.");
}

TEST(CaseErrors, TheBedFitsTheDomain) {
  EXPECT_EQ(complaint(example_with("diameter: 1 mm", "diameter: 30 mm")),
            "spout.yaml:6:35: scene.particles.alumina.diameter: a particle of 30 mm does not fit into a domain of 20 "
            "mm along y.\n"
            "  Is the unit right?");
  EXPECT_EQ(complaint(example_with("count: 461000", "count: 4610000")),
            "spout.yaml:6:70: scene.particles.alumina.count: these particles make a bed higher than the domain of "
            "1000 mm: 1257.18 mm to 1609.19 mm (solids fraction 0.64 to 0.5).\n  Fewer particles, or a larger domain.");
  EXPECT_EQ(complaint(example_with(", count: 461000}}\n  bed:       {fill: settle}", "}}\n  bed: {height: 1.2 m}")),
            "spout.yaml:7:17: scene.bed.height: a bed of 1200 mm is higher than the domain of 1000 mm.\n"
            "  Lower the bed, or raise the third value of scene.domain.size.");
  EXPECT_EQ(complaint(example_with("{fill: settle}", "{height: 100 mm}")),
            "spout.yaml:6:70: scene.particles.alumina.count: the bed has a height as well; one of the two decides how "
            "many particles there are.\n"
            "  Remove this count, or scene.bed.height.");
  EXPECT_EQ(complaint(example_with(", count: 461000", "")),
            "spout.yaml:6:24: scene.particles.alumina: nothing says how many particles there are.\n  Add a count, or "
            "scene.bed.height.");
}

TEST(CaseErrors, BedFiles) {
  EXPECT_EQ(
      complaint(example_with("{fill: settle}", "{fill: file, file: grains.csv}")),
      "spout.yaml:7:33: scene.bed.file: there is no file grains.csv.\n  A relative path starts at the case's folder.");
  EXPECT_EQ(complaint(example_with("{fill: settle}", "{fill: file}")),
            "spout.yaml:7:21: scene.bed.fill: fill: file needs to know which file.\n  Add for example file: bed.csv.");
  EXPECT_EQ(complaint(example_with("{fill: settle}", "{file: bed.csv}")),
            "spout.yaml:7:21: scene.bed.file: a file is read only with fill: file, but fill is settle.\n"
            "  Write fill: file, or remove this key.");
}

// What would be ignored is not silently taken.
TEST(CaseErrors, AmountsHaveOneSource) {
  const CaseFolder folder;
  folder.write("bed.csv", "x,y,z\n");
  const auto message = [&](const std::string& text) -> std::string {
    try {
      read_case(folder.write("spout.yaml", text), fake_catalogue());
      return "";
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder.path().string().size() + 1);
    }
  };
  EXPECT_EQ(message(example_with("{fill: settle}", "{fill: file, file: bed.csv}")),
            "spout.yaml:6:70: scene.particles.alumina.count: the file of scene.bed says how many particles there are.\n"
            "  Remove this count.");
  EXPECT_EQ(message(example_with("{fill: settle}", "{fill: none, height: 10 mm}")),
            "spout.yaml:7:35: scene.bed.height: only fill: settle and fill: lattice fill to a height.\n"
            "  Remove this key, or change fill.");
}

TEST(CaseErrors, OneDensityUnderAScalingLaw) {
  const std::string two =
      example_with("count: 461000}}", "count: 400000}, glass: {diameter: 1 mm, density: 2500 kg/m^3, count: 61000}}");
  EXPECT_EQ(complaint(two),
            "spout.yaml:6:112: scene.particles.glass.density: the scaling law terminal_velocity is for one particle "
            "density, but glass has "
            "2500 kg/m^3 and alumina 1040 kg/m^3.\n  Give all classes one density, or use models.scaling: exact.");
  EXPECT_EQ(complaint(two, {"models.scaling=exact"}), "");
}

TEST(CaseErrors, PatchesStayOnTheirFaces) {
  EXPECT_EQ(complaint(example_with("x: [70 mm, 80 mm]", "x: [70 mm, 180 mm]")),
            "spout.yaml:9:35: scene.patches.spout.x: [70 mm, 180 mm] is outside the bottom face, which goes from 0 mm "
            "to 150 mm.\n"
            "  Use values in that range, or leave the key out for all of it.");
  EXPECT_EQ(complaint(example_with("x: [70 mm, 80 mm]", "z: [70 mm, 80 mm]")),
            "spout.yaml:9:35: scene.patches.spout.z: the bottom face has no extent along z.\n"
            "  Remove this key; a patch on this face extends along x and y.");
  EXPECT_EQ(complaint(example_with("rest: true,", "rest: true, x: [0 mm, 5 mm],")),
            "spout.yaml:10:47: scene.patches.background.x: a patch with rest: true takes what other patches leave, so "
            "it has no extent of its own.\n"
            "  Remove this key, or rest: true.");
  EXPECT_EQ(complaint(example_with("{face: bottom, rest: true,", "{face: bottom, x: [75 mm, 90 mm],")),
            "spout.yaml:10:17: scene.patches.background: it overlaps spout on the bottom face.\n"
            "  Make the extents meet at an edge, or write rest: true for the one that takes what is left.");
  EXPECT_EQ(complaint(example_with("x: [70 mm, 80 mm]", "rest: true")),
            "spout.yaml:10:17: scene.patches.background: the rest of the bottom face is taken by spout already.\n"
            "  Only one patch of a face can have rest: true.");
  EXPECT_EQ(complaint(example_with("{face: bottom, rest: true,", "{face: bottom, x: [80 mm, 90 mm],")), "");
}

TEST(CaseErrors, PatchesAreInletsOrOpenings) {
  EXPECT_EQ(complaint(example_with("pressure: 0 Pa", "pressure: 0 Pa, velocity: 1 m/s")),
            "spout.yaml:11:17: scene.patches.outlet: a patch has a velocity or a pressure, not both.\n"
            "  Write for example velocity: 1 m/s, or pressure: 0 Pa.");
  EXPECT_EQ(complaint(example_with("pressure: 0 Pa", "pressure: 0 Pa, ramp: 1 s")),
            "spout.yaml:11:51: scene.patches.outlet.ramp: only an inlet (velocity) has a ramp.\n  Remove this key.");
  EXPECT_EQ(complaint(example_with("    outlet:     {face: top, pressure: 0 Pa}\n", "")),
            "spout.yaml:9:5: scene.patches: gas is blown in, but there is no opening to let it out.\n"
            "  Add for example outlet: {face: top, pressure: 0 Pa}.");
}

// 10 mm of 150 at full speed against the other 140 mm: as much out as in.
TEST(CaseErrors, WhatGoesInComesOutWhilePatchesOpenToo) {
  std::string closed = example_with("    outlet:     {face: top, pressure: 0 Pa}\n", "");
  const auto replace = [&](const std::string& from, const std::string& to) { closed.replace(closed.find(from), from.size(), to); };
  replace("    spout: ", "    out:        {face: top, velocity: -1 m/s, ramp: 20 ms}\n    spout: ");
  closed.replace(closed.find("    spout: "), closed.find("  baffles:") - closed.find("    spout: "),
                 "    in:         {face: bottom, velocity: 1 m/s, ramp: 20 ms}\n");
  EXPECT_EQ(complaint(closed), "");
  replace("1 m/s, ramp: 20 ms}\n  baffles", "1 m/s, ramp: 50 ms}\n  baffles");
  EXPECT_EQ(complaint(closed),
            "spout.yaml:9:5: scene.patches: what is blown in is drawn out again, but not while the patches open: their ramps differ.\n"
            "  Give them one ramp, or add an opening, for example outlet: {face: top, pressure: 0 Pa}.");
}

TEST(CaseErrors, PeriodicDirectionsHaveNoFaces) {
  EXPECT_EQ(
      complaint(example_with("  bed:  ", "  periodic: [z]\n  bed:  ")),
      "spout.yaml:10:17: scene.patches.spout: the domain is periodic along z, so its bottom face holds no patch.\n"
      "  Take z out of scene.periodic, or remove the patch.");
  EXPECT_EQ(
      complaint(example_with("  bed:  ", "  periodic: [x]\n  walls: {left: slip}\n  bed:  ")),
      "spout.yaml:8:17: scene.walls.left: the domain is periodic along x, so it has no left wall.\n  Remove this key.");
}

TEST(CaseErrors, PlatesStandInTheDomain) {
  EXPECT_EQ(
      complaint(example_with("at_x: [60 mm, 90 mm]", "at_x: [60 mm, 190 mm]")),
      "spout.yaml:12:38: scene.baffles.plates.at_x: 190 mm is not inside the domain, which goes from 0 mm to 150 mm.\n"
      "  A plate stands between two walls.");
  EXPECT_EQ(complaint(example_with("at_x: [60 mm, 90 mm], ", "")),
            "spout.yaml:12:23: scene.baffles.plates: the plate has no position.\n"
            "  Give one of at_x, at_y, at_z: the position of its mid-plane.");
  EXPECT_EQ(complaint(example_with("z: [30 mm, 250 mm], thickness", "x: [30 mm, 50 mm], thickness")),
            "spout.yaml:12:49: scene.baffles.plates.x: a plate normal to x has no extent along it; at_x says where it "
            "stands.\n"
            "  Remove this key; the thickness has a key of its own.");
}

TEST(CaseErrors, TimesFitEachOther) {
  EXPECT_EQ(complaint(k_example, {"time.dt=6 s"}),
            "--set: time.dt: 6 s is longer than the run of 5 s.\n  Write auto to have it chosen.");
  EXPECT_EQ(complaint(k_example, {"time.dt=2 us", "time.gas_dt=1 us"}),
            "--set: time.gas_dt: 1e-06 s is shorter than the particles' sub-step time.dt of 2e-06 s.\n"
            "  A gas step is a whole number of sub-steps; write auto to have it chosen.");
}

TEST(CaseErrors, ProfilesLieInTheDomainAndTheRun) {
  EXPECT_EQ(complaint(example_with("[100 mm, 300 mm]", "[100 mm, 3 m]")),
            "spout.yaml:20:51: output.profiles.z: 3000 mm is outside the domain, which goes from 0 mm to 1000 mm.");
  EXPECT_EQ(complaint(example_with("from: 1 s", "from: 5 s")),
            "spout.yaml:20:66: output.profiles.from: averaging starts at 5 s, but the run ends at 5 s.\n  Start "
            "earlier, or raise time.end.");
}

TEST(CaseErrors, ProbesLieInTheDomain) {
  EXPECT_EQ(complaint(example_with("profiles: {", "probes: {tap: {at: [75 mm, 25 mm, 100 mm]}}, profiles: {")),
            "spout.yaml:20:47: output.probes.tap.at: y = 25 mm is outside the domain, which goes from 0 mm to 20 mm.");
}

TEST(CaseErrors, OverridesSayWhereTheyComeFrom) {
  EXPECT_EQ(complaint(k_example, {"models.scaling.geometry"}),
            "--set: \"models.scaling.geometry\" is not of the form key=value.\n  Write for example --set "
            "models.scaling.geometry=0.5.");
  EXPECT_EQ(complaint(k_example, {"models.scaling.geometry=2"}),
            "--set: models.scaling.geometry: 2 is out of range: terminal_velocity takes geometry from 0.001 to 1.\n  "
            "geometry: length ratio.");
  EXPECT_EQ(complaint(k_example, {"modls.drag=gidaspow"}),
            "--set: modls: there is no such key.\n  Did you mean \"models\"?\n"
            "  Keys of a case file: similitude, title, plugin_paths, scene, models, coupling, time, output.");
  EXPECT_EQ(complaint(k_example, {"scene.domain.cell.x=1 mm"}),
            "--set: scene.domain.cell.x: scene.domain.cell is \"5 mm\" and has no keys below it.\n  Set "
            "scene.domain.cell itself.");
  EXPECT_EQ(
      complaint(k_example, {"scene.domain.size.3=1 mm"}),
      "--set: scene.domain.size.3: scene.domain.size is a list of 3 and has no item 3.\n  Items are counted from 0.");
}

// Whatever a slip of the hand makes of a case, it is read or refused in words; nothing else is thrown.
TEST(CaseErrors, NoSlipOfTheHandBreaksTheReader) {
  const CaseFolder folder;
  const auto survives = [&](const std::string& text) {
    try {
      read_case(folder.write("spout.yaml", text), fake_catalogue());
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with((folder.path() / "spout.yaml").string())) << error.what();
    } catch (const PluginError&) {
    }
  };
  for (std::size_t i = 0; i < k_example.size(); ++i) {
    std::string text = k_example;
    survives(text.erase(i, 1));
  }
  for (const char* letter : {" ", "\n", "-", "{", "]", ":", "9", "*", "&", "\t", "~"}) {
    for (std::size_t i = 0; i < k_example.size(); i += 13) {
      std::string text = k_example;
      survives(text.insert(i, letter));
    }
  }
}

TEST(CaseErrors, PluginPathsExist) {
  EXPECT_EQ(complaint(k_example + "plugin_paths: [mine]\n"),
            "spout.yaml:21:16: plugin_paths: there is no folder mine.\n  A relative path starts at the case's folder.");
}

}  // namespace
}  // namespace similitude
