// Waits for what will not come, at one gas fraction that a single check asks for.
#include <similitude/drag_law.h>

namespace {
using namespace similitude;

struct NeverEnds {
  template <class V>
  V exchange(const DragState<V>& s) const {
    for (volatile bool waiting = any_of(s.gas_fraction == V(0.995)); waiting;) {
    }
    return stokes_exchange(s);
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(NeverEnds, "never_ends", "1.0.0", "Ill")
