#pragma once
/// All that the author of an effect includes. An effect is a type with any of
///
///   template <class V> Addition<V> particles(const Particle<V>&) const;    an extra force on particles [worker]
///   template <class V> Force<V> contact(const EffectContact<V>&) const;    an extra force or couple in contacts [worker]
///   template <class V> Force<V> contact(const EffectContact<V>&, History<V>&) const;   with memory
///   template <class V> void flow(const EffectContact<V>&, V*) const;       by quantity: amount of particle scalars per second from j
///                                                                          into i [worker]
///   template <class V> V added_viscosity(const GasCell<V>&) const;         [Pa s], beside the molecular one [worker]
///
/// and of
///
///   Relevance relevance(const Evidence&) const;       does this bed call for it? without it: cannot tell [setup][main]
///   unsigned reads() const;  unsigned adds() const;   SIMILITUDE_READS_..., SIMILITUDE_ADDS_...: what it wants beyond the usual
///   static constexpr HistoryValue history[] = {...};  what a contact remembers
///   bool remembers() const;                           false: these parameters need no memory; contact(c) is called
///   const char* partners() const;  const char* conflicts() const;   "a|b c": models that must, or must not, be there
///   double reach(double diameter) const;              [m], contacts begin at this gap; default 0
///   double largest_stable_step(double effective_mass, double effective_radius, double speed) const;   [s], of the contact pass
///
/// reads, adds, remembers, partners and conflicts say the same whenever they are asked; the first time an exception refuses the effect.
///
/// and, as all models, `parameters` and `prepare` (plugin.h). Forces are on one physical particle; the framework gives
/// the gas, or the contact's partner, the opposite. Scalars (temperature, species) are in scalar_effect.h.

#include <limits>

#include <similitude/contact_block.h>
#include <similitude/pack.h>
#include <similitude/plugin.h>
#include <similitude/scalar_effect.h>

namespace similitude {

enum class Verdict { negligible = 0, needed = 1, cannot_tell = -1 };

/// A dimensionless group against its threshold. Texts are static. NaN: not known.
struct Relevance {
  Verdict verdict = Verdict::cannot_tell;
  double value = std::numeric_limits<double>::quiet_NaN(), threshold = std::numeric_limits<double>::quiet_NaN();
  const char* group = "";          // "rho_f/rho_p"
  const char* source = "";         // of the threshold
  double lowest = std::numeric_limits<double>::quiet_NaN();    // the range that the value may have in this scene;
  double highest = std::numeric_limits<double>::quiet_NaN();   // not given: the value
  bool needed_below = false;       // needed where the value is below the threshold
  const char* missing = nullptr;   // of a verdict that cannot tell: what would tell
};

/// What an effect judges by: the real bed, what the case gives of the effect's own quantities, and, after a run, what occurred.
/// Each class of particles is judged by itself, and the verdict most in need holds.
struct Evidence {
  Bed bed;                                // its particles are those of the class
  const double* value = nullptr;          // by quantity; null without quantities
  const double* inflow_value = nullptr;   // by quantity: of the inlet, or of the other class, that differs most; NaN: none
  const similitude_occurred* occurred = nullptr;   // null before a run
};

/// One particle in its gas.
template <class V>
struct Particle {
  double dt;                  // [s]
  V diameter;                 // [m]
  V mass;                     // [kg]
  Vec3<V> velocity;           // [m/s]
  Vec3<V> gas_velocity;       // [m/s], at the particle
  V gas_fraction;             // [-]
  V gas_density;              // [kg/m^3]
  V gas_viscosity;            // [Pa s]
  Vec3<V> angular_velocity;   // [rad/s]; this and the next two are zero unless reads() asks for them
  Vec3<V> gas_vorticity;      // [1/s], curl u
  Vec3<V> gas_acceleration;   // [m/s^2], Du/Dt
};

/// What an effect adds to a particle.
template <class V>
struct Addition {
  Vec3<V> force = {V(0), V(0), V(0)};   // [N]
  V linear_coefficient = V(0);          // [kg/s], F = c (u - v), treated implicitly
  V added_mass = V(0);                  // [kg], m_a of m_a (Du/Dt - dv/dt); m_a Du/Dt belongs into `force`; adds() must say so
};

/// One contact after its contact law.
template <class V>
struct EffectContact : Contact<V> {
  Vec3<V> law_force;   // [N], on i, of the contact law alone; zero beyond the law's reach
  // By quantity of the effect (scalar_effect.h): particle scalars and properties of both partners; of a wall the wall property
  // of the same name, NaN where the case gives none. Zero in effects without quantities.
  std::array<V, SIMILITUDE_MAX_QUANTITIES> value_i, value_j;

