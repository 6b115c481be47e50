#pragma once
/// Friction with a tangential spring and dashpot across a contact, limited by Coulomb: one step, for any normal law.

#include <cmath>

#include <similitude/contact.h>
#include <similitude/restitution.h>

namespace similitude {

/// The tangential force on i [N], F = -k s - eta v_t and never more than mu F_n, with ds/dt = v_t. The spring s [m] comes as
/// the last step left it and goes as the next shall find it. Stiffness [N/m] is a number or one per contact; where it is zero
/// the damping [kg/s] must be, too. Cundall & Strack (1979), Geotechnique 29, 47.
template <class V, class K>
SIMILITUDE_INLINE Vec3<V> tangential_force(const Contact<V>& c, const V& normal_force, const K& stiffness, const V& damping,
                                           double friction, Vec3<V>& spring) {
  // The contact has turned since the last step: lay the spring into the tangent plane, its length kept.
  const Vec3<V> flat = spring - dot(spring, c.normal) * c.normal;
  const V old_square = dot(spring, spring), flat_square = dot(flat, flat);
  const V stretch = select(flat_square > 0.0, sqrt(old_square / flat_square), V(0));
  spring = stretch * flat + c.dt * c.tangential_velocity;

  const Vec3<V> dashpot = -damping * c.tangential_velocity;
  const Vec3<V> held = -stiffness * spring + dashpot;

  // Coulomb: sliding contacts keep the spring that just carries the friction force.
  const V limit = friction * max(normal_force, V(0));
  const V square = dot(held, held);
  const auto slides = square > limit * limit;
  const Vec3<V> force = select(slides, limit / sqrt(square), V(1)) * held;
  spring = select(slides, (1.0 / stiffness) * (dashpot - force), spring);
  return force;
}

/// Largest stable step of the tangential spring, in units of sqrt(m*/k_n) as stable_step_in_a_bed. Given k_t / k_n and
/// eta_t / (2 sqrt(k_n m*)). A solid sphere resists at its surface with 2/7 of its mass.
inline double stable_tangential_step(double stiffness_ratio, double damping) {
  const double softness = 2.0 / 7 / stiffness_ratio;   // tangential over normal (m/k)
  return std::sqrt(softness) * stable_step_in_a_bed(damping * std::sqrt(softness) * 7.0 / 2);
}

}  // namespace similitude
