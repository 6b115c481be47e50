#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

/// Random arrays by the lattice-Boltzmann method, one straight line in the Reynolds number: the short form that CFDEM and
/// Lethe use. Koch & Hill (2001), Annu. Rev. Fluid Mech. 33, 619; van Buijtenen et al. (2011), Chem. Eng. Sci. 66, 2368.
struct KochHill {
  template <class V>
  V exchange(const DragState<V>& s) const {
    const V eps = s.gas_fraction, solids_fraction = 1.0 - eps;
    const V creeping =
        select(solids_fraction < 0.4, hill_koch_ladd_array(solids_fraction, 16.14, -8.48, 8.16), carman_array(eps));
    const V of_radius = 0.5 * eps * particle_reynolds(s);
    return stokes_exchange(s) * (eps * eps) * (creeping + hill_koch_ladd_slope(eps) * of_radius);
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(KochHill, "koch_hill", "1.0.0", "Koch and Hill, the short form as in CFDEM", "Similitude authors",
                    "Koch & Hill (2001), Annu. Rev. Fluid Mech. 33, 619; van Buijtenen et al. (2011), Chem. Eng. Sci. 66, 2368")
