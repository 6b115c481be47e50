#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Glicksman (1984), full set: a smaller bed of smaller particles, as many as in the real one, in a gas and of a solid that
/// keep every group. With gas_density 1 only the viscosity changes; left out, the viscosity stays and the densities change.
struct GlicksmanFull {
  double geometry;      // [-], r = n
  double gas_density;   // [-], simulated over real; NaN: the viscosity stays

  static void parameters(Parameters<GlicksmanFull>& p) {
    using L = GlicksmanFull;
    p.real("geometry", &L::geometry, {.min = 0.001, .max = 1000, .typical_min = 1.0 / 16, .typical_max = 1,
                                      .doc = "Simulated over real length, particles included."});
    p.real("gas_density", &L::gas_density,
           {.def = not_given, .min = 1e-6, .max = 1e6,
            .doc = "Simulated over real gas density; left out, it is the one at which the viscosity stays."});
  }

  Ratios ratios(const Bed& real) const {
    if (!std::isnan(gas_density)) return similar_bed(real, geometry, geometry, gas_density);
    Ratios r = similar_bed(real, geometry, geometry, 1 / (geometry * std::sqrt(geometry)));
    r.gas_viscosity = 1;   // to the last bit
    return r;
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(GlicksmanFull, "glicksman_full", "1.0.0", "A smaller bed that keeps every group, particles as many",
                       "Similitude authors", "Glicksman (1984), Chem. Eng. Sci. 39, 1373")
