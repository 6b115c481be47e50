#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

/// Gidaspow's law without its jump: Ergun passes into Wen and Yu around a gas fraction of 0.8.
/// Huilin & Gidaspow (2003), Chem. Eng. Sci. 58, 3777.
struct HuilinGidaspow {
  template <class V>
  V exchange(const DragState<V>& s) const {
    const V reynolds = particle_reynolds(s);
    const V dilute = 0.5 + atan(150 * 1.75 * (s.gas_fraction - 0.8)) / k_pi;
    return stokes_exchange(s) * ((1.0 - dilute) * ergun_factor(reynolds, s.gas_fraction) +
                                 dilute * wen_yu_factor(reynolds, s.gas_fraction));
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(HuilinGidaspow, "huilin_gidaspow", "1.0.0", "Gidaspow with a smooth passage from Ergun to Wen and Yu",
                    "Similitude authors", "Huilin & Gidaspow (2003), Chem. Eng. Sci. 58, 3777")
