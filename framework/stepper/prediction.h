#pragma once
/// What a case will cost, from a short calibration: its own bed, models and outputs, for a second or so.

#include <cstdint>
#include <string>
#include <vector>

#include "particles/engine.h"
#include "stepper/assembly.h"
#include "stepper/time_steps.h"

namespace similitude {

struct PredictedCost {
  int threads = 0;                   // of the calibration
  std::int64_t particles = 0;        // simulated
  double particle_steps = 0;         // to the case's end
  double wall_s = 0;                 // [s], of the time loop, as timing.json has it; NaN with a gap
  std::vector<StageTime> stages;     // of the whole run, named as in timing.json
  std::string gap;                   // why there is no wall time
  // Of the calibration:
  double particle_steps_per_s = 0;   // [1/s], of the particles' stages alone; 0 without particles
  double gas_step_s = 0;             // [s], of what a gas step takes for its cells
  double exchange_s = 0;             // [s], of what a gas step takes for one particle: deposit, interpolation, effects
};

/// Runs the first steps of the case from its settled bed if that is in the cache or small, from a lattice otherwise, for
/// `k_calibration_s`, at least two gas steps; every kind of output is written once to a temporary folder. Uses the
/// threads that OpenMP is set to. A calibration that fails is a gap, not an error.
inline constexpr double k_calibration_s = 1.5;
PredictedCost predict_cost(const Assembly& assembly, const TimeSteps& steps);

/// For all predictions that follow; 0: all cores, as a run takes them.
void predict_with_threads(int threads);

}  // namespace similitude
