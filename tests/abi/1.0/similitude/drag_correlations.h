#pragma once
/// Formulas that several drag laws of dense beds share, each once. What is called a factor is a drag over Stokes'
/// 3 pi mu d of the same slip, model A, a function of the gas fraction eps in (0, 1] and of
///
///   reynolds     Re = rho_f d |u - v| / mu, with the interstitial slip, as particle_reynolds() gives it
///   superficial  eps Re
///
/// All are finite at Re = 0 and at eps = 1. phi = 1 - eps.

#include <similitude/drag_law.h>

namespace similitude {

/// Packed beds: beta/phi = 150 phi mu / (eps d^2) + 1.75 rho_f |u - v| / d, over 18 mu / d^2.
/// Ergun (1952), Chem. Eng. Prog. 48, 89.
template <class V>
V ergun_factor(const V& reynolds, const V& gas_fraction) {
  return (150.0 * (1.0 - gas_fraction) / gas_fraction + 1.75 * reynolds) / 18.0;
}

/// By how much neighbours raise a sphere's drag: eps^-2.65 with the superficial Reynolds number.
/// Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100.
template <class V>
V wen_yu_hindrance(const V& gas_fraction) {
  return pow(gas_fraction, V(-2.65));
}

/// Fluidised beds: Schiller and Naumann's sphere at the superficial Reynolds number, hindered. Wen & Yu (1966).
template <class V>
V wen_yu_factor(const V& reynolds, const V& gas_fraction) {
  return schiller_naumann_factor(V(gas_fraction * reynolds)) * wen_yu_hindrance(gas_fraction);
}

/// exp(-(1.5 - log10 Re)^2 / 2), by which exponents of the gas fraction dip between viscous and inertial flow. Zero at
/// Re = 0, one at Re = 31.6. Di Felice (1994), Int. J. Multiphase Flow 20, 153.
template <class V>
V di_felice_dip(const V& superficial) {
  const V decades = 1.5 - log(superficial) / 2.302585092994046;   // ln 10; infinite at rest
  return exp(-0.5 * (decades * decades));
}

/// Random arrays in creeping flow, over Stokes' drag at the superficial velocity.
/// van der Hoef, Beetstra & Kuipers (2005), J. Fluid Mech. 528, 233.
template <class V>
V creeping_array(const V& gas_fraction) {
  const V solids_fraction = 1.0 - gas_fraction, squared = gas_fraction * gas_fraction;
  return 10.0 * solids_fraction / squared + squared * (1.0 + 1.5 * sqrt(solids_fraction));
}

/// Random arrays by the lattice-Boltzmann method. Beetstra, van der Hoef & Kuipers (2007), AIChE J. 53, 489. Their drag F
/// is over Stokes' at the superficial velocity: the factor is eps F. Re^-0.343 and Re^-(1+4 phi)/2 are multiplied out.
template <class V>
V beetstra_factor(const V& reynolds, const V& gas_fraction) {
  const V solids_fraction = 1.0 - gas_fraction, superficial = gas_fraction * reynolds;
  const V power = pow(superficial, V(0.5 + 2.0 * solids_fraction));
  const V onset = power / (power + pow(V(10), V(3.0 * solids_fraction)));
  const V inertia = (1.0 / gas_fraction + 3.0 * gas_fraction * solids_fraction) * superficial + 8.4 * pow(superficial, V(0.657));
  return gas_fraction *
         (creeping_array(gas_fraction) + 0.413 / 24 * onset * inertia / (gas_fraction * gas_fraction));
}

/// 1 + 3 sqrt(phi/2) + (135/64) phi ln phi + a phi over 1 + 0.681 phi + b phi^2 + c phi^3: random arrays up to phi = 0.4.
/// a, b and c are fitted. Hill, Koch & Ladd (2001), J. Fluid Mech. 448, 213 and 243. One at phi = 0.
template <class V>
V hill_koch_ladd_array(const V& solids_fraction, double a, double b, double c) {
  const V logarithm = log(select(solids_fraction > 0.0, solids_fraction, V(1)));   // phi ln phi tends to 0
  const V above =
      1.0 + 3.0 * sqrt(0.5 * solids_fraction) + 135.0 / 64 * (solids_fraction * logarithm) + a * solids_fraction;
  return above / (1.0 + solids_fraction * (0.681 + solids_fraction * (b + c * solids_fraction)));
}

/// 10 phi / eps^3: packed arrays in creeping flow. Carman (1937), Trans. Inst. Chem. Eng. 15, 150.
template <class V>
V carman_array(const V& gas_fraction) {
  return 10.0 * (1.0 - gas_fraction) / (gas_fraction * gas_fraction * gas_fraction);
}

/// Slope of the drag with the Reynolds number of the radius, eps Re / 2, in inertial flow: F_3 of Hill, Koch & Ladd (2001).
template <class V>
V hill_koch_ladd_slope(const V& gas_fraction) {
  const V squared = gas_fraction * gas_fraction;
  return 0.0673 + 0.212 * (1.0 - gas_fraction) + 0.0232 / (squared * squared * gas_fraction);
}

}  // namespace similitude
