#include "coupling/contact_flows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/block_failure.h"
#include "particles/contact_effects.h"
#include "particles/contact_lists.h"

namespace similitude {
namespace {

constexpr std::size_t k_rows = 64;
constexpr std::uint32_t k_wall = ~std::uint32_t{0};

bool has_flow(const EffectModel& effect) {
  return effect.functions().contacts != nullptr && (needs_of(effect).adds & SIMILITUDE_ADDS_FLOW) != 0;
}

}  // namespace

struct ContactFlows::Block {
  using Numbers = double[k_rows];
  alignas(64) Numbers normal[3], overlap, velocity[3], radius_i, radius_j, effective_mass, law_force[3];
  alignas(64) Numbers value_i[SIMILITUDE_MAX_QUANTITIES], value_j[SIMILITUDE_MAX_QUANTITIES], flow[SIMILITUDE_MAX_QUANTITIES];
  std::uint32_t owner[k_rows], partner[k_rows];
  std::size_t count = 0;
};

bool ContactFlows::wanted(const ScalarPlan& plan) {
  return std::any_of(plan.effects.begin(), plan.effects.end(), [](const EffectQuantities& one) { return has_flow(*one.effect); });
}

ContactFlows::ContactFlows(const ModelScene& scene, const ScalarPlan& plan)
    : scene_(scene), plan_(plan), surfaces_(scene), received_(plan.particles.size()), from_walls_(plan.particles.size(), 0.0) {}

/// One contact as the block's next row; false if nothing can flow: a plate, or partners that have parted since they were listed.
bool ContactFlows::gather(Block& b, const ParticleStore& particles, std::uint32_t owner, std::uint32_t partner) const {
  const std::size_t n = b.count;
  const Row &x = particles.position[owner], &v = particles.velocity[owner];
  const bool wall = (partner & ContactLists::k_surface_key) != 0;
  if (wall) {
    const std::uint32_t surface = partner & ~ContactLists::k_surface_key;
    SurfaceTouch touch;
    if (surfaces_.is_baffle(surface) || !surfaces_.nearest(surface, x, touch)) return false;   // plates are closed, for the gas's scalars too
    b.overlap[n] = x.w - touch.distance;
    for (std::size_t axis = 0; axis < 3; ++axis) b.normal[axis][n] = touch.normal[axis];
    b.radius_j[n] = std::numeric_limits<double>::infinity();
    b.effective_mass[n] = v.w;
    const double speed[3] = {v.x, v.y, v.z};
    for (std::size_t axis = 0; axis < 3; ++axis) b.velocity[axis][n] = speed[axis];
  } else {
    const Row &y = particles.position[partner], &w = particles.velocity[partner];
    double apart[3] = {x.x - y.x, x.y - y.y, x.z - y.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (scene_.periodic[axis]) apart[axis] -= scene_.size[axis] * std::round(apart[axis] / scene_.size[axis]);
    }
    const double distance = std::sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]);
    b.overlap[n] = x.w + y.w - distance;
    for (std::size_t axis = 0; axis < 3; ++axis) b.normal[axis][n] = apart[axis] / distance;
    b.radius_j[n] = y.w;
    b.effective_mass[n] = v.w * w.w / (v.w + w.w);
    const double speed[3] = {v.x - w.x, v.y - w.y, v.z - w.z};
    for (std::size_t axis = 0; axis < 3; ++axis) b.velocity[axis][n] = speed[axis];
  }
  if (!(b.overlap[n] > 0)) return false;
  b.radius_i[n] = x.w;
  b.owner[n] = owner;
  b.partner[n] = wall ? k_wall : partner;
  ++b.count;
  return true;
}

