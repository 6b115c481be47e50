#pragma once
/// One contact of two spheres, or of a sphere and a wall, as a contact law sees it: no ids, no layout, no threads.

#include <similitude/pack.h>

namespace similitude {

/// The normal points from partner j toward partner i; velocities are of i relative to j. A wall is a partner of infinite
/// mass and, if flat, infinite radius.
template <class V>
struct Contact {
  double dt;                     // [s]
  Vec3<V> normal;                // [-], unit
  V overlap;                     // [m], positive in contact; may be negative down to -reach
  V normal_velocity;             // [m/s], positive when the partners separate
  Vec3<V> tangential_velocity;   // [m/s], at the contact point; with spin if the law rotates
  V radius_i, radius_j;          // [m]
  V effective_mass;              // [kg], m_i m_j / (m_i + m_j)
  Vec3<V> angular_velocity_i;    // [rad/s], zero unless the law rotates
  Vec3<V> angular_velocity_j;    // [rad/s]

  /// [m], R_i R_j / (R_i + R_j); R_i at a flat wall.
  V effective_radius() const { return 1.0 / (1.0 / radius_i + 1.0 / radius_j); }
};

/// The force on i, and a pure couple on i beyond what the force at the contact point brings about. j gets the opposite.
template <class V>
struct Force {
  Vec3<V> force;                            // [N]
  Vec3<V> couple = {V(0), V(0), V(0)};      // [N m], only of laws with `static constexpr bool couple = true`
};

/// A force of the given size along a direction.
template <class V>
Force<V> along(const Vec3<V>& direction, const V& size) {
  return {size * direction};
}

template <class V>
Force<V> operator+(const Force<V>& a, const Force<V>& b) {
  return {a.force + b.force, a.couple + b.couple};
}

enum class Parity { even = SIMILITUDE_EVEN, odd = SIMILITUDE_ODD };

/// One remembered number of a contact. Odd: it changes sign when the partners swap, as vectors of i relative to j do.
struct HistoryValue {
  const char* name;   // lower_snake
  const char* unit;
  Parity parity;
};

/// What a contact remembers: read it, write what the next step shall find. Zero in the first step of a contact.
template <class V>
struct History {
  V value[SIMILITUDE_MAX_HISTORY];

  Vec3<V> vector(int first) const { return {value[first], value[first + 1], value[first + 2]}; }
  void set_vector(int first, const Vec3<V>& v) {
    value[first] = v.x;
    value[first + 1] = v.y;
    value[first + 2] = v.z;
  }
};

}  // namespace similitude
