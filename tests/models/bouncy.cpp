#include <similitude/contact_law.h>

/// Linear spring-dashpot, normal only. Cundall & Strack 1979.
struct Bouncy {
  double stiffness;      // [N/m]
  double restitution;    // [-]
  double damping_ratio;  // [-], from restitution, once
  static void parameters(similitude::Parameters<Bouncy>& p) {
    p.real("stiffness", &Bouncy::stiffness, {.unit = "N/m", .min = 0, .doc = "normal spring"});
    p.real("restitution", &Bouncy::restitution, {.unit = "1", .min = 0.01, .max = 1, .doc = "normal restitution"});
  }
  void prepare() { damping_ratio = similitude::damping_ratio(restitution); }

  template <class V>
  similitude::Force<V> force(const similitude::Contact<V>& c) const {
    const V damping = 2 * damping_ratio * sqrt(stiffness * c.effective_mass);
    return along(c.normal, stiffness * c.overlap - damping * c.normal_velocity);
  }
};
SIMILITUDE_CONTACT_LAW(Bouncy, "org.example.bouncy", "1.0.0", "Normal spring-dashpot")
