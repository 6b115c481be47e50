#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Parcels: the real bed with grains n times as large, each for n^3 particles. The gas sees the particles, collisions see the
/// parcel, with the spring that the case gives. As in the dense discrete phase models of Ansys Fluent.
struct Parcel {
  double n;                      // [-]
  bool restitution_correction;

  static void parameters(Parameters<Parcel>& p) {
    p.real("n", &Parcel::n,
           {.min = 1, .max = 100, .typical_min = 1, .typical_max = 4, .doc = "Diameter of a grain over that of its particles."});
    p.flag("restitution_correction", &Parcel::restitution_correction,
           {.def = false, .doc = "Whether grains lose n times as much energy per collision, for they collide n times less often."});
  }

  Ratios ratios(const Bed&) const {
    Ratios r = coarse_grains(n);   // stiffness and modulus stay as given
    if (restitution_correction) r.energy_loss = dissipation_kept(n);
    return r;
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(Parcel, "parcel", "1.0.0", "Parcels of n^3 particles, springs as given",
                       "Similitude authors", "Ansys Fluent Theory Guide, dense discrete phase model with DEM collisions")
