#include "similarity/groups.h"

#include <cmath>

#include <similitude/drag_law.h>

namespace similitude {

double schiller_naumann(double reynolds) { return schiller_naumann<double>(reynolds); }
double dalla_valle(double reynolds) { return dalla_valle<double>(reynolds); }

double terminal_velocity_newton(const SphereInGas& s) {
  return std::sqrt(3 * s.gravity * s.diameter * (s.particle_density - s.gas_density) / s.gas_density);
}

double terminal_velocity(const SphereInGas& s, const std::function<double(double)>& drag_coefficient) {
  const double weight = archimedes(s) * 4 / 3;
  const auto too_slow = [&](double re) { return drag_coefficient(re) * re * re < weight; };
  double low = 0, high = archimedes(s) / 18;  // Stokes
  while (too_slow(high)) high *= 2;           // laws that fall below 24/Re, as Dalla Valle's 23.04/Re
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (too_slow(middle) ? low : high) = middle;
  }
  return high * s.gas_viscosity / (s.gas_density * s.diameter);
}

double minimum_fluidisation_wen_yu(const SphereInGas& s) {
  const double driving = 0.0408 * archimedes(s);
  const double re = driving / (std::sqrt(33.7 * 33.7 + driving) + 33.7);
  return re * s.gas_viscosity / (s.gas_density * s.diameter);
}

Groups groups(const similitude_bed& bed, double gas_fraction_at_minimum) {
  const SphereInGas sphere = sphere_in_gas(bed);
  const double u0 = bed.superficial_velocity, length = bed.bed_width;
  const double buoyant_density = bed.particle_density - bed.gas_density;
  Groups g;
  g.froude = u0 * u0 / (bed.gravity * length);
  g.reynolds = reynolds(sphere, u0);
  g.archimedes = archimedes(sphere);
  g.stokes = bed.particle_density * (sphere.diameter * sphere.diameter) * u0 / (18 * bed.gas_viscosity * length);
  g.density_ratio = bed.particle_density / bed.gas_density;
  g.buoyant_density_ratio = buoyant_density / bed.gas_density;
  g.length_ratio = length / bed.particle_diameter;
  g.jet = bed.gas_density * (bed.largest_inlet_velocity * bed.largest_inlet_velocity) /
          (buoyant_density * bed.gravity * length);
  g.over_minimum = u0 / minimum_fluidisation_ergun(sphere, gas_fraction_at_minimum);
  g.over_terminal = u0 / terminal_velocity(sphere, schiller_naumann<double>);
  g.over_terminal_newton = u0 / terminal_velocity_newton(sphere);
  return g;
}

}  // namespace similitude