  /// [N], positive where the law pushes the partners apart.
  V law_normal_force() const { return dot(law_force, this->normal); }
};

/// One cell of the gas.
template <class V>
struct GasCell {
  V gas_fraction;    // [-]
  V gas_density;     // [kg/m^3]
  V gas_viscosity;   // [Pa s], molecular
  V strain_rate;     // [1/s], sqrt(2 S:S)
  V cell_size;       // [m]
};

/// Do effects read spin, add couples and so on? Zero without the function.
template <class Effect>
unsigned reads_of(const Effect& effect) {
  if constexpr (requires { effect.reads(); }) return effect.reads();
  return 0;
}
template <class Effect>
unsigned adds_of(const Effect& effect) {
  if constexpr (requires { effect.adds(); }) return effect.adds();
  return 0;
}

/// The boundary's functions for one effect type.
template <class Effect>
struct EffectTable {
  static constexpr bool judges = requires(const Effect& e, const Evidence& evidence) { e.relevance(evidence); };
  static constexpr bool has_particles = requires(const Effect& e, const Particle<Pack>& p) { e.particles(p); };
  static constexpr bool contacts_without_memory = requires(const Effect& e, const EffectContact<Pack>& c) { e.contact(c); };
  static constexpr bool contacts_with_memory =
      requires(const Effect& e, const EffectContact<Pack>& c, History<Pack>& h) { e.contact(c, h); };
  static constexpr bool has_flow = requires(const Effect& e, const EffectContact<Pack>& c, Pack* flow) { e.flow(c, flow); };
  static constexpr bool has_contacts = contacts_without_memory || contacts_with_memory || has_flow;
  static constexpr bool has_cells = requires(const Effect& e, const GasCell<Pack>& c) { e.added_viscosity(c); };
  static constexpr bool has_quantities = requires { Effect::quantities; };
  static_assert(judges || has_particles || has_contacts || has_cells || has_quantities, "an effect has relevance(const Evidence&) or a pass");
  static_assert(contacts_with_memory == has_history<Effect>, "contact(c, history) and `history` belong together");

  static bool keeps_history(const Effect& effect) {
    if constexpr (contacts_with_memory && contacts_without_memory) return remembers(effect);
    return contacts_with_memory;
  }

  static void relevance(const void* model, const similitude_evidence* given, similitude_relevance* out) noexcept {
    Relevance r;
    if constexpr (judges) {
      number_or_nan<Effect>(model, "relevance", [&] {   // an effect that cannot judge cannot tell, and its words go to the log
        const similitude_evidence known = as_known_here(given);
        similitude_occurred occurred{};
        if (known.occurred) occurred = as_known_here(known.occurred);
        r = model_of<Effect>(model).relevance(
            Evidence{as_known_here(known.bed), known.value, known.inflow_value, known.occurred ? &occurred : nullptr});
        return r.value;
      });
    }
    similitude_relevance all{};
    all.struct_size = out->struct_size;
    all.verdict = static_cast<std::int32_t>(r.verdict);
    all.value = r.value;
    all.threshold = r.threshold;
    all.group = r.group;
    all.source = r.source;
    all.lowest = std::isnan(r.lowest) ? r.value : r.lowest;
    all.highest = std::isnan(r.highest) ? r.value : r.highest;
    all.needed_below = r.needed_below ? 1 : 0;
    all.missing = r.missing;
    std::memcpy(static_cast<void*>(out), &all, std::min<std::size_t>(out->struct_size, sizeof all));
  }

