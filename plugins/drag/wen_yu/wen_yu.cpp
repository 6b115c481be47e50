#include <similitude/drag_correlations.h>

namespace {

/// Fluidised beds, moderate to dilute. Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100.
struct WenYu {
  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    return stokes_exchange(s) * similitude::wen_yu_factor(particle_reynolds(s), s.gas_fraction);
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(WenYu, "wen_yu", "1.0.0", "Fluidised bed, moderate to dilute", "Similitude authors",
                    "Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100")
