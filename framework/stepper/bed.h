#pragma once
#include <functional>
#include <string>

#include "particles/fill.h"
#include "particles/store.h"
#include "stepper/assembly.h"
#include "stepper/time_steps.h"

namespace similitude {

struct StartingBed {
  ParticleStore particles;
  FilledBed filled;
};

/// The rows a run of these models needs, filled with the scene's bed at rest.
StoreFields store_fields(const Assembly& assembly);
/// `progress` may be empty. Throws Interrupted if a signal that StopSignal catches comes while the bed settles.
StartingBed fill_bed(const Assembly& assembly, const TimeSteps& steps,
                     std::function<void(double fraction, const std::string& stage)> progress);

/// Is the scene's settled bed in the cache, so that filling takes no time?
bool settled_bed_is_kept(const Assembly& assembly, const TimeSteps& steps);

}  // namespace similitude
