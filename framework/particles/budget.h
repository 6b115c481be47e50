#pragma once
/// What gave the particles their momentum and their energy: impulses and works of every kind of force, added up sub-step by
/// sub-step. With the momentum P and the kinetic energy E (of translation and spin) of all rows,
///
///   P - P_start = gravity + drag + stress + walls - removed       E - E_start = gravity + drag + stress + contacts - removed
///
/// hold to rounding. The impulse of walls is added up where walls push, not from the sum of all contact forces, so the
/// first line also says that pairs push each other alike.

#include <array>

namespace similitude {

/// Since the engine was made; of the simulated bed. Damping that only settling uses is in no entry.
struct ParticleBudget {
  using Vector = std::array<double, 3>;
  Vector gravity_impulse{};    // [N s]
  Vector drag_impulse{};       // [N s], of K (u - v)
  Vector stress_impulse{};     // [N s], of what is held over a gas step: pressure gradient, viscous stress, buoyancy, effects
  Vector wall_impulse{};       // [N s], of walls and baffles
  Vector removed_momentum{};   // [N s], carried out through outlets
  double gravity_work = 0;     // [J]
  double drag_work = 0;        // [J]
  double stress_work = 0;      // [J]
  double contact_work = 0;     // [J], of pairs and walls, spin included: minus what contacts hold as springs and have dissipated
  double removed_energy = 0;   // [J], carried out through outlets
};

}  // namespace similitude
