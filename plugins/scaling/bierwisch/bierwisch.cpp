#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Coarse grains of Bierwisch et al. (2009): springs n times as stiff, moduli kept, so that stress, energy density and the
/// overlap over the diameter are kept.
struct Bierwisch {
  double n;                      // [-]
  bool restitution_correction;

  static void parameters(Parameters<Bierwisch>& p) {
    p.real("n", &Bierwisch::n,
           {.min = 1, .max = 100, .typical_min = 1, .typical_max = 4, .doc = "Diameter of a grain over that of its particles."});
    p.flag("restitution_correction", &Bierwisch::restitution_correction,
           {.def = false, .doc = "Whether grains lose n times as much energy per collision, for they collide n times less often."});
  }

  Ratios ratios(const Bed&) const {
    Ratios r = coarse_grains(n);
    r.stiffness = n;   // the modulus stays
    if (restitution_correction) r.energy_loss = dissipation_kept(n);
    return r;
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(Bierwisch, "bierwisch", "1.0.0", "Coarse grains with n times the stiffness",
                       "Similitude authors", "Bierwisch, Kraft, Riedel & Moseler (2009), J. Mech. Phys. Solids 57, 10")
