#pragma once
/// Spheres that hit a wall, each row of a block one sphere, through the plugin's boundary and the simplest integrator
/// there is: v += a dt, then x += v dt. The sphere moves in the plane z = 0 toward the wall x = 0, whose normal is +x.

#include <functional>
#include <vector>

#include "columns.h"
#include "plugin_file.h"

namespace similitude::test {

using ContactModel = TestModel<similitude_contact_functions>;

struct Sphere {
  double radius, density;
  double mass() const { return 4.0 / 3 * 3.14159265358979323846 * radius * radius * radius * density; }
  double inertia() const { return 0.4 * mass() * radius * radius; }
};

struct Rebound {
  Vec3<double> velocity;           // [m/s]
  Vec3<double> angular_velocity;   // [rad/s]
  double duration;                 // [s], while the force pushed
};

inline similitude_contact_needs needs_of(const ContactModel& law) {
  similitude_contact_needs needs{};
  needs.struct_size = sizeof needs;
  law.functions().needs(law.instance(), &needs);
  return needs;
}

/// One impact per phase in (0, 1]: the first overlap seen is phase * v * dt.
inline std::vector<Rebound> impacts(const ContactModel& law, const Sphere& sphere, Vec3<double> velocity, double dt,
                                    const std::vector<double>& phases) {
  const similitude_contact_needs needs = needs_of(law);
  const std::size_t rows = (phases.size() + 7) / 8 * 8;
  ContactColumns contact(rows);
  std::vector<Rebound> state(rows, Rebound{velocity, {0, 0, 0}, 0});
  std::vector<double> position(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const double phase = phases[row < phases.size() ? row : 0];
    position[row] = sphere.radius + phase * velocity.x * dt;   // velocity.x < 0
    contact.normal.set(row, {1, 0, 0});
    contact.radius_i[row] = sphere.radius;
    contact.radius_j[row] = std::numeric_limits<double>::infinity();
    contact.effective_mass[row] = sphere.mass();
  }
  for (bool touching = true; touching;) {
    touching = false;
    for (std::size_t row = 0; row < rows; ++row) {
      const Rebound& s = state[row];
      const Vec3<double> arm = {-sphere.radius, 0, 0};
      contact.overlap[row] = sphere.radius - position[row];
      contact.velocity.set(row, needs.rotation ? s.velocity + cross(s.angular_velocity, arm) : s.velocity);
      contact.angular_i.set(row, s.angular_velocity);
    }
    similitude_contact_block block = contact.block(dt, needs.history_count, needs.rotation != 0);
    similitude_status status{};
    law.functions().forces(law.instance(), &block, &status);
    if (status.code) throw std::runtime_error(status.text);
    for (std::size_t row = 0; row < rows; ++row) {
      if (contact.overlap[row] <= 0) continue;
      touching = true;
      Rebound& s = state[row];
      const Vec3<double> force = contact.force.get(row);
      s.velocity = s.velocity + (dt / sphere.mass()) * force;
      s.angular_velocity = s.angular_velocity + (dt / sphere.inertia()) * cross(Vec3<double>{-sphere.radius, 0, 0}, force);
      position[row] += s.velocity.x * dt;
      if (force.x > 0) s.duration += dt;
    }
  }
  state.resize(phases.size());
  return state;
}

/// Where in a step the contact may begin: evenly over a whole step.
inline std::vector<double> all_phases(std::size_t count = 40) {
  std::vector<double> phases;
  for (std::size_t k = 1; k <= count; ++k) phases.push_back(static_cast<double>(k) / static_cast<double>(count));
  return phases;
}

}  // namespace similitude::test
