#pragma once
/// Runs what a plan says and judges what the runs left behind.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/cost.h"
#include "study/frontier.h"
#include "study/study_plan.h"

namespace similitude {

struct StudyCase {
  std::string name;
  bool reference = false;
  bool done = false;
  std::string status, reason;  // of the manifest; "not run" without one; `reason` in words if not done
  std::int64_t particles = 0;
  RunTiming timing;              // of the first run; wall_s is the median of the repeats
  std::vector<double> repeats;   // [s], wall times
  double extrapolated_from = 0;  // [s] of the real bed: wall_s was timed over so long only; 0: over all
  double wall_s = Estimate::k_unknown;
  double peak_memory_bytes = Estimate::k_unknown;
  Prediction predicted;
  std::string state_hash;
  std::vector<MetricResult> results;  // in the order of the study's metrics
  std::vector<Profile> profiles;
  bool pareto = false;
};

struct StudyOrder {
  std::string axis, metric;
  std::vector<std::string> cases;  // the coarsest first
  Estimate order;
};

struct StudyResult {
  std::vector<StudyCase> cases;  // the plan's; a stored run as reference comes last
  Machine machine;
  Frontier frontier;                                                                // of the first metric
  std::vector<std::vector<std::pair<std::string, std::string>>> indistinguishable;  // per metric
  std::vector<StudyOrder> orders;
  std::string advice;
};

/// Is there something of a study in the folder?
bool holds_a_study(const std::filesystem::path& folder, const StudyPlan& plan);

/// Runs every case that is not finished, one after the other, each in its folder. `say` gets a line per case. Returns
/// 0, or 130/143 if a signal came: then the rest was not run. Throws OutputError, and InputError before anything is run if a
/// case's folder holds a run of another case that is worth keeping.
int run_cases(const StudyPlan& plan, const Catalogue& catalogue, const std::filesystem::path& folder,
              const std::function<void(const std::string&)>& say);

/// From files alone: called again it says the same.
StudyResult evaluate(const StudyPlan& plan, const std::filesystem::path& folder);

/// study.json and study.csv. Throws OutputError.
void write_study(const StudyPlan& plan, const StudyResult& result, const std::filesystem::path& folder);

}  // namespace similitude
