#pragma once
/// A contact law for tests, straight against abi.h: linear spring, dashpot, Coulomb friction with a tangential spring.
/// Plain loops, so that it can be read beside the formulas.

#include <algorithm>
#include <cmath>

#include <similitude/abi.h>

#include "loader/catalogue.h"

namespace similitude::testing {

struct SpringLaw {
  double stiffness = 1000;         // [N/m]
  double damping_ratio = 0;        // [-], eta = 2 zeta sqrt(k m*)
  double friction = 0;             // [-]
  bool rotation = false;           // spin, tangential force with history
  double reach = 0;                // [m]
  double rolling = 0;              // [m], couple = -rolling * |F_n| * direction of w_i - w_j; 0: no couple
  bool refuse = false;             // complain about the first contact it sees
  bool poison = false;             // return a force that is not a number

  double damping(double effective_mass) const { return 2 * damping_ratio * std::sqrt(stiffness * effective_mass); }

  struct Contact {
    double dt, normal[3], overlap, velocity[3], effective_mass;
    double spring[3];   // [m], in and out
  };
  struct Force {
    double normal, total[3];   // [N]
  };

  Force force(Contact& c) const {
    const double approach = c.velocity[0] * c.normal[0] + c.velocity[1] * c.normal[1] + c.velocity[2] * c.normal[2];
    const double eta = damping(c.effective_mass);
    Force out{};
    out.normal = c.overlap > 0 ? stiffness * c.overlap - eta * approach : 0;
    for (int a = 0; a < 3; ++a) out.total[a] = out.normal * c.normal[a];
    if (!rotation) return out;
    const double kt = 2.0 / 7.0 * stiffness, eta_t = 0.5 * eta;
    const double along = c.spring[0] * c.normal[0] + c.spring[1] * c.normal[1] + c.spring[2] * c.normal[2];
    double tangential[3], square = 0;
    for (int a = 0; a < 3; ++a) {
      const double slip = c.velocity[a] - approach * c.normal[a];
      c.spring[a] += c.dt * slip - along * c.normal[a];
      tangential[a] = -kt * c.spring[a] - eta_t * slip;
      square += tangential[a] * tangential[a];
    }
    const double limit = friction * std::fabs(out.normal), size = std::sqrt(square);
    if (size > limit) {
      for (int a = 0; a < 3; ++a) {
        tangential[a] *= limit / size;
        const double slip = c.velocity[a] - approach * c.normal[a];
        c.spring[a] = -(tangential[a] + eta_t * slip) / kt;
      }
    }
    for (int a = 0; a < 3; ++a) out.total[a] += tangential[a];
    return out;
  }
};

inline const SpringLaw& as_law(const void* model) { return *static_cast<const SpringLaw*>(model); }

inline void spring_needs(const void* model, similitude_contact_needs* out) {
  const SpringLaw& law = as_law(model);
  out->rotation = law.rotation;
  out->couple = law.rolling != 0;
  out->history_count = law.rotation ? 3 : 0;
  for (std::uint32_t h = 0; h < out->history_count; ++h) {
    out->history_parity[h] = SIMILITUDE_ODD;
    out->history_name[h] = "spring";
    out->history_unit[h] = "m";
  }
}

inline void spring_forces(const void* model, const similitude_contact_block* b, similitude_status* status) {
  const SpringLaw& law = as_law(model);
  if (law.refuse) {
    status->code = 1;
    status->row = 0;
    std::copy_n("this law refuses everything", 28, status->text);
    return;
  }
  for (std::uint32_t n = 0; n < b->rows; ++n) {
    SpringLaw::Contact c{};
    c.dt = b->dt;
    c.overlap = b->overlap[n];
    c.effective_mass = b->effective_mass[n];
    for (int a = 0; a < 3; ++a) {
      c.normal[a] = b->normal[a][n];
      c.velocity[a] = b->velocity[a][n];
      c.spring[a] = law.rotation ? b->history[a][n] : 0;
    }
    const SpringLaw::Force f = law.force(c);
    double spin[3] = {0, 0, 0}, size = 0;
    if (law.rolling != 0) {
      for (int a = 0; a < 3; ++a) {
        spin[a] = b->angular_velocity_i[a][n] - b->angular_velocity_j[a][n];
        size += spin[a] * spin[a];
      }
      size = std::sqrt(size);
    }
    for (int a = 0; a < 3; ++a) {
      b->force[a][n] = law.poison ? std::nan("") : f.total[a];
      if (law.rotation) b->history[a][n] = c.spring[a];
      if (law.rolling != 0) b->couple[a][n] = size > 0 ? -law.rolling * std::fabs(f.normal) * spin[a] / size : 0;
    }
  }
}

inline double spring_contact_time(const void* model, std::uint32_t, double mass, double, double) {
  const SpringLaw& law = as_law(model);
  return 3.14159265358979323846 / std::sqrt(law.stiffness / mass * (1 - law.damping_ratio * law.damping_ratio));
}
inline double spring_stable_step(const void* model, std::uint32_t, double mass, double, double) {
  const SpringLaw& law = as_law(model);
  const double zeta = law.damping_ratio;
  return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / std::sqrt(law.stiffness / mass);
}
inline double spring_reach(const void* model, double) { return as_law(model).reach; }
inline void destroy_spring(void* model) { delete static_cast<SpringLaw*>(model); }

inline ContactModel make_law(const SpringLaw& law) {
  static const similitude_contact_functions functions{sizeof(similitude_contact_functions), 0, spring_needs, spring_forces,
                                                      spring_contact_time, spring_stable_step, spring_reach};
  static const similitude_descriptor descriptor = [] {
    similitude_descriptor d{};
    d.struct_size = sizeof d;
    d.kind = "contact";
    d.id = "test_spring";
    d.version = "1.0.0";
    d.functions = &functions;
    d.destroy = destroy_spring;
    return d;
  }();
  return ContactModel(descriptor, new SpringLaw(law));
}

/// zeta of a linear spring-dashpot whose impact returns e of the approach speed: e = exp(-pi zeta / sqrt(1 - zeta^2)).
inline double damping_ratio_of(double restitution) {
  const double log_e = std::log(restitution);
  return -log_e / std::sqrt(9.86960440108935862 + log_e * log_e);
}

}  // namespace similitude::testing
