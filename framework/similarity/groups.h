#pragma once
/// Dimensionless groups of a gas-solid bed and the speeds they rest on. Each formula stands once, with its source.

#include <functional>

#include <similitude/abi.h>
#include <similitude/sphere_in_gas.h>

namespace similitude {

/// C_D of Schiller & Naumann, and of Dalla Valle, the single-particle limit of Syamlal-O'Brien: those of drag_law.h.
double schiller_naumann(double reynolds);
double dalla_valle(double reynolds);

/// [m/s], sqrt(3 g d (rho_p - rho_f)/rho_f): Newton's regime, C_D = 4/9; Eq. 18 of the u_t law. Too high below Re ~ 750.
double terminal_velocity_newton(const SphereInGas& sphere);
/// [m/s], from C_D Re^2 = 4/3 Ar by bisection to the last bit; C_D Re^2 must grow with Re.
double terminal_velocity(const SphereInGas& sphere, const std::function<double(double)>& drag_coefficient);

/// [m/s], Wen & Yu (1966), AIChE J. 12, 610: Re = sqrt(33.7^2 + 0.0408 Ar) - 33.7.
double minimum_fluidisation_wen_yu(const SphereInGas& sphere);

/// L is the bed's width, u0 the mean superficial velocity, u_jet the largest inlet velocity, d what drag laws see except in L/d.
struct Groups {
  double froude = 0;                // u0^2 / (g L)
  double reynolds = 0;              // rho_f u0 d / mu
  double archimedes = 0;
  double stokes = 0;                // rho_p d^2 u0 / (18 mu L)
  double density_ratio = 0;         // rho_p / rho_f
  double buoyant_density_ratio = 0; // (rho_p - rho_f) / rho_f
  double length_ratio = 0;          // L / d, of what touches
  double jet = 0;                   // rho_f u_jet^2 / ((rho_p - rho_f) g L): jet momentum over bed weight, per solids fraction
  double over_minimum = 0;          // u0 / u_mf, Ergun
  double over_terminal = 0;         // u0 / u_t, Schiller-Naumann
  double over_terminal_newton = 0;  // u0 / u_t, C_D = 4/9
};

/// Of a bed with particles and gravity; groups with u0 are 0 if nothing is blown in at the bottom.
Groups groups(const similitude_bed& bed, double gas_fraction_at_minimum = k_gas_fraction_at_minimum);

}  // namespace similitude
