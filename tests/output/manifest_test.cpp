#include "output/manifest.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "output/sha256.h"
#include "output/whole_file.h"
#include "scratch.h"

using namespace similitude;
using namespace similitude::test;
using nlohmann::json;

namespace {

Manifest a_manifest() {
  Manifest manifest;
  manifest.program_version = "0.1.0";
  manifest.command = "similitude run small.yaml";
  manifest.case_file = "small.yaml";
  manifest.plugins = {{"drag", "gidaspow", "1.0.0", "/lib/drag.so", "ab12"}};
  manifest.machine = {"A processor", "Linux 6.1", 2};
  manifest.threads = 2;
  manifest.scaling = identity_ratios();
  manifest.scaling.length = 0.25;
  manifest.map_back = quarter_scale();
  manifest.particles = 461'000;
  manifest.started = "2026-03-01T12:00:00Z";
  return manifest;
}

json written(const Manifest& manifest, const CaseIdentity& identity = {"{}", ""}) {
  const ScratchFolder folder;
  write_manifest(OutputDirectory(folder.path(), false), manifest, identity);
  return json::parse(text_of(folder / "manifest.json"));
}

}  // namespace

TEST(ManifestFile, SaysAtTheStartThatTheRunIsRunning) {
  const json m = written(a_manifest());
  EXPECT_EQ(m["status"], "running");
  EXPECT_EQ(m["program"], (json{{"name", "similitude"}, {"version", "0.1.0"}}));
  EXPECT_EQ(m["abi"], (json{{"major", SIMILITUDE_ABI_MAJOR}, {"minor", SIMILITUDE_ABI_MINOR}}));
  EXPECT_EQ(m["started"], "2026-03-01T12:00:00Z");
  EXPECT_TRUE(m["ended"].is_null());
  EXPECT_TRUE(m["exit_status"].is_null());
  EXPECT_TRUE(m["state_hash"].is_null());
  EXPECT_EQ(m["threads"], 2);
  EXPECT_EQ(m["machine"], (json{{"processor", "A processor"}, {"cores", 2}, {"kernel", "Linux 6.1"}}));
  EXPECT_EQ(
      m["plugins"][0],
      (json{{"kind", "drag"}, {"id", "gidaspow"}, {"version", "1.0.0"}, {"file", "/lib/drag.so"}, {"sha256", "ab12"}}));
}

TEST(ManifestFile, NamesTheBedsFileByItsBytes) {
  EXPECT_TRUE(written(a_manifest())["bed_sha256"].is_null());
  EXPECT_EQ(written(a_manifest(), {"{}", "ab12"})["bed_sha256"], "ab12");
}

TEST(ManifestFile, SaysAtTheEndHowItEnded) {
  Manifest manifest = a_manifest();
  manifest.status = "stopped";
  manifest.exit_status = 1;
  manifest.exit_reason = "overlap of 31 % of a diameter";
  manifest.ended = "2026-03-01T12:10:00Z";
  manifest.state_hash = "0123";
  manifest.simulated_s = 0.25;
  const json m = written(manifest);
  EXPECT_EQ(m["status"], "stopped");
  EXPECT_EQ(m["exit_status"], 1);
  EXPECT_EQ(m["exit_reason"], "overlap of 31 % of a diameter");
  EXPECT_EQ(m["ended"], "2026-03-01T12:10:00Z");
  EXPECT_EQ(m["state_hash"], "0123");
  EXPECT_EQ(m["simulated_s"], 0.25);
}

TEST(ManifestFile, HoldsTheRatiosOfTheLawAndOfTheMapBack) {
  const json m = written(a_manifest());
  EXPECT_EQ(m["scaling"]["law"], "test_law");
  EXPECT_EQ(m["scaling"]["ratios"]["length"], 0.25);
  EXPECT_EQ(m["map_back"]["velocity"], 0.5);
  EXPECT_EQ(m["map_back"]["jet_ratio"], 2);
  EXPECT_EQ(m["map_back"]["divided_by"]["monitors: inflow, outflow [kg/s]"], "gas_density length^2 velocity");
}

TEST(ManifestFile, HoldsTheResolvedCaseFileAsItIs) {
  EXPECT_EQ(written(a_manifest(), {R"({"similitude": 1, "time": {"end": "5 s"}})", ""})["case"],
            (json{{"similitude", 1}, {"time", {{"end", "5 s"}}}}));
}

TEST(ManifestFile, SurvivesAPathThatIsNotUtf8) {
  Manifest manifest = a_manifest();
  manifest.case_file =
      "b\xe9"
      "d.yaml";
  EXPECT_EQ(written(manifest)["case_file"],
            "b\xef\xbf\xbd"
            "d.yaml");
}

TEST(ManifestFile, NamesAPluginByTheHashOfItsFile) {
  const ScratchFolder folder;
  write_whole_file(folder / "p.so", "abc");
  similitude_descriptor descriptor{};
  descriptor.kind = "drag";
  descriptor.id = "gidaspow";
  descriptor.version = "1.0.0";
  PluginEntry entry;
  entry.descriptor = &descriptor;
  entry.file = folder / "p.so";
  const ManifestPlugin plugin = manifest_plugin(entry);
  EXPECT_EQ(plugin.id, "gidaspow");
  EXPECT_EQ(plugin.file, (folder / "p.so").string());
  EXPECT_EQ(plugin.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");  // FIPS 180-2, "abc"
}

TEST(ManifestFile, KnowsTheMachineAndTheTime) {
  const Machine machine = this_machine();
  EXPECT_GE(machine.cores, 1);
  EXPECT_THAT(machine.kernel, testing::StartsWith("Linux "));
  EXPECT_FALSE(machine.processor.empty());
  EXPECT_THAT(utc_now(), testing::MatchesRegex("20[0-9][0-9]-[01][0-9]-[0-3][0-9]T[0-9:]+Z"));
}
