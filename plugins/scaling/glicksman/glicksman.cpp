#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Glicksman, Hyre & Woloshun (1993), simplified set: a smaller bed in the same gas with the same particle density; the
/// diameter is the one whose minimum fluidisation velocity has shrunk with all other speeds.
struct Glicksman {
  double geometry;                               // [-], r
  double minimum_fluidization_velocity;          // [m/s], of the real bed; NaN: not given
  double gas_fraction_at_minimum_fluidization;   // [-]; NaN: not given

  static void parameters(Parameters<Glicksman>& p) {
    using L = Glicksman;
    p.real("geometry", &L::geometry,
           {.min = 0.001, .max = 1, .typical_min = 1.0 / 16, .typical_max = 1, .doc = "Simulated over real bed length."});
    p.real("minimum_fluidization_velocity", &L::minimum_fluidization_velocity,
           {.unit = "m/s", .def = not_given, .min = 0,
            .doc = "Superficial, of the real bed; the gas fraction at minimum fluidization follows from it by Ergun."});
    p.real("gas_fraction_at_minimum_fluidization", &L::gas_fraction_at_minimum_fluidization,
           {.def = not_given, .min = 0.2, .max = 0.85, .typical_min = 0.38, .typical_max = 0.5,
            .doc = "Of the bed that is just carried; 0.42 if the velocity is not given either."});
  }

  void prepare() {
    if (!std::isnan(minimum_fluidization_velocity) && !std::isnan(gas_fraction_at_minimum_fluidization)) {
      throw std::invalid_argument(
          "minimum_fluidization_velocity, gas_fraction_at_minimum_fluidization: either follows from the other.\n"
          "  Leave one of the two out.");
    }
  }

  double gas_fraction(const SphereInGas& sphere) const {
    if (!std::isnan(gas_fraction_at_minimum_fluidization)) return gas_fraction_at_minimum_fluidization;
    if (std::isnan(minimum_fluidization_velocity)) return k_gas_fraction_at_minimum;
    const double eps = gas_fraction_ergun(sphere, minimum_fluidization_velocity);
    if (!(eps > 0)) {
      throw std::invalid_argument(
          "minimum_fluidization_velocity: by Ergun no bed of these particles is so hard to lift.\n"
          "  Check the velocity (superficial), and the particle's density and diameter.");
    }
    return eps;
  }

  /// Ergun's balance of a bed scaled by r and n, in the same gas, divided by the real one's units: with Re and Ar at the real
  /// minimum of fluidisation, Ar n^2 - (1.75 r Re^2 / eps^3) n - 150 (1 - eps) sqrt(r) Re / eps^3 = 0. Between n = r (inertia
  /// alone) and n = r^(1/4) (viscosity alone).
  double diameter(const SphereInGas& sphere) const {
    const double eps = gas_fraction(sphere), cube = eps * eps * eps;
    const double re = reynolds(sphere, minimum_fluidisation_ergun(sphere, eps));
    const double square = archimedes(sphere);
    const double linear = k_ergun_inertial * geometry * (re * re) / cube;
    const double constant = k_ergun_viscous * (1 - eps) * std::sqrt(geometry) * re / cube;
    return (linear + std::sqrt(linear * linear + 4 * square * constant)) / (2 * square);
  }

  Ratios ratios(const Bed& real) const {
    require_heavy_particles(real, "glicksman");
    Ratios r = froude_scaled(geometry, diameter(sphere_in_gas(real)));
    keep_softness(r);
    return r;
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(Glicksman, "glicksman", "1.0.0", "Smaller bed, same gas and solid, same u0/u_mf", "Similitude authors",
                       "Glicksman, Hyre & Woloshun (1993), Powder Technol. 77, 177")
