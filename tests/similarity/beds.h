#pragma once
/// The bed of Sutkar et al. (2013) as read from its case, and the ratios of the laws that tests know by heart.

#include <cmath>

#include "../scene/case_text.h"
#include "similarity/ratios.h"

namespace similitude::testing {

inline RealScene spouted_bed(const std::vector<std::string>& overrides = {}) {
  return read_text_case(k_example, overrides).scene;
}

/// Keeps Fr, Re, Ar with one free density ratio: u* = t* = sqrt(r), mu* = rho_f* n sqrt(r), (rho_p - rho_f)* = rho_f*
/// r/n.
inline similitude_ratios similar(double length, double diameter, double gas_density, double particle_density,
                                 double viscosity) {
  similitude_ratios ratios = identity_ratios();
  ratios.length = length;
  ratios.diameter = ratios.drag_diameter = diameter;
  ratios.particle_density = particle_density;
  ratios.gas_density = gas_density;
  ratios.gas_viscosity = viscosity;
  ratios.velocity = ratios.time = std::sqrt(length);
  ratios.stiffness = particle_density * length * diameter;
  ratios.modulus = particle_density * length;
  return ratios;
}

/// The u_t law: mu* = rho_p* = 1, so rho_f* = 1/(n sqrt r) and rho_p n^2 - (rho_f/sqrt r) n - sqrt r (rho_p - rho_f) =
/// 0.
inline similitude_ratios terminal_velocity_law(double r, double particle_density, double gas_density) {
  const double b = gas_density / std::sqrt(r), c = std::sqrt(r) * (particle_density - gas_density);
  const double n = (b + std::sqrt(b * b + 4 * particle_density * c)) / (2 * particle_density);
  return similar(r, n, 1 / (n * std::sqrt(r)), 1, 1);
}

/// n = r = 1/4 with both densities kept: every ratio is a power of two.
inline similitude_ratios exact_quarter() { return similar(0.25, 0.25, 1, 1, 0.125); }

}  // namespace similitude::testing
