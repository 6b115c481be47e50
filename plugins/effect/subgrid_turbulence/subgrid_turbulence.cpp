#include <similitude/effect.h>

namespace {

using similitude::GasCell;

/// Eddy viscosity of the motion below the cells. Smagorinsky 1963, Mon. Weather Rev. 91, 99.
struct SubgridTurbulence {
  double smagorinsky;   // [-]

  static void parameters(similitude::Parameters<SubgridTurbulence>& p) {
    p.real("smagorinsky", &SubgridTurbulence::smagorinsky,
           {.unit = "1", .def = 0.17, .min = 0, .max = 0.35, .typical_min = 0.05, .typical_max = 0.25,
            .doc = "Smagorinsky's constant: 0.17 in isotropic turbulence, 0.1 in shear flows",
            .reference = "Lilly 1967, IBM Sci. Comput. Symp. Environ. Sci., 195; Deardorff 1970, J. Fluid Mech. 41, 453"});
  }

  template <class V>
  V added_viscosity(const GasCell<V>& cell) const {   // [Pa s], rho (C_s Delta)^2 sqrt(2 S:S)
    const V mixing_length = smagorinsky * cell.cell_size;
    return cell.gas_density * mixing_length * mixing_length * cell.strain_rate;
  }

  /// Reynolds number of the widest shear that the inlets make, Re = rho U w / mu, w = 2 U / shear rate.
  similitude::Relevance relevance(const similitude::Evidence& evidence) const {
    constexpr double k_mixing_transition = 1e4;
    const similitude::Bed& bed = evidence.bed;
    similitude::Relevance r;
    r.group = "Re_jet";
    r.source = "Dimotakis 2000, J. Fluid Mech. 409, 69: mixing transition";
    r.threshold = k_mixing_transition;
    const double speed = bed.largest_inlet_velocity;
    r.value = bed.largest_shear_rate > 0 ? bed.gas_density * speed * (2 * speed / bed.largest_shear_rate) / bed.gas_viscosity : 0;
    r.verdict = r.value > r.threshold ? similitude::Verdict::needed : similitude::Verdict::negligible;
    return r;
  }
};

}  // namespace

SIMILITUDE_EFFECT(SubgridTurbulence, "subgrid_turbulence", "1.0.0", "Eddy viscosity of motion below the cells", nullptr,
                  "Smagorinsky 1963, Mon. Weather Rev. 91, 99")
