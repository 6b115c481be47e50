#pragma once
/// What a run left in its folder, as far as a study asks.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "output/manifest.h"
#include "study/estimate.h"
#include "study/profile_error.h"

namespace similitude {

struct RunTiming {
  struct Stage {
    std::string name;
    double seconds = 0, share = 0;
  };
  double wall_s = 0, simulated_s = 0;  // [s]
  double particle_steps = 0, particle_steps_per_s = 0;
  std::vector<Stage> stages;
};

struct RunManifest {
  std::string status, exit_reason, state_hash;
  std::int64_t particles = 0;
  CaseIdentity identity;
  double simulated_s = 0, end = 0;  // [s] of the real bed: reached, and of the case
  Machine machine;
  int threads = 0;
  bool at_one_go = true;  // not in parts, which may be of several machines
  bool done() const { return status == "done"; }
};

/// Everything that metrics are taken from.
struct Observations {
  std::vector<Profile> profiles;           // by sampler
  std::map<std::string, Series> monitors;  // by column, after start-up
  std::map<std::string, double> largest;   // by column, largest magnitude of the whole run
  std::map<std::string, Estimate> given;   // measured data: by metric

  const Profile* profile(const std::string& sampler) const;
};

bool has_manifest(const std::filesystem::path& folder);
/// All throw InputError if a file is missing or not as a run writes it.
RunManifest read_manifest(const std::filesystem::path& folder);
RunTiming read_timing(const std::filesystem::path& folder);
RunTiming read_timing_file(const std::filesystem::path& file);
/// `from` [s]: the monitors' averages start there; profiles were averaged by the run.
Observations read_observations(const std::filesystem::path& folder, double from);
/// Measured data: sampler, x, z, mean and, if known, standard error. A row without x and z gives a metric by its name.
Observations read_measured(const std::filesystem::path& file);

}  // namespace similitude
