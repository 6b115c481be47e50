#include "study/cost.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "output/whole_file.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::json;

constexpr const char* k_cost_file = "cost.json";

json as_json(const Prediction& predicted) {
  if (!predicted.known()) return {{"gap", predicted.gap}};
  json page{{"wall_s", predicted.wall_s}, {"particle_steps", predicted.particle_steps}, {"stages", json::array()}};
  for (const RunTiming::Stage& stage : predicted.stages) page["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}});
  return page;
}

Prediction as_prediction(const json& page) {
  Prediction predicted;
  if (page.contains("gap")) {
    predicted.gap = page["gap"].get<std::string>();
  } else if (page.contains("wall_s")) {
    predicted.gap = "";
    predicted.wall_s = page["wall_s"].get<double>();
    predicted.particle_steps = page["particle_steps"].get<double>();
    for (const json& stage : page["stages"]) predicted.stages.push_back({stage["name"].get<std::string>(), stage["seconds"].get<double>()});
  }
  return predicted;
}

/// The kernel may change under a machine.
json as_json(const Machine& machine) { return {{"processor", machine.processor}, {"cores", machine.cores}}; }

json read_page(const fs::path& folder) {
  std::ifstream stream(folder / k_cost_file);
  return json::parse(stream, nullptr, false);
}

}  // namespace

std::string farthest_off(const Prediction& predicted, const RunTiming& measured) {
  std::string words;
  double farthest = 0;  // [s]
  for (const RunTiming::Stage& stage : measured.stages)
    for (const RunTiming::Stage& foretold : predicted.stages)
      if (foretold.name == stage.name && std::abs(foretold.seconds - stage.seconds) > farthest) {
        farthest = std::abs(foretold.seconds - stage.seconds);
        words = fmt::format("{} {:.2g} s, measured {:.2g} s", stage.name, foretold.seconds, stage.seconds);
      }
  return words;
}

void write_cost(const fs::path& folder, const Cost& cost) {
  write_whole_file(folder / k_cost_file,
                   json{{"machine", as_json(this_machine())},
                        {"wall_s", cost.repeats},
                        {"peak_memory_bytes", cost.peak_memory_bytes},
                        {"predicted", as_json(cost.predicted)}}
                           .dump(2) + "\n");
}

Cost read_cost(const fs::path& folder) {
  const json page = read_page(folder);
  Cost cost;
  if (page.is_discarded()) return cost;
  cost.repeats = page.value("wall_s", std::vector<double>{});
  if (page.contains("peak_memory_bytes") && page["peak_memory_bytes"].is_number())
    cost.peak_memory_bytes = page["peak_memory_bytes"].get<double>();
  if (page.contains("predicted")) cost.predicted = as_prediction(page["predicted"]);
  return cost;
}

void remove_cost(const fs::path& folder) {
  std::error_code ignored;
  fs::remove(folder / k_cost_file, ignored);
}

bool made_here(const RunManifest& manifest) { return as_json(manifest.machine) == as_json(this_machine()); }

bool timed_here(const fs::path& folder) {
  const json page = read_page(folder);
  if (!page.is_discarded()) return page.contains("machine") && page["machine"] == as_json(this_machine());
  const RunManifest manifest = read_manifest(folder);
  return manifest.at_one_go && made_here(manifest);
}

}  // namespace similitude
