#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

/// Hill, Koch and Ladd's lattice-Boltzmann results for slow and for fast flow, dilute and packed, joined to one law.
/// Benyahia, Syamlal & O'Brien (2006), Powder Technol. 162, 166. Their Reynolds number is of the radius: eps Re / 2.
struct KochHillLadd {
  template <class V>
  V exchange(const DragState<V>& s) const {
    return stokes_exchange(s) * (s.gas_fraction * s.gas_fraction) *
           drag(V(1.0 - s.gas_fraction), s.gas_fraction, V(0.5 * s.gas_fraction * particle_reynolds(s)));
  }

  /// F of the paper: it grows as Re^2 in slow flow and as Re in fast, and is continuous in Re. [-]
  template <class V>
  static V drag(const V& phi, const V& eps, const V& reynolds) {
    const V packed = carman_array(eps);
    const V weight = exp(min(V(-10.0 * (0.4 - phi) / phi), V(0)));   // 0 at phi = 0, 1 from phi = 0.4 on
    const V slow = (1.0 - weight) * hill_koch_ladd_array(phi, 17.14, -8.48, 8.16) + weight * packed;      // F_0
    const V fast = (1.0 - weight) * hill_koch_ladd_array(phi, 17.89, -11.03, 15.41) + weight * packed;    // F_2
    const V curvature = select(phi <= 0.1, sqrt(2.0 / phi) / 40.0, 0.11 + 5.1e-4 * exp(11.6 * phi));      // F_1
    const V slope = select(phi < 0.0953, 0.9351 * phi + 0.03667, hill_koch_ladd_slope(eps));              // F_3
    const V inertial = fast + slope * reynolds;

    const V dilute_turn = (fast - 1.0) / (0.375 - slope);
    const V dilute = select(reynolds <= dilute_turn, 1.0 + 0.375 * reynolds, inertial);
    const V turn = (slope + sqrt(slope * slope - 4.0 * curvature * (slow - fast))) / (2.0 * curvature);
    const V dense = select(reynolds <= turn, slow + curvature * (reynolds * reynolds), inertial);
    return select(phi <= 0.01, dilute, dense);
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(KochHillLadd, "koch_hill_ladd", "1.0.0",
                    "Hill, Koch and Ladd over all Reynolds numbers, Benyahia's form as in MFIX", "Similitude authors",
                    "Benyahia, Syamlal & O'Brien (2006), Powder Technol. 162, 166")
