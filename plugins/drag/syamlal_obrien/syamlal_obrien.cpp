#include <similitude/drag_law.h>
#include <similitude/sphere_in_gas.h>

namespace {
using namespace similitude;

/// Dalla Valle's drag at the terminal velocity of a settling suspension. Syamlal & O'Brien (1987), AIChE annual meeting;
/// constants fitted to a known minimum fluidization velocity on request: Syamlal & O'Brien (2003), fitting procedure.
struct SyamlalOBrien {
  double c1;                                     // [-]
  double d1;                                     // [-]
  double minimum_fluidization_velocity;          // [m/s], superficial; NaN: constants as given
  double gas_fraction_at_minimum_fluidization;   // [-]

  static constexpr double k_default_c1 = 0.8, k_default_d1 = 2.65;
  static constexpr double k_joint = 0.85;          // [-], gas fraction where the two branches of B meet
  static constexpr double k_dense_power = 1.28;    // [-], B = c1 eps^1.28 up to the joint, eps^d1 beyond

  static void parameters(Parameters<SyamlalOBrien>& p) {
    using L = SyamlalOBrien;
    p.real("c1", &L::c1, {.def = k_default_c1, .min = 0.01, .max = 10, .typical_min = 0.3, .typical_max = 1.5,
                          .doc = "Constant of the dense branch."});
    p.real("d1", &L::d1, {.def = k_default_d1, .min = 0.1, .max = 20, .typical_min = 1, .typical_max = 8,
                          .doc = "Exponent of the dilute branch."});
    p.real("minimum_fluidization_velocity", &L::minimum_fluidization_velocity,
           {.unit = "m/s", .def = not_given, .min = 0,
            .doc = "Superficial velocity that must just carry the bed; c1 and d1 are fitted to it."});
    p.real("gas_fraction_at_minimum_fluidization", &L::gas_fraction_at_minimum_fluidization,
           {.def = 0.42, .min = 0.2, .max = 0.85, .typical_min = 0.38, .typical_max = 0.5,
            .doc = "Gas fraction of the bed that is just carried."});
  }

  void prepare(const Bed& bed) {
    if (std::isnan(minimum_fluidization_velocity)) return;
    if (c1 != k_default_c1 || d1 != k_default_d1) {
      throw std::invalid_argument(
          "c1, d1: given together with minimum_fluidization_velocity, which sets them.\n"
          "  Leave out c1 and d1, or minimum_fluidization_velocity.");
    }
    fit(bed);
  }

  /// The bed's weight less buoyancy is carried when Re (0.63 sqrt(Re) / v_r + 4.8 / sqrt(v_r))^2 = 4/3 Ar, Re
  /// interstitial: a quadratic equation for 1 / sqrt(v_r). Then B from v_r and c1 from B; d1 keeps B continuous.
  void fit(const Bed& bed) {
    const double eps = gas_fraction_at_minimum_fluidization;
    const double reynolds =
        bed.gas_density * bed.drag_diameter * (minimum_fluidization_velocity / eps) / bed.gas_viscosity;
    const double a = 0.63 * sqrt(reynolds), carried = sqrt(4 * archimedes(sphere_in_gas(bed)) / (3 * reynolds));
    const double inverse_root = 2 * carried / (4.8 + sqrt(4.8 * 4.8 + 4 * a * carried));
    const double ratio = 1 / (inverse_root * inverse_root);
    const double slope = 0.06 * reynolds;
    const double b = ratio * (ratio + slope - pow(eps, 4.14)) / slope;
    if (!(b > 0) || !std::isfinite(b)) {
      throw std::invalid_argument(
          "minimum_fluidization_velocity: no c1 makes this bed fluidize at so low a velocity.\n"
          "  Check the velocity (superficial), the particle's density and diameter, and "
          "gas_fraction_at_minimum_fluidization.");
    }
    c1 = b / pow(eps, k_dense_power);
    d1 = k_dense_power + log(c1) / log(k_joint);
  }

  /// Terminal velocity of the suspension over a single sphere's [-] (Garside & Al-Dibouni 1977).
  template <class V>
  V velocity_ratio(const V& reynolds, const V& gas_fraction) const {
    const V a = pow(gas_fraction, V(4.14));
    const auto dense = gas_fraction <= k_joint;
    const V b = select(dense, V(c1), V(1)) * pow(gas_fraction, select(dense, V(k_dense_power), V(d1)));   // a power costs most
    const V slope = 0.06 * reynolds;
    return 0.5 * (a - slope + sqrt(slope * slope + 2.0 * slope * (2.0 * b - a) + a * a));
  }

  template <class V>
  V exchange(const DragState<V>& s) const {
    const V reynolds = particle_reynolds(s);
    const V ratio = velocity_ratio(reynolds, s.gas_fraction);
    return stokes_exchange(s) * s.gas_fraction * dalla_valle_factor(reynolds, ratio) / (ratio * ratio);
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(SyamlalOBrien, "syamlal_obrien", "1.0.0", "Syamlal and O'Brien, optionally fitted to u_mf",
                    "Similitude authors", "Syamlal & O'Brien (1987), AIChE annual meeting, Miami Beach")
