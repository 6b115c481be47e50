#pragma once
/// The motion of one brick's particles over a sub-step, semi-implicit (symplectic) Euler: forces from (x, v) of the
/// sub-step's start, then
///
///   v' = (v + dt g + dt/m (F_contact + F_stress + K u)) / (1 + dt (K/m + damping))
///   x' = x + dt v'
///   w' = (w + dt/I T) / (1 + dt damping)
///
/// so drag K (u - v') and damping are implicit, stable for any K, and the impulse dt K (u - v') that the particle received
/// is what the gas is charged. Added mass m_a moves with its particle: m becomes m + m_a in every quotient, but not in the
/// weight, and what it takes, m_a (v' - v), goes to the gas.

#include <array>
#include <cstdint>

#include "particles/store.h"

namespace similitude {

struct Motion {
  double dt = 0;                    // [s]
  std::array<double, 3> gravity{};  // [m/s^2]
  double velocity_damping = 0;      // [1/s]
};

/// What pushed the rows, summed: x, y, z of forces [N]; of powers [W] the parts of the three components.
struct MotionSums {
  Row drag, stress;                               // w: no meaning
  Row mass;                                       // w: mass [kg]; x, y, z: no meaning
  Row gravity_power, drag_power, stress_power, contact_power;   // with the mean of the velocities before and after
};

struct MotionResult {
  double largest_speed_squared = 0;   // [m^2/s^2], at the end of the sub-step
  bool finite = true;                 // false: some position or velocity is not a number or infinite
  MotionSums sums;
};

/// Moves rows [begin, end). Spin is advanced only if `rotation`: a law without it leaves spin as it was. [worker]
MotionResult integrate(ParticleStore& particles, std::uint32_t begin, std::uint32_t end, const Motion& motion, bool rotation);

/// [m^2], the largest squared distance between positions and `reference` over rows [begin, end). [worker]
double largest_displacement_squared(const ParticleStore& particles, const Column<Row>& reference, std::uint32_t begin,
                                    std::uint32_t end);

}  // namespace similitude
