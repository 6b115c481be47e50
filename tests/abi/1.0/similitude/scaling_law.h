#pragma once
/// All that the author of a scaling law includes. A law is a type with
///
///   Ratios ratios(const Bed& real) const;
///
/// called once per run with the real bed. [setup] What it throws is refused with its own words. It may have `parameters`
/// and `prepare` (plugin.h).

#include <similitude/plugin.h>

namespace similitude {

/// Simulated / real. What a law does not set stays 1.
struct Ratios {
  double length = 1;             // r: geometry
  double diameter = 1;           // n: what touches
  double drag_diameter = 1;      // what drag laws see; differs from `diameter` only for parcels
  double particle_density = 1;
  double gas_density = 1;
  double gas_viscosity = 1;
  double velocity = 1;
  double time = 1;
  double stiffness = 1;          // of springs
  double modulus = 1;            // of elastic moduli
  double energy_loss = 1;        // (1 - e^2)
  double parcel_weight = 1;      // physical particles that one simulated particle stands for
};

/// The boundary's functions for one law type.
template <class Law>
struct ScalingTable {
  static void ratios(const void* model, const similitude_bed* real, similitude_ratios* out,
                     similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      const Ratios r = model_of<Law>(model).ratios(as_known_here(real));
      const similitude_ratios all = {out->struct_size, 0,          r.length,   r.diameter, r.drag_diameter,
                                     r.particle_density, r.gas_density, r.gas_viscosity, r.velocity, r.time,
                                     r.stiffness,        r.modulus,     r.energy_loss,   r.parcel_weight};
      std::memcpy(static_cast<void*>(out), &all, std::min<std::size_t>(out->struct_size, sizeof all));
    });
  }

  static constexpr similitude_scaling_functions functions = {sizeof(similitude_scaling_functions), 0, &ratios};
};

template <class Law>
similitude_descriptor scaling_law(const About& about) {
  return describe_model<Law>("scaling", &ScalingTable<Law>::functions, about);
}

}  // namespace similitude

/// SIMILITUDE_SCALING_LAW(Law, id, version, title [, authors [, reference]])
#define SIMILITUDE_SCALING_LAW(Law, ...) SIMILITUDE_PLUGIN(similitude::scaling_law<Law>({__VA_ARGS__}))
