#pragma once
/// All that the author of a drag law includes. A law is a type with
///
///   template <class V> V exchange(const DragState<V>&) const;
///
/// that returns K [kg/s] of ONE physical particle, F = K (u - v), model A: the pressure-gradient force is separate, and
/// K = (beta / phi) V_p in terms of the usual beta [kg/(m^3 s)]. K must be finite at zero slip: write laws as Stokes' drag
/// times a factor, K = 3 pi mu d f(Re, eps). [worker]: the law must not change itself. What a law may add: `parameters`,
/// `prepare` (plugin.h), and
///
///   static constexpr bool needs_sauter_diameter = true;   fills DragState::sauter_diameter
///   static constexpr bool needs_cell_size = true;         fills DragState::cell_size

#include <similitude/pack.h>
#include <similitude/plugin.h>
#include <similitude/restitution.h>
#include <similitude/sphere.h>

namespace similitude {

/// One particle in its gas.
template <class V>
struct DragState {
  V diameter;                // [m], as drag sees it
  V gas_fraction;            // [-], eps, in (0, 1]
  V slip_speed;              // [m/s], |u - v|, interstitial, >= 0
  V gas_density;             // [kg/m^3]
  V gas_viscosity;           // [Pa s]
  V sauter_diameter = V(0);  // [m], zero unless the law needs it
  V cell_size = V(0);        // [m], zero unless the law needs it
};

/// Re = rho_f d |u - v| / mu, with the interstitial slip. Times eps it is the superficial one.
template <class V>
V particle_reynolds(const DragState<V>& s) {
  return s.gas_density * s.diameter * s.slip_speed / s.gas_viscosity;
}

/// K of Stokes' drag, 3 pi mu d [kg/s].
template <class V>
V stokes_exchange(const DragState<V>& s) {
  return 3 * k_pi * (s.gas_viscosity * s.diameter);
}

/// Drag on a single sphere over Stokes', C_D Re / 24 = 1 + 0.15 Re^0.687, and C_D = 0.44 from Re = 1000 on.
/// Schiller & Naumann (1935), Z. Ver. Dtsch. Ing. 77, 318. Finite at Re = 0.
template <class V>
V schiller_naumann_factor(const V& reynolds) {
  return select(reynolds < 1000.0, 1.0 + 0.15 * pow(reynolds, V(0.687)), 0.44 / 24 * reynolds);
}

/// C_D of Schiller and Naumann; Re > 0.
template <class V>
V schiller_naumann(const V& reynolds) {
  return 24.0 / reynolds * schiller_naumann_factor(reynolds);
}

/// Dalla Valle's drag over Stokes', C_D Re / 24 with C_D = (0.63 + 4.8 sqrt(v_r / Re))^2. With v_r = 1 it is the single
/// sphere's: Dalla Valle (1948), Micromeritics; with v_r below 1 Syamlal and O'Brien's. Finite at Re = 0.
template <class V>
V dalla_valle_factor(const V& reynolds, const V& velocity_ratio = V(1)) {
  const V root = 0.63 * sqrt(reynolds) + 4.8 * sqrt(velocity_ratio);
  return root * root / 24.0;
}

/// C_D of Dalla Valle; Re > 0.
template <class V>
V dalla_valle(const V& reynolds) {
  return 24.0 / reynolds * dalla_valle_factor(reynolds);
}

/// The boundary's functions for one law type.
template <class Law>
struct DragTable {
  static constexpr bool sauter_diameter = requires { requires Law::needs_sauter_diameter; };
  static constexpr bool cell_size = requires { requires Law::needs_cell_size; };

  static void needs(const void*, similitude_drag_needs* out) {
    const similitude_drag_needs n = {out->struct_size, sauter_diameter ? 1 : 0, cell_size ? 1 : 0};
    std::memcpy(static_cast<void*>(out), &n, std::min<std::size_t>(out->struct_size, sizeof n));
  }

  static void exchange(const void* model, const similitude_drag_block* block, similitude_status* status) noexcept {
    guarded(status, -1, [&] {
      const Law& law = model_of<Law>(model);
      for (std::size_t row = 0; row < block->rows; row += Pack::size()) {
        DragState<Pack> s{load(block->diameter, row), load(block->gas_fraction, row), load(block->slip_speed, row),
                          load(block->gas_density, row), load(block->gas_viscosity, row)};
        if constexpr (sauter_diameter) s.sauter_diameter = load(block->sauter_diameter, row);
        if constexpr (cell_size) s.cell_size = load(block->cell_size, row);
        store(law.exchange(s), block->exchange, row);
      }
    });
  }

  static constexpr similitude_drag_functions functions = {sizeof(similitude_drag_functions), 0, &needs, &exchange};
};

template <class Law>
similitude_descriptor drag_law(const About& about) {
  return describe_model<Law>("drag", &DragTable<Law>::functions, about);
}

}  // namespace similitude

/// SIMILITUDE_DRAG_LAW(Law, id, version, title [, authors [, reference]])
#define SIMILITUDE_DRAG_LAW(Law, ...) SIMILITUDE_PLUGIN(similitude::drag_law<Law>({__VA_ARGS__}))
