#pragma once
/// What a case cost on this machine: cost.json in the folder of its run.

#include <filesystem>
#include <string>
#include <vector>

#include "study/estimate.h"
#include "study/run_files.h"

namespace similitude {

/// What a calibration before the run said it would cost.
struct Prediction {
  double wall_s = Estimate::k_unknown, particle_steps = Estimate::k_unknown;
  std::vector<RunTiming::Stage> stages;  // of the whole run; shares are not set
  std::string gap = "not predicted";     // why there is none
  bool known() const { return gap.empty(); }
};

/// The stage whose time was foretold worst, by seconds, with both times: "fluid: vans 3 s, measured 5 s"; "" if nothing
/// was foretold.
std::string farthest_off(const Prediction& predicted, const RunTiming& measured);

/// What no file of a run says: how often it was timed, its memory, and what was foretold.
struct Cost {
  std::vector<double> repeats;  // [s], wall times; empty: not known
  double peak_memory_bytes = Estimate::k_unknown;
  Prediction predicted;
};

/// With the name of this machine. Throws OutputError.
void write_cost(const std::filesystem::path& folder, const Cost& cost);
/// Without times if the file is not there, as after a kill at the run's very end.
Cost read_cost(const std::filesystem::path& folder);
/// Before a run is made anew.
void remove_cost(const std::filesystem::path& folder);
/// Was the run's last part made on this machine?
bool made_here(const RunManifest& manifest);
/// Was the finished run timed from start to end on this machine?
bool timed_here(const std::filesystem::path& folder);

}  // namespace similitude
