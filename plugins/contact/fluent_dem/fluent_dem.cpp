#include <similitude/contact_law.h>

namespace {
using namespace similitude;

/// Linear spring-dashpot whose friction coefficient falls with the sliding speed, as in Ansys Fluent's DEM. There is no
/// tangential spring: nothing is remembered.
struct FluentDem {
  double stiffness;     // [N/m], K
  double restitution;   // [-], eta in Fluent's notation
  double mu_stick;      // [-]
  double mu_glide;      // [-]
  double v_glide;       // [m/s]
  double damping;       // [-], zeta, from restitution

  static void parameters(Parameters<FluentDem>& p) {
    using L = FluentDem;
    p.real("stiffness", &L::stiffness, {.unit = "N/m", .min = 0, .doc = "Normal spring."});
    p.real("restitution", &L::restitution,
           {.min = 0.01, .max = 1, .typical_min = 0.3, .typical_max = 1, .doc = "Of a head-on impact.",
            .scales_as = Scales::as_restitution});
    p.real("mu_stick", &L::mu_stick, {.def = 0.5, .min = 0, .doc = "Friction coefficient of a contact at rest."});
    p.real("mu_glide", &L::mu_glide, {.def = 0.2, .min = 0, .doc = "Friction coefficient of a gliding contact."});
    p.real("v_glide", &L::v_glide,
           {.unit = "m/s", .def = 1, .min = 0, .doc = "Sliding speed from which a contact glides."});
  }

  void prepare() {
    if (!(stiffness > 0)) {
      throw std::invalid_argument(
          "stiffness: a contact without a spring holds nothing apart.\n  Give a stiffness above 0 N/m.");
    }
    if (!(v_glide > 0)) {
      throw std::invalid_argument(
          "v_glide: the friction must fall over some speed.\n  Give a v_glide above 0; for one friction coefficient set mu_glide equal to mu_stick as well.");
    }
    damping = damping_ratio(restitution);
  }

  bool rotates() const { return mu_stick > 0 || mu_glide > 0; }

  /// mu(v): a parabola from mu_stick at rest to mu_glide, reached level at v_glide.
  template <class V>
  V friction_coefficient(const V& speed) const {
    const V x = min(speed / v_glide, V(1));
    return mu_stick + (mu_stick - mu_glide) * (x - 2.0) * x;
  }

  template <class V>
  Force<V> force(const Contact<V>& c) const {
    const V normal = stiffness * c.overlap - 2 * damping * sqrt(stiffness * c.effective_mass) * c.normal_velocity;

    // Friction at rest must not overshoot and change its direction each step: at most it takes half of the sliding speed
    // in one step. A solid sphere resists at its surface with 2/7 of its mass; the half leaves room for the other
    // contacts of the same particle.
    const V speed = magnitude(c.tangential_velocity);
    const V friction = friction_coefficient(speed) * abs(normal);
    const V stopping = (0.5 * 2 / 7) / c.dt * c.effective_mass;   // [kg/s]
    const V resistance = select(friction >= stopping * speed, stopping, friction / speed);
    return along(c.normal, normal) + along(c.tangential_velocity, V(-resistance));
  }

  double contact_time(double effective_mass, double, double) const {
    return sqrt(effective_mass / stiffness) * impact_duration(damping);
  }

  double largest_stable_step(double effective_mass, double, double) const {
    return sqrt(effective_mass / stiffness) * stable_step_in_a_bed(damping);
  }
};

}  // namespace

SIMILITUDE_CONTACT_LAW(FluentDem, "fluent_dem", "1.0.0", "Linear spring-dashpot with speed-dependent friction",
                       "Similitude authors", "Ansys Fluent Theory Guide, discrete element method collision model")
