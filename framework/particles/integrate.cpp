#include "particles/integrate.h"

#include <algorithm>

#include "particles/pack.h"

namespace similitude {

using pack::V4;

namespace {

template <bool Coupling, bool Rotation, bool Damping, bool AddedMass>
MotionResult move(ParticleStore& particles, std::uint32_t begin, std::uint32_t end, const Motion& motion) {
  // The fourth numbers of rows (radius, mass, inertia) pass through: whatever is added to them is 0.
  const V4 step{motion.dt, motion.dt, motion.dt, 0};
  const V4 fall{motion.dt * motion.gravity[0], motion.dt * motion.gravity[1], motion.dt * motion.gravity[2], 0};
  const V4 gravity{motion.gravity[0], motion.gravity[1], motion.gravity[2], 0};
  const double damping = motion.dt * motion.velocity_damping;
  Row* position = particles.position.data();
  Row* velocity = particles.velocity.data();
  Row* spin = particles.angular_velocity.data();
  V4 fastest = pack::all(0);
  V4 trouble = pack::all(0);   // becomes not-a-number with the first number that is not finite
  V4 drag_sum = pack::all(0), stress_sum = pack::all(0), mass_sum = pack::all(0);
  // Twice the powers: m (v' - v) . (v' + v) / 2 is the change of the kinetic energy, so works with the mean velocity close.
  V4 gravity_power = pack::all(0), drag_power = pack::all(0), stress_power = pack::all(0), contact_power = pack::all(0);

  const auto advance_row = [&](std::uint32_t row) -> V4 {
    const V4 v = pack::load(velocity[row]);
    const double mass = v[3];
    // Gas that is moved along adds to what every force must move, but has no weight: (m + m_a) dv = dt (F + m g).
    const double moved = AddedMass ? mass + particles.added_mass[row] : mass;
    const double step_per_mass = motion.dt / moved;
    const V4 contact_force = pack::load(particles.force[row]);
    V4 force = contact_force;
    double resistance = 1 + damping;
    if constexpr (Coupling) {
      const V4 gas = pack::load(particles.gas[row]);
      force += pack::load(particles.stress_force[row]) + gas[3] * gas;
      resistance += step_per_mass * gas[3];
    }
    V4 v_new = v + (AddedMass ? mass / moved * fall : fall) + step_per_mass * force;
    if constexpr (Coupling || Damping) v_new /= pack::all(resistance);
    v_new = pack::with_fourth(v_new, v);
    const V4 x_new = pack::load(position[row]) + step * v_new;
    pack::store(velocity[row], v_new);
    pack::store(position[row], x_new);
    const V4 twice_mean = v + v_new;
    mass_sum += v;
    gravity_power += mass * gravity * twice_mean;
    contact_power += contact_force * twice_mean;
    if constexpr (Coupling) {
      const V4 gas = pack::load(particles.gas[row]);
      const V4 drag = gas[3] * (gas - v_new);
      V4 stress = pack::load(particles.stress_force[row]);
      V4 received = step * drag;
      if constexpr (AddedMass) {
        const V4 passed_on = particles.added_mass[row] * pack::with_fourth(v_new - v, pack::all(0));   // to the gas moved along
        stress -= (1 / motion.dt) * passed_on;
        received -= passed_on;
      }
      pack::store(particles.drag_impulse[row], pack::load(particles.drag_impulse[row]) + received);
      drag_sum += drag;
      stress_sum += stress;
      drag_power += drag * twice_mean;
      stress_power += stress * twice_mean;
    }
    trouble += (x_new - x_new) + (v_new - v_new);
    if constexpr (Rotation) {
      const V4 w = pack::load(spin[row]);
      const V4 torque = pack::load(particles.torque[row]);
      V4 w_new = w + motion.dt / w[3] * torque;
      if constexpr (Damping) w_new /= pack::all(1 + damping);
      w_new = pack::with_fourth(w_new, w);
      pack::store(spin[row], w_new);
      contact_power += torque * (w + w_new);
      trouble += w_new - w_new;
    }
    return v_new * v_new;
  };

  std::uint32_t row = begin;
  for (; row + 4 <= end; row += 4) {
    V4 x = advance_row(row), y = advance_row(row + 1), z = advance_row(row + 2), w = advance_row(row + 3);
    pack::transpose(x, y, z, w);
    fastest = pack::larger(x + y + z, fastest);
  }
  for (; row < end; ++row) {
    const V4 squares = advance_row(row);
    fastest = pack::larger(pack::all(squares[0] + squares[1] + squares[2]), fastest);
  }
  MotionResult out;
  out.largest_speed_squared = std::max(std::max(fastest[0], fastest[1]), std::max(fastest[2], fastest[3]));
  const V4 half = pack::all(0.5);
  pack::store(out.sums.drag, drag_sum);
  pack::store(out.sums.stress, stress_sum);
  pack::store(out.sums.mass, mass_sum);
  pack::store(out.sums.gravity_power, half * gravity_power);
  pack::store(out.sums.drag_power, half * drag_power);
  pack::store(out.sums.stress_power, half * stress_power);
  pack::store(out.sums.contact_power, half * contact_power);
  out.finite = trouble[0] == 0 && trouble[1] == 0 && trouble[2] == 0 && trouble[3] == 0;
  return out;
}

template <bool Coupling, bool Rotation, bool AddedMass = false>
MotionResult move_all(ParticleStore& particles, std::uint32_t begin, std::uint32_t end, const Motion& motion) {
  return motion.velocity_damping != 0 ? move<Coupling, Rotation, true, AddedMass>(particles, begin, end, motion)
                                      : move<Coupling, Rotation, false, AddedMass>(particles, begin, end, motion);
}

}  // namespace

MotionResult integrate(ParticleStore& particles, std::uint32_t begin, std::uint32_t end, const Motion& motion, bool rotation) {
  if (particles.fields.added_mass) {
    return rotation ? move_all<true, true, true>(particles, begin, end, motion) : move_all<true, false, true>(particles, begin, end, motion);
  }
  if (particles.fields.coupling) {
    return rotation ? move_all<true, true>(particles, begin, end, motion) : move_all<true, false>(particles, begin, end, motion);
  }
  return rotation ? move_all<false, true>(particles, begin, end, motion) : move_all<false, false>(particles, begin, end, motion);
}

double largest_displacement_squared(const ParticleStore& particles, const Column<Row>& reference, std::uint32_t begin,
                                    std::uint32_t end) {
  double farthest = 0;
  for (std::uint32_t row = begin; row < end; ++row) {
    const Row &p = particles.position[row], &r = reference[row];
    const double dx = p.x - r.x, dy = p.y - r.y, dz = p.z - r.z;
    farthest = std::max(farthest, dx * dx + dy * dy + dz * dz);
  }
  return farthest;
}

}  // namespace similitude
