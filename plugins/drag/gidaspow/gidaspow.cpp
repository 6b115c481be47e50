#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

/// Ergun in the dense bed, Wen and Yu in the dilute one. Gidaspow (1994), Multiphase Flow and Fluidization.
struct Gidaspow {
  template <class V>
  V exchange(const DragState<V>& s) const {
    const V reynolds = particle_reynolds(s);
    return stokes_exchange(s) * select(s.gas_fraction <= 0.8, ergun_factor(reynolds, s.gas_fraction),
                                       wen_yu_factor(reynolds, s.gas_fraction));
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(Gidaspow, "gidaspow", "1.0.0", "Ergun in the dense bed, Wen and Yu in the dilute one",
                    "Similitude authors", "Gidaspow (1994), Multiphase Flow and Fluidization, Academic Press")
