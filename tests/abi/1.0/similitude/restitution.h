#pragma once
/// Damping of a linear spring-dashpot from the restitution of a head-on impact, and how long the impact takes.
/// x'' + 2 zeta w0 x' + w0^2 x = 0 while in contact, with w0 = sqrt(k / m*). Times in units of 1/w0.

#include <cmath>

namespace similitude {

inline constexpr double k_pi = 3.14159265358979323846;

/// Damping ratio zeta [-] when the dashpot may pull the partners together before they part:
/// zeta = -ln e / sqrt(pi^2 + ln^2 e). Restitution in (0, 1].
inline double damping_ratio(double restitution) {
  const double loss = std::log(restitution);
  return -loss / std::sqrt(k_pi * k_pi + loss * loss);
}

/// Duration of an impact [1/w0] that ends when the overlap is back at zero: pi / sqrt(1 - zeta^2).
inline double impact_duration(double damping_ratio) { return k_pi / std::sqrt(1 - damping_ratio * damping_ratio); }

/// Duration of an impact [1/w0] that ends when the force is back at zero, for partners that never attract each other
/// (Schwager & Poeschel 2007, Granular Matter 9, 465). With zeta = cos a the force vanishes at w0 t sin a = 2 a; beyond
/// critical damping a is imaginary and the same holds with acosh.
inline double impact_duration_without_attraction(double damping_ratio) {
  const double distance = damping_ratio - 1;   // from critical damping
  if (std::abs(distance) < 1e-6) return 2 - 2 * distance / 3;   // both branches tend to this; the rest is O(1e-12)
  return distance < 0 ? 2 * std::acos(damping_ratio) / std::sqrt(1 - damping_ratio * damping_ratio)
                      : 2 * std::acosh(damping_ratio) / std::sqrt(damping_ratio * damping_ratio - 1);
}

/// Restitution that follows: e = exp(-zeta t), t the duration above.
inline double restitution_without_attraction(double damping_ratio) {
  return std::exp(-damping_ratio * impact_duration_without_attraction(damping_ratio));
}

/// Damping ratio zeta [-] when the force is cut off at zero: the inverse of the above, by bisection. Restitution in (0, 1].
inline double damping_ratio_without_attraction(double restitution) {
  if (restitution >= 1) return 0;
  double low = 0, high = 1;
  while (restitution_without_attraction(high) > restitution) high *= 2;
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high)) {
    (restitution_without_attraction(middle) > restitution ? low : high) = middle;
  }
  return high;
}

/// Largest stable step [1/w0] of a damped spring under explicit time stepping: w0 dt < 2 (sqrt(1 + zeta^2) - zeta).
/// Holds for semi-implicit Euler and leapfrog with the damping taken at the last known velocity.
inline double stable_step(double damping_ratio) {
  return 2 * (std::sqrt(1 + damping_ratio * damping_ratio) - damping_ratio);
}

/// In a packed bed a particle swings against all its neighbours at once. With Z equal contacts spread evenly, the sum of
/// k n n^T over them is Z k/3, and by Gershgorin no mode of the bed is faster than sqrt(Z/3) times a pair: twice for the twelve
/// neighbours that touch a sphere at most. The damping of that mode grows with it, zeta w/w0.
inline constexpr double k_fastest_mode = 2;   // [-], of a packed bed, over the frequency of one contact

/// Largest stable step [1/w0, w0 of one contact] in a packed bed.
inline double stable_step_in_a_bed(double damping_ratio) { return stable_step(k_fastest_mode * damping_ratio) / k_fastest_mode; }

}  // namespace similitude
