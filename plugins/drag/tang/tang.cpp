#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

/// Random arrays with resolved boundary layers. Tang, Peters, Kuipers, Kriebitzsch & van der Hoef (2015), AIChE J. 61, 688.
/// Their F is over Stokes' drag at the superficial velocity: times eps here.
struct Tang {
  template <class V>
  V exchange(const DragState<V>& s) const {
    const V eps = s.gas_fraction, phi = 1.0 - eps, superficial = eps * particle_reynolds(s);
    const V fourth = (eps * eps) * (eps * eps);
    const V inertia = (0.11 * phi * (1.0 + phi) - 0.00456 / fourth) * superficial +
                      (0.169 * eps + 0.0644 / fourth) * pow(superficial, V(0.657));   // Re^-0.343 Re
    return stokes_exchange(s) * eps * (creeping_array(eps) + inertia);
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(Tang, "tang", "1.0.0", "Tang et al. 2015, static spheres of one size", "Similitude authors",
                    "Tang, Peters, Kuipers, Kriebitzsch & van der Hoef (2015), AIChE J. 61, 688")