void ContactFlows::call(Block& b, const EffectQuantities& effect, const ParticleStore& particles, double dt) {
  if (b.count == 0) return;
  const std::size_t quantities = effect.kind.size();
  const std::size_t padded = (b.count + SIMILITUDE_ROW_MULTIPLE - 1) / SIMILITUDE_ROW_MULTIPLE * SIMILITUDE_ROW_MULTIPLE;
  for (std::size_t n = b.count; n < padded; ++n) {   // padding repeats the last contact
    const std::size_t last = b.count - 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      b.normal[axis][n] = b.normal[axis][last];
      b.velocity[axis][n] = b.velocity[axis][last];
    }
    b.overlap[n] = b.overlap[last];
    b.radius_i[n] = b.radius_i[last];
    b.radius_j[n] = b.radius_j[last];
    b.effective_mass[n] = b.effective_mass[last];
    b.owner[n] = b.owner[last];
    b.partner[n] = b.partner[last];
  }
  for (auto& column : b.law_force) std::fill_n(column, padded, 0.0);

  std::array<const double*, SIMILITUDE_MAX_QUANTITIES> value_i{}, value_j{};
  std::array<double*, SIMILITUDE_MAX_QUANTITIES> flow{};
  for (std::size_t q = 0; q < quantities; ++q) {
    const bool scalar = effect.kind[q] == SIMILITUDE_PARTICLE_SCALAR && effect.slot[q] >= 0;
    const bool property = !effect.by_class[q].empty();
    if (!scalar && !property) continue;
    const auto of_row = [&](std::uint32_t row) {
      if (row == k_wall) return effect.wall[q];
      return scalar ? particles.scalars[static_cast<std::size_t>(effect.slot[q])].value[row] : effect.by_class[q][particles.species[row]];
    };
    for (std::size_t n = 0; n < padded; ++n) {
      b.value_i[q][n] = of_row(b.owner[n]);
      b.value_j[q][n] = of_row(b.partner[n]);
    }
    value_i[q] = b.value_i[q];
    value_j[q] = b.value_j[q];
    if (!scalar) continue;
    std::fill_n(b.flow[q], padded, 0.0);
    flow[q] = b.flow[q];
  }
  similitude_contact_effect_block view{};
  view.struct_size = sizeof view;
  view.rows = static_cast<std::uint32_t>(padded);
  view.dt = dt;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    view.normal[axis] = b.normal[axis];
    view.velocity[axis] = b.velocity[axis];
    view.law_force[axis] = b.law_force[axis];
  }
  view.overlap = b.overlap;
  view.radius_i = b.radius_i;
  view.radius_j = b.radius_j;
  view.effective_mass = b.effective_mass;
  view.value_i = value_i.data();
  view.value_j = value_j.data();
  view.flow = flow.data();
  similitude_status status{};
  effect.effect->functions().contacts(effect.effect->instance(), &view, &status);
  if (status.code != 0) throw_failure(*effect.effect, status);
  for (std::size_t q = 0; q < quantities; ++q) {
    if (flow[q] == nullptr) continue;
    const auto slot = static_cast<std::size_t>(effect.slot[q]);
    for (std::size_t n = 0; n < b.count; ++n) {
      const double amount = dt * b.flow[q][n];
      received_[slot][b.owner[n]] += amount;
      if (b.partner[n] == k_wall) {
        from_walls_[slot] += amount;
      } else {
        received_[slot][b.partner[n]] -= amount;
      }
    }
  }
}

void ContactFlows::apply(ParticleStore& particles, const TouchingContacts& touching, double dt) {
  for (Column<double>& column : received_) column.assign(particles.size(), 0.0);
  Block block;
  for (const EffectQuantities& effect : plan_.effects) {
    if (!has_flow(*effect.effect)) continue;
    for (std::size_t k = 0; k < touching.owner.size(); ++k) {
      gather(block, particles, touching.owner[k], touching.partner[k]);
      if (block.count < k_rows && k + 1 < touching.owner.size()) continue;
      call(block, effect, particles, dt);
      block.count = 0;
    }
  }
  for (std::size_t s = 0; s < received_.size(); ++s) {
    const std::vector<double>& capacity = plan_.particles[s].capacity;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      particles.scalars[s].value[p] += received_[s][p] / (particles.velocity[p].w * capacity[particles.species[p]]);
    }
  }
}

}  // namespace similitude