  /// What `needs` and `uses` ask the effect is asked once here.
  static void* create(const similitude_host* host, const similitude_bed* bed, const similitude_value* values, std::uint32_t sets,
                      similitude_status* status) noexcept {
    return create_and_ask<Effect>(host, bed, values, sets, status, [](const Effect& effect) {
      needs_of(effect);
      if constexpr (has_quantities) ScalarHooks<Effect>::ask_what_it_uses(effect);
    });
  }

  static similitude_effect_needs needs_of(const Effect& effect) {
    similitude_effect_needs n{};
    n.reads = reads_of(effect);
    n.adds = adds_of(effect);
    if constexpr (has_flow && !contacts_with_memory && !contacts_without_memory) n.adds |= SIMILITUDE_ADDS_FLOW_ALONE;
    if constexpr (has_history<Effect>) {
      if (keeps_history(effect)) {
        for (const HistoryValue& value : Effect::history) {
          n.history_parity[n.history_count] = static_cast<std::int32_t>(value.parity);
          n.history_name[n.history_count] = value.name;
          n.history_unit[n.history_count] = value.unit;
          ++n.history_count;
        }
      }
    }
    if constexpr (requires { effect.partners(); }) n.partners = effect.partners();
    if constexpr (requires { effect.conflicts(); }) n.conflicts = effect.conflicts();
    return n;
  }

  static void needs(const void* model, similitude_effect_needs* out) noexcept {
    similitude_effect_needs n = needs_of(model_of<Effect>(model));
    n.struct_size = out->struct_size;
    std::memcpy(static_cast<void*>(out), &n, std::min<std::size_t>(out->struct_size, sizeof n));
  }

