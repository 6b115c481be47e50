#include "study/leg.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "output/checkpoint_file.h"
#include "output/number.h"
#include "output/whole_file.h"
#include "stepper/resume.h"
#include "stepper/stop_signal.h"
#include "study/child_run.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::json;

constexpr const char* k_leg_file = "leg.json";  // written when the leg is done
constexpr const char* k_case_file = "case.json";
constexpr const char* k_log_file = "run.log";

/// What resuming reads: the newest checkpoint and the files beside it, not the frames.
bool copy_last_state(const fs::path& run, const fs::path& to) {
  std::error_code error;
  const std::vector<fs::path> checkpoints = checkpoints_in(run / k_checkpoint_folder);
  if (checkpoints.empty()) return false;
  fs::create_directories(to / k_checkpoint_folder, error);
  fs::copy_file(checkpoints.front(), to / k_checkpoint_folder / checkpoints.front().filename(), error);
  for (const fs::directory_entry& entry : fs::directory_iterator(run, error))
    if (entry.is_regular_file() && entry.path().extension() != ".html") fs::copy_file(entry.path(), to / entry.path().filename(), error);
  return !error;
}

/// What `later` took beyond `before`.
RunTiming difference(const RunTiming& later, const RunTiming& before) {
  RunTiming between = later;
  between.wall_s -= before.wall_s;
  between.simulated_s -= before.simulated_s;
  between.particle_steps -= before.particle_steps;
  between.particle_steps_per_s = between.particle_steps / between.wall_s;
  for (RunTiming::Stage& stage : between.stages) {
    for (const RunTiming::Stage& earlier : before.stages)
      if (earlier.name == stage.name) stage.seconds -= earlier.seconds;
    stage.share = stage.seconds / between.wall_s;
  }
  return between;
}

/// As timing.json, so that it is read alike.
json as_json(const RunTiming& timing) {
  json page{{"wall_s", timing.wall_s},
            {"simulated_s", timing.simulated_s},
            {"particle_steps", timing.particle_steps},
            {"particle_steps_per_s", timing.particle_steps_per_s},
            {"stages", json::array()}};
  for (const RunTiming::Stage& stage : timing.stages)
    page["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"share", stage.share}});
  return page;
}

}  // namespace

fs::path case_of_leg(const fs::path& leg) { return leg / k_case_file; }

std::string run_leg(const fs::path& run, const fs::path& leg, double length, int threads) {
  if (read_leg(run, leg)) return "was timed before";
  std::error_code ignored;
  fs::remove_all(leg, ignored);
  fs::create_directories(leg, ignored);
  const RunTiming whole = read_timing(run);
  write_whole_file(case_of_leg(leg), read_manifest(run).identity.resolved_case + "\n");

  const auto go = [&](double until, const char* how) {
    std::vector<std::string> arguments{"run", case_of_leg(leg).string(), "-o", leg.string(), how, "--until", round_trip(until) + " s"};
    if (threads > 0) {
      arguments.push_back("--threads");
      arguments.push_back(std::to_string(threads));
    }
    return run_child(arguments, leg / k_log_file);
  };
  RunTiming before;  // nothing
  ChildOutcome outcome{.exit_status = 1};
  if (copy_last_state(run, leg)) {
    outcome = go(whole.simulated_s + length, "--resume");
    if (outcome.exit_status == 0) before = whole;
  }
  if (outcome.exit_status != 0 && StopSignal::received() == 0) outcome = go(length, "--force");
  if (StopSignal::received() != 0) return "interrupted";
  if (outcome.exit_status != 0)
    return fmt::format("failed with exit status {}: {}", outcome.exit_status, last_error_in(leg / k_log_file));
  const RunTiming timed = difference(read_timing(leg), before);
  json page = as_json(timed);
  page["peak_memory_bytes"] = outcome.peak_memory_bytes;
  write_whole_file(leg / k_leg_file, page.dump(2) + "\n");
  return fmt::format("{:.3g} s for {:.3g} s of the bed's time{}", timed.wall_s, timed.simulated_s,
                     before.simulated_s > 0 ? " after its end" : " from its start");
}

std::optional<Leg> read_leg(const fs::path& run, const fs::path& leg) {
  std::ifstream stream(leg / k_leg_file);
  const json page = json::parse(stream, nullptr, false);
  if (page.is_discarded() || !case_differences(read_manifest(leg).identity, read_manifest(run).identity).empty()) return {};
  Leg timed{.simulated_s = 0, .peak_memory_bytes = page.at("peak_memory_bytes").get<double>(), .whole_run = read_timing_file(leg / k_leg_file)};
  RunTiming& whole = timed.whole_run;
  timed.simulated_s = whole.simulated_s;
  const RunTiming finished = read_timing(run);
  const double longer = finished.simulated_s / timed.simulated_s;
  whole.wall_s *= longer;
  whole.simulated_s = finished.simulated_s;
  whole.particle_steps = finished.particle_steps;
  for (RunTiming::Stage& stage : whole.stages) stage.seconds *= longer;
  return timed;
}

}  // namespace similitude
