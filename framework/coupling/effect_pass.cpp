#include "coupling/effect_pass.h"

#include <omp.h>

#include <algorithm>
#include <cstddef>

#include "coupling/block_failure.h"
#include "coupling/seen_by_gas.h"
#include "fluid/staggered.h"
#include "particles/contact_effects.h"

namespace similitude {
namespace {

constexpr std::size_t k_block_rows = 256;
static_assert(k_block_rows % SIMILITUDE_ROW_MULTIPLE == 0);

enum ColumnOfBlock : std::size_t {
  k_diameter, k_mass, k_vx, k_vy, k_vz, k_ux, k_uy, k_uz, k_fraction, k_density, k_viscosity, k_fx, k_fy, k_fz, k_linear,
  k_always_columns,   // those below only of effects that read or add them
  k_spin = k_always_columns, k_vorticity = k_spin + 3, k_acceleration = k_vorticity + 3, k_added_mass = k_acceleration + 3, k_columns
};

}  // namespace

EffectPass::EffectPass(const ModelScene& scene, const Grid& grid, const EffectModel& effect, const GasMotion* motion)
    : map_(grid), effect_(effect), motion_(motion), needs_(needs_of(effect)), classes_(scene.particles), gas_density_(scene.gas_density), gas_viscosity_(scene.gas_viscosity),
      fraction_(map_.cell_count()) {
  workspaces_.resize(static_cast<std::size_t>(omp_get_max_threads()));
  for (auto& workspace : workspaces_) workspace.resize((needs_.reads || needs_.adds ? k_columns : k_always_columns) * k_block_rows);
}

void EffectPass::apply_block(std::size_t block, ParticleStore& particles, double gas_dt, Column<double>& workspace,
                             similitude_status& status) const {
  const auto column = [&](std::size_t which) { return workspace.data() + which * k_block_rows; };
  const std::size_t first = block * k_block_rows;
  const std::size_t rows = std::min(k_block_rows, particles.size() - first);
  const std::size_t padded = (rows + SIMILITUDE_ROW_MULTIPLE - 1) / SIMILITUDE_ROW_MULTIPLE * SIMILITUDE_ROW_MULTIPLE;

  const bool spin = (needs_.reads & SIMILITUDE_READS_ANGULAR_VELOCITY) != 0;
  const bool turns = (needs_.reads & SIMILITUDE_READS_GAS_VORTICITY) != 0;
  const bool accelerates = (needs_.reads & SIMILITUDE_READS_GAS_ACCELERATION) != 0;
  const bool adds_mass = (needs_.adds & SIMILITUDE_ADDS_ADDED_MASS) != 0;
  const auto put = [&](std::size_t which, std::size_t n, const Row& row) {
    column(which)[n] = row.x;
    column(which + 1)[n] = row.y;
    column(which + 2)[n] = row.z;
  };
  for (std::size_t n = 0; n < padded; ++n) {
    const std::size_t p = first + std::min(n, rows - 1);   // padding repeats the last particle
    const ParticleClass& type = classes_[particles.species[p]];
    column(k_diameter)[n] = drag_diameter(type, particles, p);
    column(k_mass)[n] = physical_mass(type, particles, p);
    column(k_vx)[n] = particles.velocity[p].x;
    column(k_vy)[n] = particles.velocity[p].y;
    column(k_vz)[n] = particles.velocity[p].z;
    column(k_ux)[n] = particles.gas[p].x;
    column(k_uy)[n] = particles.gas[p].y;
    column(k_uz)[n] = particles.gas[p].z;
    const Stencil stencil = map_.stencil(particles.position[p]);
    column(k_fraction)[n] = gather(stencil, fraction_).w;
    if (spin) put(k_spin, n, particles.angular_velocity[p]);
    if (turns) put(k_vorticity, n, gather(stencil, motion_->vorticity_in_cells()));
    if (accelerates) put(k_acceleration, n, gather(stencil, motion_->acceleration_in_cells()));
    if (adds_mass) column(k_added_mass)[n] = 0;
    column(k_density)[n] = gas_density_;
    column(k_viscosity)[n] = gas_viscosity_;
    column(k_fx)[n] = column(k_fy)[n] = column(k_fz)[n] = column(k_linear)[n] = 0;
  }

  const auto vector = [&](bool wanted, std::size_t which, std::size_t axis) { return wanted ? column(which + axis) : nullptr; };
  const similitude_particle_block view{.struct_size = sizeof(similitude_particle_block),
                                       .rows = static_cast<std::uint32_t>(padded),
                                       .dt = gas_dt,
                                       .diameter = column(k_diameter),
                                       .mass = column(k_mass),
                                       .velocity = {column(k_vx), column(k_vy), column(k_vz)},
                                       .gas_velocity = {column(k_ux), column(k_uy), column(k_uz)},
                                       .gas_fraction = column(k_fraction),
                                       .gas_density = column(k_density),
                                       .gas_viscosity = column(k_viscosity),
                                       .angular_velocity = {vector(spin, k_spin, 0), vector(spin, k_spin, 1), vector(spin, k_spin, 2)},
                                       .gas_vorticity = {vector(turns, k_vorticity, 0), vector(turns, k_vorticity, 1),
                                                         vector(turns, k_vorticity, 2)},
                                       .gas_acceleration = {vector(accelerates, k_acceleration, 0), vector(accelerates, k_acceleration, 1),
                                                            vector(accelerates, k_acceleration, 2)},
                                       .force = {column(k_fx), column(k_fy), column(k_fz)},
                                       .linear_coefficient = column(k_linear),
                                       .added_mass = adds_mass ? column(k_added_mass) : nullptr};
  effect_.functions().particles(effect_.instance(), &view, &status);
  if (status.code != 0) return;

  for (std::size_t n = 0; n < rows; ++n) {
    const std::size_t p = first + n;
    const double weight = classes_[particles.species[p]].weight;
    const Row force{weight * column(k_fx)[n], weight * column(k_fy)[n], weight * column(k_fz)[n], 0};
    particles.gas[p].w += weight * column(k_linear)[n];
    if (adds_mass) particles.added_mass[p] += weight * column(k_added_mass)[n];
    particles.stress_force[p].x += force.x;
    particles.stress_force[p].y += force.y;
    particles.stress_force[p].z += force.z;
    particles.drag_impulse[p].x += force.x * gas_dt;
    particles.drag_impulse[p].y += force.y * gas_dt;
    particles.drag_impulse[p].z += force.z * gas_dt;
  }
}

void EffectPass::apply(ParticleStore& particles, const Column<double>& gas_fraction, double gas_dt) {
#pragma omp parallel for schedule(static) if (static_cast<Index>(fraction_.size()) >= k_worth_threads)
  for (std::ptrdiff_t c = 0; c < static_cast<std::ptrdiff_t>(fraction_.size()); ++c) {
    fraction_[static_cast<std::size_t>(c)].w = gas_fraction[static_cast<std::size_t>(c)];
  }
  const std::size_t blocks = (particles.size() + k_block_rows - 1) / k_block_rows;
  BlockFailure failure;
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks); ++b) {
    const auto block = static_cast<std::size_t>(b);
    similitude_status status{};
    apply_block(block, particles, gas_dt, workspaces_[static_cast<std::size_t>(omp_get_thread_num())], status);
    failure.tell(block, status);
  }
  if (failure) throw_failure(effect_, failure.status());
}

}  // namespace similitude
