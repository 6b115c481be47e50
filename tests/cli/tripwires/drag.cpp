// A drag law that is not a number once the slip is fast enough.
#include <similitude/drag_law.h>

#include <limits>

namespace {

struct Tripwire {
  double slip = 0;   // [m/s]

  static void parameters(similitude::Parameters<Tripwire>& p) {
    p.real("slip", &Tripwire::slip, {.unit = "m/s", .def = 0.5, .min = 0, .doc = "speed at which it goes wrong"});
  }

  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    return similitude::select(s.slip_speed > V(slip), V(std::numeric_limits<double>::quiet_NaN()), stokes_exchange(s));
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(Tripwire, "tripwire", "1.0.0", "A drag law that goes wrong on purpose")
