#pragma once
#include <string>

#include "stepper/assembly.h"
#include "stepper/time_steps.h"

namespace similitude {

/// Wall seconds that an effect adds to the whole run: its contact pass by the difference of sub-steps with and without it, its
/// particle pass by the clock, both on a small packing and the better of a few repetitions. Throws what `assemble` throws.
double effect_price(const RealScene& scene, const TimeSteps& steps, const Catalogue& catalogue, const std::string& id);

}  // namespace similitude
