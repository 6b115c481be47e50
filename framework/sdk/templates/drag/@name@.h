#pragma once
#include <similitude/drag_law.h>

/// A single sphere's drag times a power of the gas fraction: Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100, with
/// Schiller & Naumann's sphere. Put your formula here, and its source into this comment.
struct @Type@ {
  double exponent;  // [-]

  static void parameters(similitude::Parameters<@Type@>& p) {
    p.real("exponent", &@Type@::exponent,
           {.unit = "1", .def = 2.65, .min = 0, .max = 6, .doc = "of the gas fraction: crowding raises the drag"});
  }

  /// K [kg/s] of one particle, F = K (gas - particle velocity).
  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    const V reynolds = s.gas_fraction * particle_reynolds(s);  // superficial
    return stokes_exchange(s) * similitude::schiller_naumann_factor(reynolds) * pow(s.gas_fraction, V(-exponent));
  }
};
