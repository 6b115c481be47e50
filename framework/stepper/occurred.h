#pragma once
/// What a run sees of the quantities that effects judge by, for a second look at their verdicts when it ends.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <similitude/abi.h>

#include "stepper/effects.h"
#include "stepper/simulation.h"

namespace similitude {

class Occurred {
 public:
  /// Results are of the real bed. The assembly stays alive with this.
  explicit Occurred(const Assembly& assembly) : assembly_(&assembly) {}

  /// Takes the particles and the gas of this instant into account. Changes nothing. [main], between steps
  void observe(const Simulation& simulation);
  /// Lowest, mean and highest over particles and instants since the last start of the run; NaN where nothing was seen.
  similitude_occurred ranges() const;

 private:
  struct Sum {
    double lowest = 0, total = 0, highest = 0;
    std::size_t count = 0;
    void add(double value);
    similitude_range range(double per) const;
  };
  const Assembly* assembly_;
  Sum solids_fraction_, slip_speed_, particle_speed_, angular_speed_, vorticity_, strain_rate_;
};

/// Where the verdict on what occurred is another than that on the scene, or an effect ran that nothing called for: a sentence
/// each, with advice. `before` and `after` are of the same catalogue; `models` those of the case.
std::vector<std::string> second_thoughts(const Models& models, const std::vector<EffectVerdict>& before,
                                         const std::vector<EffectVerdict>& after);

}  // namespace similitude
