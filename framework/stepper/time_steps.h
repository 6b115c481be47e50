#pragma once
/// Every limit on the time steps, advised and hard, and the steps that are taken.

#include <cstdint>
#include <string>
#include <vector>

#include "stepper/assembly.h"

namespace similitude {

enum class StepKind { particles, gas };

/// One limit, in the simulated bed's time.
struct TimeStepLimit {
  std::string name;
  std::string because;   // of the advised step
  StepKind kind = StepKind::particles;
  double advised = 0;    // [s], `auto` stays at or below
  double hard = 0;       // [s], beyond it a run is refused; infinite where only accuracy suffers
  bool binding = false;  // it decided its step
  std::string hard_because = {};   // of the hard step; empty where there is none
};

/// In the simulated bed's time. The gas step is a whole number of DEM sub-steps.
struct TimeSteps {
  double dt = 0;                   // [s], DEM sub-step
  std::int64_t sub_steps = 1;      // per gas step
  double gas_dt() const { return dt * static_cast<double>(sub_steps); }
  /// That reach `end` [s]; a last step that rounding alone asks for is left out.
  std::int64_t gas_steps_until(double end) const;
  std::vector<TimeStepLimit> limits;
  std::vector<std::string> warnings;
};

/// Takes the case's steps or the advised ones. Throws InputError for a step beyond a hard limit, saying what fits.
TimeSteps choose_time_steps(const Assembly& assembly);

}  // namespace similitude
