#pragma once
/// Everything a run writes while it runs. Looks at the simulation, never touches it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "output/directory.h"
#include "output/front_view.h"
#include "output/manifest.h"
#include "output/monitors.h"
#include "output/probes.h"
#include "output/profiles.h"
#include "output/run_state.h"
#include "output/scalar_file.h"
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
  /// Nothing up to `time` is due any more: it was served before a restart.
  void pass(double time) { due(time); }

 private:
  double every_, from_;
  std::int64_t served_ = 0;
};

class RunOutputs {
 public:
  RunOutputs(const OutputDirectory& directory, const Assembly& assembly);
  /// Goes on where the files of an earlier run were at `time` [s, simulated]; what they hold beyond is cut off.
  RunOutputs(const OutputDirectory& directory, const Assembly& assembly, const OutputsState& state, double time);
  void save(OutputsState& state) const;

  /// Before the first step and after every step.
  void observe(const Simulation& simulation);
  /// After the last step: the last frame if it is not there yet, and profiles.csv.
  void finish(const Simulation& simulation);

  /// [s] that everything this run writes will take, from writing each kind once now. For a folder that is thrown away.
  double seconds_to_the_end(const Simulation& simulation);

  const ProfileSampler& profiles() const { return profiles_; }
  /// Does the last frame show this instant [s, simulated]?
  bool shows(double time) const { return draws() && last_frame_time_ == time; }
  double largest_overlap_of_run() const { return largest_overlap_of_run_; }

 private:
  void write_frame(const Simulation& simulation);
  void write_monitors(const Simulation& simulation);
  void write_scalars(const Simulation& simulation);

  RunOutputs(const OutputDirectory& directory, const Assembly& assembly, const OutputsState* state, std::optional<double> time);
  bool draws() const { return assembly_.model.output.vtk_every > 0; }

  const OutputDirectory& directory_;
  const Assembly& assembly_;
  MapBack map_back_;
  VtkWriter vtk_;
  MonitorFile monitors_;
  std::optional<ProbeFile> probes_;
  std::optional<ScalarFile> scalars_;
  ProfileSampler profiles_;
  FrontView front_view_;
  Schedule front_view_schedule_, vtk_schedule_, monitor_schedule_, profile_schedule_;
  double last_frame_time_ = -1;
  double largest_overlap_ = 0, largest_overlap_of_run_ = 0;
};

}  // namespace similitude
