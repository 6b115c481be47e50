#pragma once
#include <string>

#include "stepper/assembly.h"
#include "stepper/time_steps.h"

namespace similitude {

/// Wall seconds that an effect adds to the whole run: its contact pass by the difference of sub-steps with and without it, all that it
/// does between them by the clocks of the step's stages, on a small packing and the best of a few repetitions. What it costs the
/// gas solver is not counted. Throws what `assemble` throws.
double effect_price(const RealScene& scene, const TimeSteps& steps, const Catalogue& catalogue, const std::string& id);

}  // namespace similitude
