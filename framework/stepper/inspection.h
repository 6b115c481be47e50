#pragma once
/// What a case will do, said before it does it: pipeline, fields with their bytes and reasons, effects. What it costs: prediction.h.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "stepper/assembly.h"
#include "stepper/effects.h"
#include "stepper/time_steps.h"

namespace similitude {

struct FieldUse {
  std::string name;
  std::size_t bytes_per_item = 0;
  std::size_t items = 0;
  std::string because;
};

/// What the contact parameters of a pair of materials are where pairs differ, as they would be written; of the real bed.
struct PairUse {
  std::string pair;
  std::vector<std::pair<std::string, std::string>> parameters;   // name, value
};

/// Simulated particles that the scene asks for; from the bed's height where it gives no count.
std::int64_t expected_particles(const ModelScene& scene);
std::vector<std::string> pipeline_words(const Assembly& assembly, const TimeSteps& steps);
std::vector<FieldUse> field_uses(const Assembly& assembly);
/// What is doubtful about a bed before its first step, in the order in which it is told.
std::vector<std::string> warnings_of(const Assembly& assembly, const TimeSteps& steps, const Catalogue& catalogue);
/// [bytes], of all fields but the cells'.
double bytes_per_particle(const std::vector<FieldUse>& fields, const Assembly& assembly);
/// Empty if one set of parameters holds for all contacts.
std::vector<PairUse> pair_uses(const Assembly& assembly);
/// Every effect in the catalogue, asked for its relevance in the real bed, with what it adds or would add to the run's wall time
/// by a short calibration of its passes on this machine.
std::vector<EffectVerdict> effect_verdicts(const RealScene& scene, const Assembly& assembly, const TimeSteps& steps,
                                           const Catalogue& catalogue);

}  // namespace similitude
