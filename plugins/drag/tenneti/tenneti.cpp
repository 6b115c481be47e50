#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

/// Random arrays by an immersed-boundary method. Tenneti, Garg & Subramaniam (2011), Int. J. Multiphase Flow 37, 1072.
/// Their F contains the mean pressure gradient's share of the force, which model A has apart: eps^2 F here.
struct Tenneti {
  template <class V>
  V exchange(const DragState<V>& s) const {
    const V eps = s.gas_fraction, phi = 1.0 - eps, superficial = eps * particle_reynolds(s);
    const V cubed_eps = eps * eps * eps, cubed_phi = phi * phi * phi;
    const V drag = (schiller_naumann_factor(superficial) + 5.81 * phi + 0.48 * cbrt(phi) / eps) / cubed_eps +
                   cubed_phi * superficial * (0.95 + 0.61 * cubed_phi / (eps * eps));
    return stokes_exchange(s) * (eps * eps) * drag;
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(Tenneti, "tenneti", "1.0.0", "Tenneti, Garg and Subramaniam 2011, the paper's form", "Similitude authors",
                    "Tenneti, Garg & Subramaniam (2011), Int. J. Multiphase Flow 37, 1072")
