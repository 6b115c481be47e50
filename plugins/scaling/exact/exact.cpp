#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Nothing is given up: the real bed, or a smaller one that keeps every dimensionless group.
struct Exact {
  double geometry;   // [-], r

  static void parameters(Parameters<Exact>& p) {
    p.real("geometry", &Exact::geometry,
           {.def = 1, .min = 0.001, .max = 1000, .doc = "Simulated over real length, particles included."});
  }

  /// Both densities are kept, so every length scales as r, speeds and times as sqrt(r), and the viscosity must follow.
  Ratios ratios(const Bed& real) const { return similar_bed(real, geometry, geometry, 1); }
};

}  // namespace

SIMILITUDE_SCALING_LAW(Exact, "exact", "1.0.0", "The real bed, or an exactly similar one", "Similitude authors")
