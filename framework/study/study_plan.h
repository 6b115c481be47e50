#pragma once
/// A study whose every case was read, put together and found to fit: nothing of what follows can fail for its input.

#include <optional>
#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "study/run_files.h"
#include "study/study_file.h"

namespace similitude {

struct PlannedCase {
  std::string name;
  std::vector<Setting> settings;       // its own
  std::vector<std::string> overrides;  // all, for --set, the later win
  CaseIdentity identity;
  double from = 0, end = 0;            // [s]: averages begin, the run ends
  double dt = 0;                       // [s] of the real bed, as it will be
  double cell = 0;                     // [m] of the real bed, along x
};

struct StudyPlan {
  StudyFile study;
  std::vector<PlannedCase> cases;
  std::optional<std::size_t> reference_case;  // of `cases`
  std::optional<Observations> outside;        // a stored run's or measured data
  std::optional<RunManifest> stored;          // of the stored run
  std::optional<double> smoothing;  // [m] of the real bed, common to all; empty: each case its own
  std::vector<std::string> warnings;

  std::string reference_name() const;
};

/// Throws InputError, PluginError: places are the study's where a case's value came from there.
StudyPlan plan_study(const StudyFile& study, const Catalogue& catalogue);

}  // namespace similitude
