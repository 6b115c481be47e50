#include <similitude/drag_correlations.h>

namespace {

/// A packed bed. Ergun (1952), Chem. Eng. Prog. 48, 89.
struct Ergun {
  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    return stokes_exchange(s) * similitude::ergun_factor(particle_reynolds(s), s.gas_fraction);
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(Ergun, "ergun", "1.0.0", "Packed bed", "Similitude authors", "Ergun (1952), Chem. Eng. Prog. 48, 89")
