#include <similitude/drag_law.h>

namespace {
using namespace similitude;

/// Ergun in the dense bed, Wen and Yu in the dilute one. Gidaspow (1994), Multiphase Flow and Fluidization.
struct Gidaspow {
  /// Ergun (1952), Chem. Eng. Prog. 48, 89: beta/phi = 150 phi mu / (eps d^2) + 1.75 rho_f |u - v| / d, times pi d^3 / 6.
  template <class V>
  static V ergun(const DragState<V>& s) {
    const V solids_fraction = 1.0 - s.gas_fraction;
    return stokes_exchange(s) * (150 * solids_fraction / s.gas_fraction + 1.75 * particle_reynolds(s)) / 18.0;
  }

  /// Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100, with the superficial Reynolds number: eps^-2.65.
  template <class V>
  static V wen_yu(const DragState<V>& s) {
    return stokes_exchange(s) * schiller_naumann_factor(V(s.gas_fraction * particle_reynolds(s))) *
           pow(s.gas_fraction, V(-2.65));
  }

  template <class V>
  V exchange(const DragState<V>& s) const {
    return select(s.gas_fraction <= 0.8, ergun(s), wen_yu(s));
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(Gidaspow, "gidaspow", "1.0.0", "Ergun in the dense bed, Wen and Yu in the dilute one",
                    "Similitude authors", "Gidaspow (1994), Multiphase Flow and Fluidization, Academic Press")
