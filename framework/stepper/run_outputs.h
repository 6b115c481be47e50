#pragma once
/// Everything a run writes while it runs. Looks at the simulation, never touches it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "output/directory.h"
#include "output/manifest.h"
#include "output/monitors.h"
#include "output/probes.h"
#include "output/profiles.h"
#include "output/vtk_writer.h"
#include "stepper/simulation.h"

namespace similitude {

/// Counts off multiples of an interval, so that rounding never skips or doubles one.
class Schedule {
 public:
  /// `every` [s]; 0 or less: never due.
  Schedule(double every, double from) : every_(every), from_(from) {}
  /// Is a multiple of the interval reached that was not served yet? Serves all up to `time`.
  bool due(double time);

 private:
  double every_, from_;
  std::int64_t served_ = 0;
};

class RunOutputs {
 public:
  RunOutputs(const OutputDirectory& directory, const Assembly& assembly);

  /// Before the first step and after every step.
  void observe(const Simulation& simulation);
  /// After the last step: the last frame if it is not there yet, and profiles.csv.
  void finish(const Simulation& simulation);

  const ProfileSampler& profiles() const { return profiles_; }
  double largest_overlap_of_run() const { return largest_overlap_of_run_; }

 private:
  void write_frame(const Simulation& simulation);
  void write_monitors(const Simulation& simulation);

  const OutputDirectory& directory_;
  const Assembly& assembly_;
  MapBack map_back_;
  std::optional<VtkWriter> vtk_;
  MonitorFile monitors_;
  std::optional<ProbeFile> probes_;
  ProfileSampler profiles_;
  Schedule vtk_schedule_, monitor_schedule_, profile_schedule_;
  double last_frame_time_ = -1;
  double largest_overlap_ = 0, largest_overlap_of_run_ = 0;
};

}  // namespace similitude
