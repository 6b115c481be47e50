#pragma once
/// What flows through contacts: heat between touching particles and from walls. Once per gas step, through the contacts that
/// touch at its end and over its whole length: temperatures of particles change in seconds, and a contact shorter than a gas
/// step is met as often as its length says. What one partner gives the other receives, to rounding.

#include <array>
#include <vector>

#include "coupling/scalar_plan.h"
#include "particles/store.h"
#include "particles/surfaces.h"
#include "particles/touching_contacts.h"

namespace similitude {

class ContactFlows {
 public:
  /// Scene and plan, with its effects, outlive this.
  ContactFlows(const ModelScene& scene, const ScalarPlan& plan);

  /// Whether some effect of the plan has flows.
  static bool wanted(const ScalarPlan& plan);
  /// Particle scalars after `dt` [s]. Throws SimulationError with an effect's own words. [main]
  void apply(ParticleStore& particles, const TouchingContacts& touching, double dt);

  /// By particle scalar, since the start: amount that walls gave.
  const std::vector<double>& from_walls() const { return from_walls_; }
  void set_from_walls(const std::vector<double>& amounts) { from_walls_ = amounts; }

 private:
  struct Block;
  bool gather(Block& block, const ParticleStore& particles, std::uint32_t owner, std::uint32_t partner) const;
  void call(Block& block, const EffectQuantities& effect, const ParticleStore& particles, double dt);

  const ModelScene& scene_;
  const ScalarPlan& plan_;
  Surfaces surfaces_;
  std::vector<Column<double>> received_;   // by particle scalar, rows
  std::vector<double> from_walls_;
};

}  // namespace similitude
