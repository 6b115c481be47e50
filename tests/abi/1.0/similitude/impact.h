#pragma once
/// A head-on impact of any contact law, played through. It tells how long a contact takes where a law gives no formula.

#include <limits>

#include <similitude/contact.h>
#include <similitude/restitution.h>

namespace similitude {

struct Impact {
  double duration = std::numeric_limits<double>::infinity();   // [s]; infinite: the partners do not part
  double restitution = 0;                                      // [-]
};

/// The law's normal force [N], positive when it pushes the partners apart, in a contact that has just begun.
template <class Law>
double head_on_force(const Law& law, double effective_mass, double effective_radius, double overlap,
                     double normal_velocity, double dt) {
  Contact<double> c{};
  c.dt = dt;
  c.normal = {1, 0, 0};
  c.overlap = overlap;
  c.normal_velocity = normal_velocity;
  c.radius_i = effective_radius;
  c.radius_j = std::numeric_limits<double>::infinity();
  c.effective_mass = effective_mass;
  if constexpr (requires { law.force(c); }) {
    return law.force(c).force.x;
  } else {
    History<double> fresh{};
    return law.force(c, fresh).force.x;
  }
}

/// The impact of a law at a speed > 0 [m/s]. The step is a thousandth of the law's own time scale, found from the overlap
/// at which its elastic force times the overlap is the kinetic energy's double.
template <class Law>
Impact head_on_impact(const Law& law, double effective_mass, double effective_radius, double speed) {
  const double energy = effective_mass * speed * speed;
  constexpr int steps_per_scale = 1000, longest = 100 * steps_per_scale;
  const auto step_of = [speed](double scale) { return scale / (steps_per_scale * speed); };   // [s], never 0: laws divide by it
  double small = 1e-12 * effective_radius, large = 1e3 * effective_radius;
  for (int halving = 0; halving < 60; ++halving) {
    const double overlap = std::sqrt(small * large);
    const double force = head_on_force(law, effective_mass, effective_radius, overlap, 0.0, step_of(overlap));
    (force * overlap < energy ? small : large) = overlap;
  }
  const double dt = step_of(large);
  Impact impact;
  double overlap = 0, velocity = -speed;
  for (int step = 1; step <= longest; ++step) {
    const double force = head_on_force(law, effective_mass, effective_radius, overlap, velocity, dt);
    velocity += force / effective_mass * dt;
    overlap -= velocity * dt;
    if (velocity > 0 && (overlap <= 0 || force == 0)) {
      impact.duration = step * dt;
      impact.restitution = velocity / speed;
      break;
    }
  }
  return impact;
}

/// Beyond this step [s] the impact would be unstable, judged by the linear spring-dashpot of the same duration and
/// restitution.
inline double largest_stable_step_of(const Impact& impact) {
  constexpr double least = 0.01;   // below it the damping no longer changes the answer by more than its own error
  const double loss = std::log(impact.restitution > least ? impact.restitution : least);
  const double zeta = damping_ratio(std::exp(loss));
  return stable_step_in_a_bed(zeta) * impact.duration / std::sqrt(k_pi * k_pi + loss * loss);
}

}  // namespace similitude
