#include <similitude/drag_correlations.h>

namespace {

/// Random arrays by the lattice-Boltzmann method. Beetstra, van der Hoef & Kuipers (2007), AIChE J. 53, 489.
struct Beetstra {
  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    return stokes_exchange(s) * similitude::beetstra_factor(particle_reynolds(s), s.gas_fraction);
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(Beetstra, "beetstra", "1.0.0", "Beetstra, van der Hoef and Kuipers 2007, spheres of one size",
                    "Similitude authors", "Beetstra, van der Hoef & Kuipers (2007), AIChE J. 53, 489")
