#pragma once
/// What stops a run, or warns, when the numbers leave the range in which they mean something.

#include <functional>
#include <string>

#include "coupling/coupling.h"
#include "particles/engine.h"
#include "similarity/ratios.h"

namespace similitude {

class Guards {
 public:
  /// `courant_limits` false: a gas that is not advected may cross any number of cells in a step.
  Guards(const ResultRatios& ratios, std::function<void(const std::string&)> warn, bool courant_limits = true)
      : ratios_(ratios), warn_(std::move(warn)), courant_limits_(courant_limits) {}

  /// After the DEM sub-steps. `time` in the simulated bed's seconds. Throws SimulationError.
  void check_particles(const EngineReport& report, double time);
  /// After the gas step.
  void check_gas(const similitude_gas_report& report, const similitude_status& status, double time);
  void check_gas_fraction(double smallest, std::array<double, 3> place, double time);

 private:
  void warn_once(bool& said, const std::string& text);

  ResultRatios ratios_;
  std::function<void(const std::string&)> warn_;
  bool courant_limits_;
  bool said_overlap_ = false, said_courant_ = false, said_mass_ = false;
};

}  // namespace similitude
