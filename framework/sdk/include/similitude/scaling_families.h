#pragma once
/// What several scaling laws share: beds similar to the real one, and grains that stand for many particles. Each identity
/// stands here once.

#include <stdexcept>
#include <string>

#include <similitude/scaling_law.h>
#include <similitude/sphere_in_gas.h>

namespace similitude {

/// Throws with the law's name if the bed has no particles or they do not sink in their gas.
inline void require_heavy_particles(const Bed& real, const char* law) {
  if (real.particle_density > real.gas_density && real.particle_diameter > 0) return;
  throw std::invalid_argument(std::string(law) +
                              " needs particles heavier than their gas.\n  Check scene.particles and scene.gas.density.");
}

/// Particle density of a similar bed over its gas density, both as ratios: with (rho_p - rho_f)* = rho_f* r/n,
/// rho_p* / rho_f* = r/n + (1 - r/n) rho_f/rho_p. Exactly 1 for n = r, also of a bed without particles.
inline double similar_density_ratio(const Bed& real, double length, double diameter) {
  if (length == diameter) return 1;
  const double heavier = length / diameter;
  return heavier + (1 - heavier) * (real.gas_density / real.particle_density);
}

/// The springs and moduli that keep the overlap over the diameter, under impact and under the bed's weight alike:
/// K* = rho_p* r n, E* = rho_p* r.
inline void keep_softness(Ratios& r) {
  r.stiffness = r.particle_density * r.length * r.diameter;
  r.modulus = r.particle_density * r.length;
}

/// Lengths r, diameters n; speeds and times sqrt(r), which keeps the Froude number. Densities, viscosity and with them the
/// softness are still to be set.
inline Ratios froude_scaled(double length, double diameter) {
  const double root = std::sqrt(length);
  return {.length = length, .diameter = diameter, .drag_diameter = diameter, .velocity = root, .time = root};
}

/// The bed of lengths r, diameters n and gas density rho_f* that keeps Fr, Re and Ar: mu* = rho_f* n sqrt(r) and
/// (rho_p - rho_f)* = rho_f* r/n. u_mf and u_t of any drag law C_D(Re, eps) depend on Ar alone, so u0/u_mf and u0/u_t stay too.
inline Ratios similar_bed(const Bed& real, double length, double diameter, double gas_density) {
  Ratios r = froude_scaled(length, diameter);
  r.gas_density = gas_density;
  r.gas_viscosity = gas_density * diameter * r.velocity;
  r.particle_density = gas_density * similar_density_ratio(real, length, diameter);
  keep_softness(r);
  return r;
}

/// Grains n times as large in the real bed, each for n^3 particles; the gas sees n^3 particles of the real diameter.
/// How hard the grains are is the law's own choice.
inline Ratios coarse_grains(double n) { return {.diameter = n, .parcel_weight = n * n * n}; }

/// (1 - e^2)* of grains that dissipate as much as what they stand for. In a collisional flow the loss per volume is
/// 12 (1 - e^2) rho_p phi^2 g_0 T^(3/2) / (d sqrt(pi)), so with d n times larger each collision must lose n times as much; the
/// idea is that of Benyahia & Galvin (2010), Ind. Eng. Chem. Res. 49, 10588. Not for a packing, where nothing collides.
inline double dissipation_kept(double n) { return n; }

}  // namespace similitude
