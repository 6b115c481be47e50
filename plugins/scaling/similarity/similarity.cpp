#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Every bed that keeps Fr, Re and Ar, and with them u0/u_mf and u0/u_t of any drag law: lengths r, diameters n and one of
/// the two densities are free. Link's law and the terminal-velocity law are members.
struct Similarity {
  double geometry;           // [-], r
  double n;                  // [-]
  double gas_density;        // [-], simulated over real; NaN: not given
  double particle_density;   // [-], simulated over real; NaN: not given

  static void parameters(Parameters<Similarity>& p) {
    using L = Similarity;
    p.real("geometry", &L::geometry,
           {.min = 0.001, .max = 1000, .typical_min = 1.0 / 16, .typical_max = 1, .doc = "Simulated over real bed length."});
    p.real("n", &L::n, {.min = 0.001, .max = 1000, .typical_min = 0.1, .typical_max = 4,
                        .doc = "Simulated over real particle diameter; the particles are (geometry / n)^3 as many."});
    p.real("gas_density", &L::gas_density,
           {.def = not_given, .min = 1e-6, .max = 1e6, .doc = "Simulated over real gas density; 1 if neither density is given."});
    p.real("particle_density", &L::particle_density,
           {.def = not_given, .min = 1e-6, .max = 1e6, .doc = "Simulated over real particle density, in place of gas_density."});
  }

  void prepare() {
    if (!std::isnan(gas_density) && !std::isnan(particle_density)) {
      throw std::invalid_argument(
          "gas_density, particle_density: either follows from the other.\n  Leave one of the two out.");
    }
  }

  Ratios ratios(const Bed& real) const {
    require_heavy_particles(real, "similarity");
    double gas = std::isnan(gas_density) ? 1 : gas_density;
    if (!std::isnan(particle_density)) gas = particle_density / similar_density_ratio(real, geometry, n);
    return similar_bed(real, geometry, n, gas);
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(Similarity, "similarity", "1.0.0", "Any bed of the same Fr, Re and Ar: free size, diameter and one density",
                       "Similitude authors")
