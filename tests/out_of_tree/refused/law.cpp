#include <similitude/drag_law.h>

double defined_nowhere();

/// Stokes' drag times something that was forgotten.
struct Law {
  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    return defined_nowhere() * stokes_exchange(s);
  }
};
SIMILITUDE_DRAG_LAW(Law, "org.example.law", "1.0.0", "A law with a hole")
