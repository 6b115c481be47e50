#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Coarse grains of Sakai & Koshizuka (2009): a grain feels n^3 times the contact force of a particle at the same overlap, so
/// that impacts last as long and kinetic and elastic energy are kept.
struct CoarseGrain {
  double n;                      // [-]
  bool restitution_correction;

  static void parameters(Parameters<CoarseGrain>& p) {
    p.real("n", &CoarseGrain::n,
           {.min = 1, .max = 100, .typical_min = 1, .typical_max = 4, .doc = "Diameter of a grain over that of its particles."});
    p.flag("restitution_correction", &CoarseGrain::restitution_correction,
           {.def = false, .doc = "Whether grains lose n times as much energy per collision, for they collide n times less often."});
  }

  Ratios ratios(const Bed&) const {
    Ratios r = coarse_grains(n);
    r.stiffness = n * n * n;
    r.modulus = n * n * std::sqrt(n);   // Hertz: F grows with E sqrt(d)
    if (restitution_correction) r.energy_loss = dissipation_kept(n);
    return r;
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(CoarseGrain, "coarse_grain", "1.0.0", "Coarse grains with n^3 times the stiffness",
                       "Similitude authors", "Sakai & Koshizuka (2009), Chem. Eng. Sci. 64, 533")
