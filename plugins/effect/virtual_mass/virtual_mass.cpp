#include <similitude/drag_law.h>
#include <similitude/effect.h>

namespace {
using namespace similitude;

/// The gas that a sphere must move with it when it accelerates: F = C_m rho_f V (Du/Dt - dv/dt). Auton, Hunt & Prud'Homme
/// (1988), J. Fluid Mech. 197, 241. C_m = 1/2 of a single sphere; in a suspension Zuber (1964), Chem. Eng. Sci. 19, 897.
struct VirtualMass {
  enum class Crowding { single, zuber };
  double coefficient;   // [-], C_m of a single sphere
  Crowding crowding;

  static void parameters(Parameters<VirtualMass>& p) {
    p.real("coefficient", &VirtualMass::coefficient, {.def = 0.5, .min = 0, .typical_min = 0.4, .typical_max = 0.6, .doc = "C_m of a single sphere."});
    p.choice("crowding", &VirtualMass::crowding,
             {.choices = "single|zuber", .def = "single", .doc = "Whether neighbours raise it: zuber multiplies by (1 + 2 phi)/(1 - phi).",
              .reference = "Zuber (1964), Chem. Eng. Sci. 19, 897"});
  }

  unsigned reads() const { return SIMILITUDE_READS_GAS_ACCELERATION; }
  unsigned adds() const { return SIMILITUDE_ADDS_ADDED_MASS; }

  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    const V solids = 1.0 - p.gas_fraction;
    const V crowd = crowding == Crowding::zuber ? (1.0 + 2.0 * solids) / p.gas_fraction : V(1);
    const V moved = coefficient * crowd * p.gas_density * sphere_volume(p.diameter);
    return {.force = moved * p.gas_acceleration, .linear_coefficient = V(0), .added_mass = moved};
  }

  /// With C_m = 1/2 the threshold is a twentieth of the particle's own inertia.
  Relevance relevance(const Evidence& e) const {
    constexpr double k_threshold = 0.1;
    const double ratio = e.bed.gas_density / e.bed.particle_density;
    return {.verdict = ratio > k_threshold ? Verdict::needed : Verdict::negligible,
            .value = ratio,
            .threshold = k_threshold,
            .group = "rho_f/rho_p",
            .source = "half of it is the added inertia; below 5 % of the particle's own it hides in the drag's error"};
  }
};

}  // namespace

SIMILITUDE_EFFECT(VirtualMass, "virtual_mass", "1.0.0", "Added mass of accelerating particles", "Similitude authors",
                  "Auton, Hunt & Prud'Homme (1988), J. Fluid Mech. 197, 241")
