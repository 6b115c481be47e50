#pragma once
/// All that the author of an effect includes. An effect is a type with either or both of
///
///   Relevance relevance(const Bed&) const;   does this bed call for it? without it: cannot tell [setup]
///   template <class V> Addition<V> particles(const Particle<V>&) const;   an extra force on particles [worker]
///
/// and, as all models, `parameters` and `prepare` (plugin.h). Forces are on one physical particle; the framework gives
/// the gas the opposite.

#include <similitude/pack.h>
#include <similitude/plugin.h>

namespace similitude {

enum class Verdict { negligible = 0, needed = 1, cannot_tell = -1 };

/// A dimensionless group against its threshold. Texts are static.
struct Relevance {
  Verdict verdict = Verdict::cannot_tell;
  double value = 0, threshold = 0;
  const char* group = "";    // "rho_f/rho_p"
  const char* source = "";   // of the threshold
};

/// One particle in its gas.
template <class V>
struct Particle {
  double dt;              // [s]
  V diameter;             // [m]
  V mass;                 // [kg]
  Vec3<V> velocity;       // [m/s]
  Vec3<V> gas_velocity;   // [m/s], at the particle
  V gas_fraction;         // [-]
  V gas_density;          // [kg/m^3]
  V gas_viscosity;        // [Pa s]
};

/// What an effect adds to a particle.
template <class V>
struct Addition {
  Vec3<V> force = {V(0), V(0), V(0)};   // [N]
  V linear_coefficient = V(0);          // [kg/s], F = c (u - v), treated implicitly
};

/// The boundary's functions for one effect type.
template <class Effect>
struct EffectTable {
  static constexpr bool judges = requires(const Effect& e, const Bed& bed) { e.relevance(bed); };
  static constexpr bool has_particles = requires(const Effect& e, const Particle<Pack>& p) { e.particles(p); };
  static_assert(judges || has_particles, "an effect has relevance(const Bed&) or particles(const Particle<V>&)");

  static void relevance(const void* model, const similitude_bed* bed, similitude_relevance* out) noexcept {
    Relevance r;
    if constexpr (judges) {
      similitude_status ignored{};   // an effect that cannot judge cannot tell
      guarded(&ignored, -1, [&] { r = model_of<Effect>(model).relevance(as_known_here(bed)); });
    }
    const similitude_relevance all = {out->struct_size, static_cast<std::int32_t>(r.verdict), r.value, r.threshold,
                                      r.group,          r.source};
    std::memcpy(static_cast<void*>(out), &all, std::min<std::size_t>(out->struct_size, sizeof all));
  }

  static void particles(const void* model, const similitude_particle_block* b, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      if constexpr (has_particles) {
        const Effect& effect = model_of<Effect>(model);
        for (std::size_t row = 0; row < b->rows; row += Pack::size()) {
          const Addition<Pack> added = effect.particles(
              Particle<Pack>{b->dt, load(b->diameter, row), load(b->mass, row), load(b->velocity, row),
                             load(b->gas_velocity, row), load(b->gas_fraction, row), load(b->gas_density, row),
                             load(b->gas_viscosity, row)});
          store(load(b->force, row) + added.force, b->force, row);
          store(load(b->linear_coefficient, row) + added.linear_coefficient, b->linear_coefficient, row);
        }
      }
    });
  }

  static constexpr similitude_effect_functions functions = {sizeof(similitude_effect_functions), 0, &relevance,
                                                            has_particles ? &particles : nullptr};
};

template <class Effect>
similitude_descriptor effect(const About& about) {
  return describe_model<Effect>("effect", &EffectTable<Effect>::functions, about);
}

}  // namespace similitude

/// SIMILITUDE_EFFECT(Effect, id, version, title [, authors [, reference]])
#define SIMILITUDE_EFFECT(Effect, ...) SIMILITUDE_PLUGIN(similitude::effect<Effect>({__VA_ARGS__}))
