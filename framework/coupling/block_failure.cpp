#include "coupling/block_failure.h"

#include <string>

#include "particles/errors.h"

namespace similitude {

void BlockFailure::tell(std::size_t block, const similitude_status& status) {
  if (status.code == 0) return;
#pragma omp critical(similitude_block_failure)
  if (block < block_) {
    block_ = block;
    status_ = status;
  }
}

void throw_failure(const EffectModel& effect, const similitude_status& status) {
  throw SimulationError(std::string("the effect \"") + effect.descriptor().id + "\" failed: " + status.text,
                        "Leave it out of models.effects, or ask its author.");
}

}  // namespace similitude
