#pragma once
/// All that a run must remember between two gas steps to go on with the same bits, as plain data. What the pipeline builds
/// anew in every step is not in it.

#include <similitude/abi.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "coupling/coupling.h"
#include "coupling/scalar_exchange.h"
#include "output/accounts.h"
#include "output/profiles.h"
#include "output/vtk_writer.h"
#include "particles/engine.h"
#include "particles/store.h"

namespace similitude {

/// Of the simulated bed.
struct SimulationState {
  std::int64_t steps_done = 0;               // gas steps
  ParticleStore particles;
  EngineState engine;
  GasFields gas;
  CouplingState coupling;
  similitude_gas_report gas_report{};        // of the last step
  std::vector<double> fluid;                 // what the fluid plugin says it remembers
  AccountsState accounts;
  std::vector<ScalarTotals> scalar_totals;   // of what effects carry in the gas
  std::vector<double> scalars_from_walls;    // of what they carry in particles
  std::vector<std::uint8_t> warnings_given;  // by the guards, each once in a run
};

/// What the files of the run hold so far. Intervals are not in it: they follow from the time that is reached.
struct OutputsState {
  VtkWriter::Frames frames;
  double last_frame_time = -1;               // [s], simulated
  std::uint64_t monitors_length = 0;         // [bytes] of monitors.csv
  std::uint64_t probes_length = 0;           // [bytes] of probes.csv; 0: there is none
  std::uint64_t scalars_length = 0;          // [bytes] of scalars.csv; 0: there is none
  double largest_overlap = 0;                // [-], since the last row of monitors.csv
  double largest_overlap_of_run = 0;         // [-]
  ProfileSampler::State profiles;
};

struct RunState {
  SimulationState simulation;
  OutputsState outputs;
  double wall_s = 0;                         // [s], of the time loop so far
  std::vector<StageTime> stages;             // so far
};

}  // namespace similitude
