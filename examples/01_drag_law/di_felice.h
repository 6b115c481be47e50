#pragma once
#include <similitude/drag_law.h>

/// A single sphere's drag at the superficial velocity, times a power of the gas fraction.
/// Di Felice (1994), Int. J. Multiphase Flow 20, 153; C_D of Dalla Valle.
struct DiFelice {
  double exponent;  // [-]
  double dip;       // [-]

  static void parameters(similitude::Parameters<DiFelice>& p) {
    p.real("exponent", &DiFelice::exponent,
           {.unit = "1", .def = 3.7, .min = 0, .max = 6, .doc = "of the gas fraction, in slow and in fast flow"});
    p.real("dip", &DiFelice::dip,
           {.unit = "1", .def = 0.65, .min = 0, .max = 3, .doc = "by which it is smaller around Re = 30"});
  }

  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    const V reynolds = s.gas_fraction * particle_reynolds(s);  // superficial
    const V decades = 1.5 - log(reynolds) / std::log(10.0);    // infinite at rest, where the dip then vanishes
    const V chi = exponent - dip * exp(-0.5 * decades * decades);
    return stokes_exchange(s) * similitude::dalla_valle_factor(reynolds) * pow(s.gas_fraction, V(1.0 - chi));
  }
};
