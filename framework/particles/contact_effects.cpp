#include "particles/contact_effects.h"

#include <algorithm>
#include <stdexcept>

#include "loader/contact_answers.h"
#include "particles/contact_pass.h"

namespace similitude {

similitude_effect_needs needs_of(const EffectModel& effect) {
  similitude_effect_needs needs{};
  needs.struct_size = sizeof needs;
  if (effect.functions().needs) effect.functions().needs(effect.instance(), &needs);
  return needs;
}

ContactEffects::ContactEffects(const similitude_contact_needs& law, std::span<const EffectModel> all)
    : law_history_(law.history_count), law_couple_(law.couple != 0) {
  memory_.count = law.history_count;
  std::copy_n(law.history_parity, law.history_count, memory_.parity.begin());
  bool flows = false;
  for (const EffectModel& effect : all) {
    const similitude_effect_needs needs = needs_of(effect);
    flows = flows || (needs.adds & SIMILITUDE_ADDS_FLOW) != 0;
    if (!effect.functions().contacts || (needs.adds & SIMILITUDE_ADDS_FLOW_ALONE) != 0) continue;
    if (memory_.count + needs.history_count > k_most_history) {
      throw std::invalid_argument("a contact would have to remember more than " + std::to_string(k_most_history) + " values");
    }
    effects_.push_back({&effect, needs, memory_.count});
    std::copy_n(needs.history_parity, needs.history_count, memory_.parity.begin() + memory_.count);
    memory_.count += needs.history_count;
    rotation_ = rotation_ || (needs.reads & SIMILITUDE_READS_ANGULAR_VELOCITY) != 0;
    couple_ = couple_ || (needs.adds & SIMILITUDE_ADDS_COUPLE) != 0;
  }
  // What flows through contacts asks who touches, right after lists were made anew too: only what is remembered is carried over.
  if (flows && memory_.count == 0) memory_.count = 1;
}

double ContactEffects::reach(double diameter) const {
  double farthest = 0;
  for (const One& effect : effects_) farthest = std::max(farthest, reach_of(*effect.model, diameter));
  return farthest;
}

std::string ContactEffects::names() const {
  std::string names;
  for (const One& effect : effects_) names += (names.empty() ? "" : ", ") + std::string(effect.model->descriptor().id);
  return names;
}

void ContactEffects::before_law(similitude_contact_block& block, BlockColumns& columns, double law_reach) const {
  for (std::uint32_t n = 0; n < block.rows; ++n) columns.law_overlap[n] = std::max(columns.overlap[n], -law_reach);
  block.overlap = columns.law_overlap;
}

void ContactEffects::after_law(const similitude_contact_block& block, BlockColumns& columns, double law_reach,
                               similitude_status& status, const char*& blame) const {
  for (std::uint32_t n = 0; n < block.rows; ++n) {
    if (columns.overlap[n] > -law_reach) continue;
    for (double* force : block.force) force[n] = 0;
    for (std::uint32_t h = 0; h < law_history_; ++h) columns.history[h][n] = 0;
    if (law_couple_) {
      for (double* couple : block.couple) couple[n] = 0;
    }
  }
  similitude_contact_effect_block view{};
  view.struct_size = sizeof view;
  view.rows = block.rows;
  view.dt = block.dt;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy_n(block.force[axis], block.rows, columns.law_force[axis]);
    if (couple_ && !law_couple_) std::fill_n(columns.couple[axis], block.rows, 0.0);
    view.normal[axis] = block.normal[axis];
    view.velocity[axis] = block.velocity[axis];
    view.angular_velocity_i[axis] = block.angular_velocity_i[axis];
    view.angular_velocity_j[axis] = block.angular_velocity_j[axis];
    view.law_force[axis] = columns.law_force[axis];
    view.force[axis] = columns.force[axis];
  }
  view.overlap = columns.overlap;
  view.radius_i = block.radius_i;
  view.radius_j = block.radius_j;
  view.effective_mass = block.effective_mass;
  for (const One& effect : effects_) {
    const bool couples = (effect.needs.adds & SIMILITUDE_ADDS_COUPLE) != 0;
    for (std::size_t axis = 0; axis < 3; ++axis) view.couple[axis] = couples ? columns.couple[axis] : nullptr;
    for (std::uint32_t h = 0; h < SIMILITUDE_MAX_HISTORY; ++h) {
      view.history[h] = h < effect.needs.history_count ? columns.history[effect.first_history + h] : nullptr;
    }
    effect.model->functions().contacts(effect.model->instance(), &view, &status);
    if (status.code != 0) {
      blame = effect.model->descriptor().id;
      return;
    }
  }
}

}  // namespace similitude
