#pragma once
/// Where the time went: timing.json.

#include <cstdint>
#include <vector>

#include "output/directory.h"
#include "particles/engine.h"

namespace similitude {

struct Timing {
  double wall_s = 0;       // [s], of the time loop
  double simulated_s = 0;  // [s], of the real bed
  std::uint64_t particle_steps = 0;
  std::vector<StageTime> stages;  // what they leave of wall_s is written as stage "other"
};
/// Throws OutputError.
void write_timing(const OutputDirectory& directory, const Timing& timing);

}  // namespace similitude
