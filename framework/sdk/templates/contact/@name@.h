#pragma once
#include <similitude/contact_law.h>

/// Linear spring and dashpot along the line of centres: Cundall & Strack (1979), Geotechnique 29, 47. Put your formula
/// here, and its source into this comment.
struct @Type@ {
  double stiffness;      // [N/m]
  double restitution;    // [-]
  double damping_ratio;  // [-], from restitution, once

  static void parameters(similitude::Parameters<@Type@>& p) {
    p.real("stiffness", &@Type@::stiffness, {.unit = "N/m", .min = 0, .doc = "normal spring"});
    p.real("restitution", &@Type@::restitution,
           {.unit = "1", .min = 0.01, .max = 1, .doc = "normal restitution", .scales_as = similitude::Scales::as_restitution});
  }

  void prepare() { damping_ratio = similitude::damping_ratio(restitution); }

  /// On partner i; j receives the opposite.
  template <class V>
  similitude::Force<V> force(const similitude::Contact<V>& c) const {
    const V damping = 2 * damping_ratio * sqrt(stiffness * c.effective_mass);
    return along(c.normal, stiffness * c.overlap - damping * c.normal_velocity);
  }
};
