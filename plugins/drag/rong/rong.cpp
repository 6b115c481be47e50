#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

/// Di Felice's form with an exponent that depends on the gas fraction too, from lattice-Boltzmann simulations of packed
/// beds. Rong, Dong & Yu (2013), Chem. Eng. Sci. 99, 44.
struct Rong {
  template <class V>
  V exchange(const DragState<V>& s) const {
    const V eps = s.gas_fraction, superficial = eps * particle_reynolds(s);
    const V chi = 2.65 * (eps + 1.0) - (5.3 - 3.5 * eps) * (eps * eps) * di_felice_dip(superficial);
    return stokes_exchange(s) * dalla_valle_factor(superficial) * pow(eps, V(1.0 - chi));
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(Rong, "rong", "1.0.0", "Rong, Dong and Yu 2013, packed to dilute", "Similitude authors",
                    "Rong, Dong & Yu (2013), Chem. Eng. Sci. 99, 44")
