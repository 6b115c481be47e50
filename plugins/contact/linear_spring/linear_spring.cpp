#include <similitude/contact_law.h>
#include <similitude/tangential_spring.h>

namespace {
using namespace similitude;

/// Linear spring-dashpot with Coulomb friction and a tangential spring. Cundall & Strack (1979), Geotechnique 29, 47; the
/// tangential constants as usual in soft-sphere codes: k_t = 2/7 k makes both springs of a solid sphere swing alike.
struct LinearSpring {
  double stiffness;                    // [N/m], k
  double restitution;                  // [-], e
  double friction;                     // [-], mu
  double tangential_stiffness_ratio;   // [-], k_t / k
  double tangential_damping_ratio;     // [-], eta_t / eta
  bool attraction;                     // may the dashpot pull?
  double damping;                      // [-], zeta, from restitution

  static constexpr HistoryValue history[] = {{"tangential_spring_x", "m", Parity::odd},
                                             {"tangential_spring_y", "m", Parity::odd},
                                             {"tangential_spring_z", "m", Parity::odd}};

  static void parameters(Parameters<LinearSpring>& p) {
    using L = LinearSpring;
    p.real("stiffness", &L::stiffness, {.unit = "N/m", .min = 0, .doc = "Normal spring."});
    p.real("restitution", &L::restitution,
           {.min = 0.01, .max = 1, .typical_min = 0.3, .typical_max = 1, .doc = "Of a head-on impact.",
            .scales_as = Scales::as_restitution});
    p.real("friction", &L::friction,
           {.min = 0, .typical_min = 0, .typical_max = 1, .doc = "Coulomb coefficient; 0 leaves out spin and history."});
    p.real("tangential_stiffness_ratio", &L::tangential_stiffness_ratio,
           {.def = 2.0 / 7, .min = 0.01, .typical_min = 0.2, .typical_max = 1, .doc = "Tangential spring over normal spring."});
    p.real("tangential_damping_ratio", &L::tangential_damping_ratio,
           {.def = 0.5, .min = 0, .typical_min = 0, .typical_max = 1, .doc = "Tangential damping over normal damping."});
    p.flag("attraction", &L::attraction,
           {.def = false,
            .doc = "Whether the dashpot may pull the partners together before they part; the damping always matches.",
            .reference = "Schwager & Poeschel (2007), Granular Matter 9, 465"});
  }

  void prepare() {
    if (!(stiffness > 0)) {
      throw std::invalid_argument(
          "stiffness: a contact without a spring holds nothing apart.\n  Give a stiffness above 0 N/m.");
    }
    damping = attraction ? damping_ratio(restitution) : damping_ratio_without_attraction(restitution);
  }

  bool remembers() const { return friction > 0; }

  /// eta = 2 zeta sqrt(k m*) [kg/s]
  template <class V>
  V damping_coefficient(const Contact<V>& c) const {
    return 2 * damping * sqrt(stiffness * c.effective_mass);
  }

  template <class V>
  V normal_force(const Contact<V>& c) const {
    const V force = stiffness * c.overlap - damping_coefficient(c) * c.normal_velocity;
    return attraction ? force : max(force, V(0));
  }

  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, normal_force(c));
  }

  template <class V>
  Force<V> force(const Contact<V>& c, History<V>& history) const {
    const V normal = normal_force(c);
    Vec3<V> spring = history.vector(0);
    const Vec3<V> tangential = tangential_force(c, normal, tangential_stiffness_ratio * stiffness,
                                                V(tangential_damping_ratio * damping_coefficient(c)), friction, spring);
    history.set_vector(0, spring);
    return along(c.normal, normal) + Force<V>{tangential};
  }

  double contact_time(double effective_mass, double, double) const {
    return sqrt(effective_mass / stiffness) *
           (attraction ? impact_duration(damping) : impact_duration_without_attraction(damping));
  }

  /// Of the normal and, with friction, the tangential spring.
  double largest_stable_step(double effective_mass, double, double) const {
    const double unit = sqrt(effective_mass / stiffness);
    if (!remembers()) return unit * stable_step_in_a_bed(damping);
    return unit * min(stable_step_in_a_bed(damping), stable_tangential_step(tangential_stiffness_ratio, tangential_damping_ratio * damping));
  }
};

}  // namespace

SIMILITUDE_CONTACT_LAW(LinearSpring, "linear_spring", "1.0.0", "Linear spring-dashpot with Coulomb friction",
                       "Similitude authors", "Cundall & Strack (1979), Geotechnique 29, 47")