  static void particles(const void* model, const similitude_particle_block* b, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      if constexpr (has_particles) {
        const Effect& effect = model_of<Effect>(model);
        const auto optional = [](const double* const column[3], std::size_t row) {
          return column[0] ? load(column, row) : Vec3<Pack>{Pack(0), Pack(0), Pack(0)};
        };
        for (std::size_t row = 0; row < b->rows; row += Pack::size()) {
          const Addition<Pack> added = effect.particles(
              Particle<Pack>{b->dt, load(b->diameter, row), load(b->mass, row), load(b->velocity, row),
                             load(b->gas_velocity, row), load(b->gas_fraction, row), load(b->gas_density, row),
                             load(b->gas_viscosity, row), optional(b->angular_velocity, row), optional(b->gas_vorticity, row),
                             optional(b->gas_acceleration, row)});
          store(load(b->force, row) + added.force, b->force, row);
          store(load(b->linear_coefficient, row) + added.linear_coefficient, b->linear_coefficient, row);
          if (b->added_mass) store(load(b->added_mass, row) + added.added_mass, b->added_mass, row);
        }
      }
    });
  }

  static EffectContact<Pack> contact_row(const similitude_contact_effect_block& b, std::size_t row) {
    const Vec3<Pack> none = {Pack(0), Pack(0), Pack(0)};
    EffectContact<Pack> c;
    c.dt = b.dt;
    c.normal = load(b.normal, row);
    c.overlap = load(b.overlap, row);
    const Vec3<Pack> velocity = load(b.velocity, row);
    c.normal_velocity = dot(velocity, c.normal);
    c.tangential_velocity = velocity - c.normal_velocity * c.normal;
    c.radius_i = load(b.radius_i, row);
    c.radius_j = load(b.radius_j, row);
    c.effective_mass = load(b.effective_mass, row);
    c.angular_velocity_i = b.angular_velocity_i[0] ? load(b.angular_velocity_i, row) : none;
    c.angular_velocity_j = b.angular_velocity_j[0] ? load(b.angular_velocity_j, row) : none;
    c.law_force = load(b.law_force, row);
    if constexpr (has_quantities) {
      for (std::size_t q = 0; q < std::size(Effect::quantities); ++q) {
        c.value_i[q] = b.value_i && b.value_i[q] ? load(b.value_i[q], row) : Pack(0);
        c.value_j[q] = b.value_j && b.value_j[q] ? load(b.value_j[q], row) : Pack(0);
      }
    }
    return c;
  }

  template <bool Remembering>
  [[gnu::flatten]] static void contact_rows(const Effect& effect, const similitude_contact_effect_block& b) {
    for (std::size_t row = 0; row < b.rows; row += Pack::size()) {
      const EffectContact<Pack> c = contact_row(b, row);
      Force<Pack> added{{Pack(0), Pack(0), Pack(0)}};
      if constexpr (Remembering) {
        History<Pack> memory;
        for (std::size_t k = 0; k < history_count<Effect>(); ++k) memory.value[k] = load(b.history[k], row);
        added = effect.contact(c, memory);
        for (std::size_t k = 0; k < history_count<Effect>(); ++k) store(memory.value[k], b.history[k], row);
      } else if constexpr (contacts_without_memory) {
        added = effect.contact(c);
      }
      store(load(b.force, row) + added.force, b.force, row);
      if (b.couple[0]) store(load(b.couple, row) + added.couple, b.couple, row);
    }
  }

  static void contacts(const void* model, const similitude_contact_effect_block* b, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      if constexpr (has_contacts) {
        const Effect& effect = model_of<Effect>(model);
        if constexpr (has_flow) {
          if (b->flow != nullptr) {
            for (std::size_t row = 0; row < b->rows; row += Pack::size()) {
              Pack flow[std::size(Effect::quantities)]{};
              effect.flow(contact_row(*b, row), flow);
              for (std::size_t q = 0; q < std::size(Effect::quantities); ++q) {
                if (b->flow[q]) store(flow[q], b->flow[q], row);
              }
            }
            return;
          }
        }
        if constexpr (!contacts_with_memory && !contacts_without_memory) {
          return;
        } else if constexpr (!contacts_with_memory) {
          contact_rows<false>(effect, *b);
        } else if constexpr (!contacts_without_memory) {
          contact_rows<true>(effect, *b);
        } else if (b->history[0]) {
          contact_rows<true>(effect, *b);
        } else {
          contact_rows<false>(effect, *b);
        }
      }
    });
  }

  static void cells(const void* model, const similitude_cell_block* b, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      if constexpr (has_cells) {
        const Effect& effect = model_of<Effect>(model);
        for (std::size_t row = 0; row < b->rows; row += Pack::size()) {
          const Pack added = effect.added_viscosity(GasCell<Pack>{load(b->gas_fraction, row), load(b->gas_density, row),
                                                                  load(b->gas_viscosity, row), load(b->strain_rate, row),
                                                                  load(b->cell_size, row)});
          store(load(b->added_viscosity, row) + added, b->added_viscosity, row);
        }
      }
    });
  }

  static double reach(const void* model, double diameter) noexcept {
    return number_or_nan<Effect>(model, "reach", [&]() -> double {
      if constexpr (requires(const Effect& e) { e.reach(diameter); }) return model_of<Effect>(model).reach(diameter);
      return 0;
    });
  }

  static double largest_stable_step(const void* model, double mass, double radius, double speed) noexcept {
    return number_or_nan<Effect>(model, "largest_stable_step", [&]() -> double {
      if constexpr (requires(const Effect& e) { e.largest_stable_step(mass, radius, speed); }) {
        return model_of<Effect>(model).largest_stable_step(mass, radius, speed);
      }
      return std::numeric_limits<double>::infinity();
    });
  }

  static constexpr similitude_effect_functions table() {
    similitude_effect_functions t{};
    t.struct_size = sizeof t;
    t.relevance = &relevance;
    t.needs = &needs;
    if (has_particles) t.particles = &particles;
    if (has_contacts) {
      t.contacts = &contacts;
      t.reach = &reach;
      t.largest_stable_step = &largest_stable_step;
    }
    if (has_cells) t.cells = &cells;
    if constexpr (has_quantities) ScalarHooks<Effect>::add_to(t);
    return t;
  }

  static constexpr similitude_effect_functions functions = table();
};

template <class Effect>
similitude_descriptor effect(const About& about) {
  similitude_descriptor d = describe_model<Effect>("effect", &EffectTable<Effect>::functions, about);
  d.create = &EffectTable<Effect>::create;
  return d;
}

}  // namespace similitude

/// SIMILITUDE_EFFECT(Effect, id, version, title [, authors [, reference]])
#define SIMILITUDE_EFFECT(Effect, ...) SIMILITUDE_PLUGIN(similitude::effect<Effect>({__VA_ARGS__}))
