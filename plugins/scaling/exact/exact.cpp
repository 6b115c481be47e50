#include <similitude/scaling_law.h>

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
  Ratios ratios(const Bed&) const {
    const double r = geometry, root = std::sqrt(r);
    return {.length = r, .diameter = r, .drag_diameter = r, .gas_viscosity = r * root, .velocity = root, .time = root,
            .stiffness = r * r, .modulus = r};
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(Exact, "exact", "1.0.0", "The real bed, or an exactly similar one", "Similitude authors")
