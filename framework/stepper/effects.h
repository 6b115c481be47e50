#pragma once
/// Which effects a case has: what `auto` means for its bed, what effects take from other models and which of them they need
/// or cannot stand, and what each says of its own relevance.

#include <span>
#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "scene/scene.h"

namespace similitude {

/// An effect's judgement of a bed, in words and numbers.
struct EffectVerdict {
  std::string id, group, source, because;
  std::string species;                  // the class of particles that decides; empty where all say the same
  double value = 0, threshold = 0;      // NaN: not known
  double lowest = 0, highest = 0;       // the range that the value may have
  int verdict = -1;                     // 1 needed, 0 negligible, -1 cannot tell
  bool chosen = false;                  // the run has it
  double predicted_wall_s = 0;          // [s], what it adds, or would add, to a run; NaN: not predicted
};

/// An effect with all its parameters left out.
ModelChoice effect_with_defaults(const PluginEntry& effect);

/// `effects: []` asks for none, and for no judgement either.
inline bool asks_for_effects(const RealScene& scene) { return scene.models.effects_auto || !scene.models.effects.empty(); }

/// In the real bed, before it is scaled: `effects: auto` becomes the list of those whose verdict is that they are needed, and
/// parameters left out that another model has are taken from there. Throws InputError if an effect needs one value and the pairs
/// and partners of the contact law have several. [setup]
void choose_effects(RealScene& scene, const Catalogue& catalogue);

/// "models.effects: [heat, cohesion]", to write in place of `auto`.
std::string written_list(const std::vector<std::string>& ids);

/// With `effects: auto`, once effects are chosen: a warning for each that was left out although the scene gives values which only
/// it would use, with its verdict. [setup]
std::vector<std::string> idle_value_warnings(const RealScene& scene, const Catalogue& catalogue);

/// "{id: cohesion, model: van_der_waals, hamaker: 6.5e-20 J}": an effect with its defaults as a case would write it, less what it
/// takes from other models.
std::string with_its_defaults(const similitude_descriptor& effect);

/// Throws InputError if an effect lacks a partner or meets a model that it conflicts with, saying what to add or leave out. [setup]
void check_partners(const RealScene& scene, std::span<const EffectModel> effects);

/// Every effect of the catalogue on this bed, with the case's parameters where it lists it, else with its defaults. Each class of
/// particles is asked for; the one most in need decides. `occurred`: what a run saw, or null. [setup][main]
std::vector<EffectVerdict> judge_effects(const RealScene& scene, const Catalogue& catalogue, const similitude_occurred* occurred);

}  // namespace similitude
