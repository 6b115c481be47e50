#pragma once
/// One sphere in one gas: its dimensionless numbers and Ergun's minimum fluidisation, for whoever scales or audits a bed.

#include <cmath>

#include <similitude/abi.h>

namespace similitude {

/// All that a sphere's terminal and minimum fluidisation velocities depend on.
struct SphereInGas {
  double diameter;           // [m]
  double particle_density;   // [kg/m^3]
  double gas_density;        // [kg/m^3]
  double gas_viscosity;      // [Pa s]
  double gravity;            // [m/s^2]
};

/// With the diameter that drag laws see.
inline SphereInGas sphere_in_gas(const similitude_bed& bed) {
  return {bed.drag_diameter, bed.particle_density, bed.gas_density, bed.gas_viscosity, bed.gravity};
}

/// rho_f u d / mu
inline double reynolds(const SphereInGas& s, double speed) { return s.gas_density * speed * s.diameter / s.gas_viscosity; }

/// g rho_f (rho_p - rho_f) d^3 / mu^2
inline double archimedes(const SphereInGas& s) {
  return s.gravity * s.gas_density * (s.particle_density - s.gas_density) * (s.diameter * s.diameter * s.diameter) /
         (s.gas_viscosity * s.gas_viscosity);
}

/// Gas fraction of a bed of spheres at minimum fluidisation where nothing better is known.
inline constexpr double k_gas_fraction_at_minimum = 0.42;

/// Solids fraction of a settled bed of poured, frictional spheres, by which a count of particles becomes a height.
inline constexpr double k_settled_packing = 0.58;

/// Constants of Ergun (1952), Chem. Eng. Prog. 48, 89. A bed is just carried when
/// (150 (1 - eps) Re + 1.75 Re^2) / eps^3 = Ar, Re superficial.
inline constexpr double k_ergun_viscous = 150, k_ergun_inertial = 1.75;

/// [m/s], superficial; Ergun's root without cancellation for small Ar.
inline double minimum_fluidisation_ergun(const SphereInGas& s, double gas_fraction) {
  const double viscous = k_ergun_viscous * (1 - gas_fraction);
  const double driving = gas_fraction * gas_fraction * gas_fraction * archimedes(s);
  const double re = 2 * driving / (viscous + std::sqrt(viscous * viscous + 4 * k_ergun_inertial * driving));
  return re * s.gas_viscosity / (s.gas_density * s.diameter);
}

/// [-], the gas fraction at which Ergun's bed is just carried at a superficial velocity [m/s], by bisection to the last bit;
/// NaN if the velocity would carry a bed of any gas fraction below 1.
inline double gas_fraction_ergun(const SphereInGas& s, double minimum_velocity) {
  const double re = reynolds(s, minimum_velocity), ar = archimedes(s);
  const auto carried = [&](double eps) {
    return k_ergun_viscous * (1 - eps) * re + k_ergun_inertial * re * re >= ar * (eps * eps * eps);
  };
  if (!(re > 0) || carried(1)) return NAN;
  double low = 0, high = 1;
  for (double middle = 0.5; low < middle && middle < high; middle = 0.5 * (low + high))
    (carried(middle) ? low : high) = middle;
  return high;
}

}  // namespace similitude
