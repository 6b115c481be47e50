#pragma once
/// A fingerprint of the boundary's layout: where every field lies that existed in <major>.0. Plugin and host compute it
/// from their own headers at compile time; the loader compares. Fields appended by a minor release are guarded by
/// struct_size and stay out of the list below.

#include <cstddef>
#include <cstdint>

#include <similitude/abi.h>

namespace similitude::abi {

/// Fowler, Noll and Vo's hash (FNV-1a), 32 bits.
class Fingerprint {
 public:
  constexpr void add(std::size_t number) {
    for (int byte = 0; byte < 4; ++byte) {
      value_ ^= static_cast<std::uint32_t>(number >> (8 * byte)) & 0xffu;
      value_ *= 16777619u;
    }
  }
  constexpr void add(std::size_t offset, std::size_t size) {
    add(offset);
    add(size);
  }
  constexpr std::uint32_t value() const { return value_; }

 private:
  std::uint32_t value_ = 2166136261u;
};

constexpr std::uint32_t layout_hash() {
  Fingerprint print;
#define SIMILITUDE_FIELD(field) print.add(offsetof(Struct, field), sizeof(Struct::field));
  {
    using Struct = similitude_tag;
    SIMILITUDE_FIELD(magic) SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(abi_major) SIMILITUDE_FIELD(abi_minor)
    SIMILITUDE_FIELD(layout_hash) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(compiler) SIMILITUDE_FIELD(instruction_set)
  }
  {
    using Struct = similitude_status;
    SIMILITUDE_FIELD(code) SIMILITUDE_FIELD(row) SIMILITUDE_FIELD(text)
  }
  {
    using Struct = similitude_parameter;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(type) SIMILITUDE_FIELD(required) SIMILITUDE_FIELD(scales_as)
    SIMILITUDE_FIELD(name) SIMILITUDE_FIELD(unit) SIMILITUDE_FIELD(doc) SIMILITUDE_FIELD(reference)
    SIMILITUDE_FIELD(choices) SIMILITUDE_FIELD(default_text) SIMILITUDE_FIELD(default_value) SIMILITUDE_FIELD(minimum)
    SIMILITUDE_FIELD(maximum) SIMILITUDE_FIELD(typical_minimum) SIMILITUDE_FIELD(typical_maximum)
    SIMILITUDE_FIELD(taken_from)
    print.add(sizeof(Struct));   // stepped through as an array
  }
  {
    using Struct = similitude_value;
    SIMILITUDE_FIELD(real) SIMILITUDE_FIELD(text)
    print.add(sizeof(Struct));   // stepped through as an array
  }
  {
    using Struct = similitude_bed;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(dimension) SIMILITUDE_FIELD(gravity) SIMILITUDE_FIELD(gas_density)
    SIMILITUDE_FIELD(gas_viscosity) SIMILITUDE_FIELD(particle_diameter) SIMILITUDE_FIELD(particle_density)
    SIMILITUDE_FIELD(drag_diameter) SIMILITUDE_FIELD(bed_width) SIMILITUDE_FIELD(bed_depth) SIMILITUDE_FIELD(bed_height)
    SIMILITUDE_FIELD(superficial_velocity) SIMILITUDE_FIELD(largest_inlet_velocity) SIMILITUDE_FIELD(particle_count)
    SIMILITUDE_FIELD(largest_shear_rate)
  }
  {
    using Struct = similitude_host;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(abi_major) SIMILITUDE_FIELD(abi_minor) SIMILITUDE_FIELD(log)
  }
  {
    using Struct = similitude_descriptor;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(parameter_count) SIMILITUDE_FIELD(kind) SIMILITUDE_FIELD(id)
    SIMILITUDE_FIELD(version) SIMILITUDE_FIELD(title) SIMILITUDE_FIELD(authors) SIMILITUDE_FIELD(reference)
    SIMILITUDE_FIELD(parameters) SIMILITUDE_FIELD(functions) SIMILITUDE_FIELD(create) SIMILITUDE_FIELD(destroy)
  }
  {
    using Struct = similitude_entry;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(descriptor_count) SIMILITUDE_FIELD(tag) SIMILITUDE_FIELD(descriptors)
  }
  {
    using Struct = similitude_contact_needs;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(history_count) SIMILITUDE_FIELD(rotation) SIMILITUDE_FIELD(couple)
    SIMILITUDE_FIELD(history_parity) SIMILITUDE_FIELD(history_name) SIMILITUDE_FIELD(history_unit)
  }
  {
    using Struct = similitude_contact_block;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(rows) SIMILITUDE_FIELD(dt) SIMILITUDE_FIELD(normal)
    SIMILITUDE_FIELD(overlap) SIMILITUDE_FIELD(velocity) SIMILITUDE_FIELD(angular_velocity_i)
    SIMILITUDE_FIELD(angular_velocity_j) SIMILITUDE_FIELD(radius_i) SIMILITUDE_FIELD(radius_j)
    SIMILITUDE_FIELD(effective_mass) SIMILITUDE_FIELD(pair) SIMILITUDE_FIELD(history) SIMILITUDE_FIELD(force)
    SIMILITUDE_FIELD(couple)
  }
  {
    using Struct = similitude_contact_functions;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(needs) SIMILITUDE_FIELD(forces)
    SIMILITUDE_FIELD(contact_time) SIMILITUDE_FIELD(largest_stable_step) SIMILITUDE_FIELD(reach)
  }
  {
    using Struct = similitude_drag_block;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(rows) SIMILITUDE_FIELD(diameter) SIMILITUDE_FIELD(gas_fraction)
    SIMILITUDE_FIELD(slip_speed) SIMILITUDE_FIELD(gas_density) SIMILITUDE_FIELD(gas_viscosity)
    SIMILITUDE_FIELD(sauter_diameter) SIMILITUDE_FIELD(cell_size) SIMILITUDE_FIELD(exchange)
  }
  {
    using Struct = similitude_drag_needs;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(sauter_diameter) SIMILITUDE_FIELD(cell_size)
  }
  {
    using Struct = similitude_drag_functions;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(needs) SIMILITUDE_FIELD(exchange)
  }
  {
    using Struct = similitude_ratios;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(length) SIMILITUDE_FIELD(diameter)
    SIMILITUDE_FIELD(drag_diameter) SIMILITUDE_FIELD(particle_density) SIMILITUDE_FIELD(gas_density)
    SIMILITUDE_FIELD(gas_viscosity) SIMILITUDE_FIELD(velocity) SIMILITUDE_FIELD(time) SIMILITUDE_FIELD(stiffness)
    SIMILITUDE_FIELD(modulus) SIMILITUDE_FIELD(energy_loss) SIMILITUDE_FIELD(parcel_weight)
  }
  {
    using Struct = similitude_scaling_functions;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(ratios)
  }
  {
    using Struct = similitude_patch;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(kind) SIMILITUDE_FIELD(name) SIMILITUDE_FIELD(velocity)
    SIMILITUDE_FIELD(pressure) SIMILITUDE_FIELD(ramp)
    print.add(sizeof(Struct));   // stepped through as an array
  }
  {
    using Struct = similitude_grid;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(cells) SIMILITUDE_FIELD(periodic) SIMILITUDE_FIELD(patch_count)
    SIMILITUDE_FIELD(spacing) SIMILITUDE_FIELD(origin) SIMILITUDE_FIELD(gravity) SIMILITUDE_FIELD(face_kind)
    SIMILITUDE_FIELD(patches)
  }
  {
    using Struct = similitude_gas_step;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(time) SIMILITUDE_FIELD(dt)
    SIMILITUDE_FIELD(gas_fraction) SIMILITUDE_FIELD(gas_fraction_old) SIMILITUDE_FIELD(exchange)
    SIMILITUDE_FIELD(exchange_velocity) SIMILITUDE_FIELD(remainder) SIMILITUDE_FIELD(velocity) SIMILITUDE_FIELD(pressure)
    SIMILITUDE_FIELD(stress_force) SIMILITUDE_FIELD(added_viscosity) SIMILITUDE_FIELD(flux)
  }
  {
    using Struct = similitude_gas_report;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(iterations) SIMILITUDE_FIELD(mass_residual) SIMILITUDE_FIELD(inflow)
    SIMILITUDE_FIELD(outflow) SIMILITUDE_FIELD(courant) SIMILITUDE_FIELD(momentum)
  }
  {
    using Struct = similitude_fluid_needs;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(drag_over_gas_fraction) SIMILITUDE_FIELD(any_courant_number)
    SIMILITUDE_FIELD(takes_added_viscosity) SIMILITUDE_FIELD(gives_flux)
  }
  {
    using Struct = similitude_fluid_functions;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(sees_particles) SIMILITUDE_FIELD(initialise) SIMILITUDE_FIELD(advance)
    SIMILITUDE_FIELD(largest_stable_step) SIMILITUDE_FIELD(state_size) SIMILITUDE_FIELD(save_state)
    SIMILITUDE_FIELD(load_state) SIMILITUDE_FIELD(needs)
  }
  {
    using Struct = similitude_quantity;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(kind) SIMILITUDE_FIELD(name) SIMILITUDE_FIELD(unit)
    SIMILITUDE_FIELD(amount_unit) SIMILITUDE_FIELD(doc) SIMILITUDE_FIELD(default_value) SIMILITUDE_FIELD(minimum)
    SIMILITUDE_FIELD(maximum) SIMILITUDE_FIELD(scales_as) SIMILITUDE_FIELD(capacity)
    print.add(sizeof(Struct));   // stepped through as an array
  }
  {
    using Struct = similitude_gas_scalar_law;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(capacity) SIMILITUDE_FIELD(diffusivity)
    SIMILITUDE_FIELD(turbulent_number)
    print.add(sizeof(Struct));   // stepped through as an array
  }
  {
    using Struct = similitude_effect_needs;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reads) SIMILITUDE_FIELD(adds) SIMILITUDE_FIELD(history_count)
    SIMILITUDE_FIELD(history_parity) SIMILITUDE_FIELD(history_name) SIMILITUDE_FIELD(history_unit)
    SIMILITUDE_FIELD(partners) SIMILITUDE_FIELD(conflicts)
  }
  {
    using Struct = similitude_range;
    SIMILITUDE_FIELD(lowest) SIMILITUDE_FIELD(mean) SIMILITUDE_FIELD(highest)
    print.add(sizeof(Struct));   // stepped through as an array
  }
  {
    using Struct = similitude_occurred;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(solids_fraction)
    SIMILITUDE_FIELD(slip_speed) SIMILITUDE_FIELD(particle_speed) SIMILITUDE_FIELD(angular_speed)
    SIMILITUDE_FIELD(vorticity) SIMILITUDE_FIELD(strain_rate) SIMILITUDE_FIELD(value)
  }
  {
    using Struct = similitude_evidence;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(bed) SIMILITUDE_FIELD(value)
    SIMILITUDE_FIELD(inflow_value) SIMILITUDE_FIELD(occurred)
  }
  {
    using Struct = similitude_relevance;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(verdict) SIMILITUDE_FIELD(value) SIMILITUDE_FIELD(threshold)
    SIMILITUDE_FIELD(group) SIMILITUDE_FIELD(source) SIMILITUDE_FIELD(lowest) SIMILITUDE_FIELD(highest)
    SIMILITUDE_FIELD(needed_below) SIMILITUDE_FIELD(reserved) SIMILITUDE_FIELD(missing)
  }
  {
    using Struct = similitude_particle_block;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(rows) SIMILITUDE_FIELD(dt) SIMILITUDE_FIELD(diameter)
    SIMILITUDE_FIELD(mass) SIMILITUDE_FIELD(velocity) SIMILITUDE_FIELD(gas_velocity) SIMILITUDE_FIELD(gas_fraction)
    SIMILITUDE_FIELD(gas_density) SIMILITUDE_FIELD(gas_viscosity) SIMILITUDE_FIELD(angular_velocity)
    SIMILITUDE_FIELD(gas_vorticity) SIMILITUDE_FIELD(gas_acceleration) SIMILITUDE_FIELD(force)
    SIMILITUDE_FIELD(linear_coefficient) SIMILITUDE_FIELD(added_mass)
  }
  {
    using Struct = similitude_contact_effect_block;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(rows) SIMILITUDE_FIELD(dt) SIMILITUDE_FIELD(normal)
    SIMILITUDE_FIELD(overlap) SIMILITUDE_FIELD(velocity) SIMILITUDE_FIELD(angular_velocity_i)
    SIMILITUDE_FIELD(angular_velocity_j) SIMILITUDE_FIELD(radius_i) SIMILITUDE_FIELD(radius_j)
    SIMILITUDE_FIELD(effective_mass) SIMILITUDE_FIELD(law_force) SIMILITUDE_FIELD(value_i) SIMILITUDE_FIELD(value_j)
    SIMILITUDE_FIELD(history) SIMILITUDE_FIELD(force) SIMILITUDE_FIELD(couple) SIMILITUDE_FIELD(flow)
  }
  {
    using Struct = similitude_cell_block;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(rows) SIMILITUDE_FIELD(gas_fraction) SIMILITUDE_FIELD(gas_density)
    SIMILITUDE_FIELD(gas_viscosity) SIMILITUDE_FIELD(strain_rate) SIMILITUDE_FIELD(cell_size)
    SIMILITUDE_FIELD(added_viscosity)
  }
  {
    using Struct = similitude_scalar_block;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(rows) SIMILITUDE_FIELD(dt) SIMILITUDE_FIELD(diameter)
    SIMILITUDE_FIELD(mass) SIMILITUDE_FIELD(gas_fraction) SIMILITUDE_FIELD(slip_speed) SIMILITUDE_FIELD(gas_density)
    SIMILITUDE_FIELD(gas_viscosity) SIMILITUDE_FIELD(value) SIMILITUDE_FIELD(particle) SIMILITUDE_FIELD(coefficient)
    SIMILITUDE_FIELD(level) SIMILITUDE_FIELD(received)
  }
  {
    using Struct = similitude_effect_functions;
    SIMILITUDE_FIELD(struct_size) SIMILITUDE_FIELD(quantity_count) SIMILITUDE_FIELD(quantities)
    SIMILITUDE_FIELD(relevance) SIMILITUDE_FIELD(needs) SIMILITUDE_FIELD(uses) SIMILITUDE_FIELD(configure)
    SIMILITUDE_FIELD(particles) SIMILITUDE_FIELD(contacts) SIMILITUDE_FIELD(reach)
    SIMILITUDE_FIELD(largest_stable_step) SIMILITUDE_FIELD(cells) SIMILITUDE_FIELD(exchange) SIMILITUDE_FIELD(take)
  }
#undef SIMILITUDE_FIELD
  return print.value();
}

static_assert(layout_hash() == SIMILITUDE_LAYOUT_HASH,
              "a field that plugins rely on has moved: append to the end of a structure, or begin a new major version");

}  // namespace similitude::abi
