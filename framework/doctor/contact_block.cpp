#include "doctor/contact_block.h"

#include <cmath>

#include "doctor/suites.h"
#include "doctor/trial_values.h"

namespace similitude::doctor {

void ContactBlock::Three::set(std::size_t row, const Vector& v) { axis[0][row] = v.x, axis[1][row] = v.y, axis[2][row] = v.z; }

ContactBlock::ContactBlock(const ContactModel& law, std::size_t rows, Edge edge, bool with_pairs)
    : law_(law),
      needs_(needs_of(law)),
      rows_((rows + SIMILITUDE_ROW_MULTIPLE - 1) / SIMILITUDE_ROW_MULTIPLE * SIMILITUDE_ROW_MULTIPLE),
      with_pairs_(with_pairs),
      pair_(rows_, 0) {
  const auto column = [&](const std::string& name) { return GuardedColumn(name, rows_, edge); };
  const auto three = [&](const std::string& name) {
    return Three{{column(name + "[0]"), column(name + "[1]"), column(name + "[2]")}};
  };
  normal_ = three("normal");
  velocity_ = three("velocity");
  spin_i_ = three("angular_velocity_i");
  spin_j_ = three("angular_velocity_j");
  force_ = three("force");
  couple_ = three("couple");
  overlap_ = column("overlap");
  radius_i_ = column("radius_i");
  radius_j_ = column("radius_j");
  effective_mass_ = column("effective_mass");
  for (std::uint32_t h = 0; h < needs_.history_count; ++h) memory_[h] = column("history[" + std::to_string(h) + "]");
}

void ContactBlock::set(std::size_t row, const ContactRow& c) {
  const std::size_t last = row == 0 ? rows_ : row + 1;
  for (std::size_t at = row; at < last; ++at) {
    normal_.set(at, c.normal);
    velocity_.set(at, c.velocity);
    spin_i_.set(at, c.spin_i);
    spin_j_.set(at, c.spin_j);
    overlap_[at] = c.overlap;
    radius_i_[at] = c.radius_i;
    radius_j_[at] = c.radius_j;
    effective_mass_[at] = c.effective_mass;
    pair_[at] = c.pair;
    if (row != 0) break;
  }
}

void ContactBlock::forbid_writing() {
  for (Three* vectors : {&normal_, &velocity_, &spin_i_, &spin_j_})
    for (GuardedColumn& column : vectors->axis) column.forbid_writing();
  for (GuardedColumn* column : {&overlap_, &radius_i_, &radius_j_, &effective_mass_}) column->forbid_writing();
}

void ContactBlock::advance(double dt) {
  similitude_contact_block block{};
  block.struct_size = sizeof block;
  block.rows = static_cast<std::uint32_t>(rows_);
  block.dt = dt;
  for (std::size_t a = 0; a < 3; ++a) {
    block.normal[a] = normal_.axis[a].data();
    block.velocity[a] = velocity_.axis[a].data();
    block.angular_velocity_i[a] = needs_.rotation != 0 ? spin_i_.axis[a].data() : nullptr;
    block.angular_velocity_j[a] = needs_.rotation != 0 ? spin_j_.axis[a].data() : nullptr;
    block.force[a] = force_.axis[a].data();
    block.couple[a] = needs_.couple != 0 ? couple_.axis[a].data() : nullptr;
    for (std::size_t row = 0; row < rows_; ++row) force_.axis[a][row] = std::nan("");   // a row left out is not a number
  }
  block.overlap = overlap_.data();
  block.radius_i = radius_i_.data();
  block.radius_j = radius_j_.data();
  block.effective_mass = effective_mass_.data();
  block.pair = with_pairs_ ? pair_.data() : nullptr;
  for (std::uint32_t h = 0; h < needs_.history_count; ++h) block.history[h] = memory_[h].data();
  similitude_status status{};
  status.row = -1;
  law_.functions().forces(law_.instance(), &block, &status);
  if (status.code != 0) throw Complaint(status);
}

ContactAnswer ContactBlock::answer(std::size_t row) const { return {force_.get(row), couple_.get(row)}; }

Memory ContactBlock::memory(std::size_t row) const {
  Memory memory{};
  for (std::uint32_t h = 0; h < needs_.history_count; ++h) memory[h] = memory_[h][row];
  return memory;
}

void ContactBlock::forget(std::size_t row) {
  for (std::uint32_t h = 0; h < needs_.history_count; ++h) memory_[h][row] = 0;
}

ContactModel made_contact(const PluginEntry& plugin) {
  return create_model<similitude_contact_functions>(plugin, trial_bed(), trial_values(*plugin.descriptor));
}

similitude_contact_needs needs_of(const ContactModel& law) {
  similitude_contact_needs needs{};
  needs.struct_size = sizeof needs;
  law.functions().needs(law.instance(), &needs);
  return needs;
}

double reach_of(const ContactModel& law, double diameter) {
  return law.functions().reach != nullptr ? law.functions().reach(law.instance(), diameter) : 0;
}

}  // namespace similitude::doctor
