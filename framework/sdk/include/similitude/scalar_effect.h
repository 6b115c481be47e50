#pragma once
/// For authors of effects that carry scalars: temperatures, mass fractions, conversions. Beside what effect.h lists, the type has
///
///   enum : unsigned { gas_temperature, temperature, heat_capacity };          names for the rows of its table
///   static constexpr similitude_quantity quantities[] = {gas_scalar(…), particle_scalar(…), …};   the table, in that order
///   bool uses(unsigned quantity) const;                                       false: not with these parameters [setup]
///   void configure(const double* property, similitude_gas_scalar_law* law);   both by quantity: how the gas carries [setup]
///   template <class V> void exchange(const ScalarParticle<V>&, Asked<V>*) const;          by quantity, of gas scalars [worker]
///   template <class V> void take(ScalarParticle<V>&, const V* received) const;            by quantity; sets its particle scalars
///
/// Of one particle the gas gives  coefficient (s_gas - level)  per second, with s_gas at the end of the step. An effect that
/// relaxes its own particle scalar of capacity C makes that implicit too with coefficient = c / (1 + c dt / C) and level = its
/// value at the start: however stiff, it never overshoots. take() then adds received / C.

#include <array>

#include <similitude/pack.h>
#include <similitude/plugin.h>

namespace similitude {

/// One particle, its gas, and the values of the effect's quantities: gas scalars at the particle, particle scalars, properties.
template <class V>
struct ScalarParticle {
  double dt;           // [s], gas step
  V diameter;          // [m]
  V mass;              // [kg]
  V gas_fraction;      // [-]
  V slip_speed;        // [m/s]
  V gas_density;       // [kg/m^3]
  V gas_viscosity;     // [Pa s]
  std::array<V, SIMILITUDE_MAX_QUANTITIES> value;
};

/// What a particle asks of the gas: amount per second into it = coefficient (s_gas - level).
template <class V>
struct Asked {
  V coefficient = V(0), level = V(0);
};

/// What the author of a quantity may leave out. NaN default: the case must give it.
struct QuantityText {
  double def = std::numeric_limits<double>::quiet_NaN();
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  const char* amount_unit = nullptr;   // of scalars
  int capacity = -1;                   // of particle scalars: row of the property that times the mass is its capacity
};

constexpr similitude_quantity quantity(int kind, const char* name, const char* unit, const char* doc, QuantityText text = {}) {
  return {sizeof(similitude_quantity), kind, name, unit, text.amount_unit, doc, text.def, text.min, text.max, SIMILITUDE_SCALES_NOT,
          text.capacity};
}

/// The hooks of abi.h for an effect type with `quantities`.
template <class Effect>
struct ScalarHooks {
  static constexpr std::size_t count = std::size(Effect::quantities);
  static_assert(count <= SIMILITUDE_MAX_QUANTITIES);
  static constexpr bool exchanges = requires(const Effect& e, const ScalarParticle<Pack>& p, Asked<Pack>* asked) { e.exchange(p, asked); };
  static constexpr bool takes = requires(const Effect& e, ScalarParticle<Pack>& p, const Pack* received) { e.take(p, received); };

  static std::int32_t uses(const void* model, std::uint32_t quantity) noexcept {
    if constexpr (requires(const Effect& e) { e.uses(quantity); }) return model_of<Effect>(model).uses(quantity) ? 1 : 0;
    return 1;
  }
  static void ask_what_it_uses([[maybe_unused]] const Effect& effect) {
    if constexpr (requires { effect.uses(0u); }) {
      for (std::uint32_t q = 0; q < count; ++q) static_cast<void>(effect.uses(q));
    }
  }
  static void configure(void* model, const double* property, similitude_gas_scalar_law* laws, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      if constexpr (requires(Effect& e) { e.configure(property, laws); }) model_of<Effect>(model).configure(property, laws);
    });
  }

  static ScalarParticle<Pack> row_of(const similitude_scalar_block& b, std::size_t row) {
    ScalarParticle<Pack> p{b.dt,
                           load(b.diameter, row),
                           load(b.mass, row),
                           load(b.gas_fraction, row),
                           load(b.slip_speed, row),
                           load(b.gas_density, row),
                           load(b.gas_viscosity, row),
                           {}};
    for (std::size_t q = 0; q < count; ++q) {
      if (b.value[q]) p.value[q] = load(b.value[q], row);
      else if (b.particle[q]) p.value[q] = load(b.particle[q], row);
      else p.value[q] = Pack(0);
    }
    return p;
  }

  static void exchange(const void* model, const similitude_scalar_block* b, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      if constexpr (exchanges) {
        const Effect& effect = model_of<Effect>(model);
        for (std::size_t row = 0; row < b->rows; row += Pack::size()) {
          Asked<Pack> asked[count];
          effect.exchange(row_of(*b, row), asked);
          for (std::size_t q = 0; q < count; ++q) {
            if (!b->coefficient[q]) continue;
            store(asked[q].coefficient, b->coefficient[q], row);
            store(asked[q].level, b->level[q], row);
          }
        }
      }
    });
  }

  static void take(const void* model, const similitude_scalar_block* b, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      if constexpr (takes) {
        const Effect& effect = model_of<Effect>(model);
        for (std::size_t row = 0; row < b->rows; row += Pack::size()) {
          ScalarParticle<Pack> p = row_of(*b, row);
          Pack received[count];
          for (std::size_t q = 0; q < count; ++q) received[q] = b->received[q] ? load(b->received[q], row) : Pack(0);
          effect.take(p, received);
          for (std::size_t q = 0; q < count; ++q) {
            if (b->particle[q]) store(p.value[q], b->particle[q], row);
          }
        }
      }
    });
  }

  static constexpr void add_to(similitude_effect_functions& t) {
    t.quantity_count = static_cast<std::uint32_t>(count);
    t.quantities = Effect::quantities;
    t.uses = &uses;
    t.configure = &configure;
    if (exchanges) t.exchange = &exchange;
    if (takes) t.take = &take;
  }
};

}  // namespace similitude
