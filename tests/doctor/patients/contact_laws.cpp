// Contact laws as an author writes them with the SDK, each ill in one way.
#include <similitude/contact_law.h>
#include <similitude/tangential_spring.h>

#include <stdexcept>

namespace {
using namespace similitude;

/// A linear spring-dashpot along the normal. The others change one thing.
struct Spring {
  double stiffness = 500, restitution = 0.8;   // [N/m], [-]
  static void parameters(Parameters<Spring>& p) { declare(p); }
  template <class Law>
  static void declare(Parameters<Law>& p) {
    p.real("stiffness", &Law::stiffness, {.unit = "N/m", .def = 500, .min = 1, .doc = "Normal spring."});
    p.real("restitution", &Law::restitution,
           {.def = 0.8, .min = 0.1, .max = 1, .doc = "Of a head-on impact.", .scales_as = Scales::as_restitution});
  }
  template <class V>
  V normal_force(const Contact<V>& c, double damping_share = 1) const {
    return stiffness * c.overlap -
           damping_share * 2 * damping_ratio(restitution) * sqrt(stiffness * c.effective_mass) * c.normal_velocity;
  }
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, normal_force(c));
  }
  double contact_time(double mass, double, double) const {
    return sqrt(mass / stiffness) * impact_duration(damping_ratio(restitution));
  }
  double largest_stable_step(double mass, double, double) const { return sqrt(mass / stiffness) * stable_step(damping_ratio(restitution)); }
};

/// The radii's difference has a sign that does not change with the normal's.
struct Biased : Spring {
  static void parameters(Parameters<Biased>& p) { declare(p); }
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, normal_force(c) * (1.0 + 1e-3 / (1.0 + c.radius_j / c.radius_i)));
  }
};

struct LovesTheXAxis : Spring {
  static void parameters(Parameters<LovesTheXAxis>& p) { declare(p); }
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, normal_force(c) * (1.0 + 0.1 * c.normal.x * c.normal.x));
  }
};

struct Pulls : Spring {
  static void parameters(Parameters<Pulls>& p) { declare(p); }
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, -1.0 * stiffness * c.overlap);
  }
};

/// Its dashpot drives: no parameter calls itself a restitution, so only the energy tells.
struct Drives {
  double stiffness = 500;   // [N/m]
  static void parameters(Parameters<Drives>& p) {
    p.real("stiffness", &Drives::stiffness, {.unit = "N/m", .def = 500, .min = 1, .doc = "Normal spring."});
  }
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, stiffness * c.overlap + 0.1 * sqrt(stiffness * c.effective_mass) * c.normal_velocity);
  }
  double contact_time(double mass, double, double) const { return k_pi * sqrt(mass / stiffness); }
  double largest_stable_step(double mass, double, double) const { return 1.5 * sqrt(mass / stiffness); }
};

struct HalfDamped : Spring {
  static void parameters(Parameters<HalfDamped>& p) { declare(p); }
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, normal_force(c, 0.5));
  }
};

/// A tangential spring that says it does not change sign when the partners swap.
struct WrongParity : Spring {
  static constexpr HistoryValue history[] = {{"spring_x", "m", Parity::even}, {"spring_y", "m", Parity::even}, {"spring_z", "m", Parity::even}};
  static void parameters(Parameters<WrongParity>& p) { declare(p); }
  template <class V>
  Force<V> force(const Contact<V>& c, History<V>& history) const {
    const V normal = normal_force(c);
    Vec3<V> spring = history.vector(0);
    const Vec3<V> tangential = tangential_force(c, normal, 2.0 / 7 * stiffness, V(0), 0.3, spring);
    history.set_vector(0, spring);
    return along(c.normal, normal) + Force<V>{tangential};
  }
};

struct Hurried : Spring {
  static void parameters(Parameters<Hurried>& p) { declare(p); }
  double contact_time(double mass, double radius, double speed) const { return 0.7 * Spring::contact_time(mass, radius, speed); }
};

struct Reckless : Spring {
  static void parameters(Parameters<Reckless>& p) { declare(p); }
  double largest_stable_step(double mass, double radius, double speed) const { return 1.2 * Spring::largest_stable_step(mass, radius, speed); }
};

/// R_i R_j / (R_i + R_j) where a wall's radius is infinite.
struct AfraidOfWalls : Spring {
  static void parameters(Parameters<AfraidOfWalls>& p) { declare(p); }
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    const V radius = c.radius_i * c.radius_j / (c.radius_i + c.radius_j);
    return along(c.normal, normal_force(c) * (1.0 + 0.0 * radius));
  }
};

struct ThrowsWhenAskedForTime : Spring {
  static void parameters(Parameters<ThrowsWhenAskedForTime>& p) { declare(p); }
  double contact_time(double, double, double speed) const {
    if (speed > 5) throw std::domain_error("impacts above 5 m/s break my particles.");
    return 1e-4;
  }
};

}  // namespace

SIMILITUDE_PLUGIN(contact_law<Spring>({"spring", "1.0.0", "Nothing is wrong with it"}), contact_law<Biased>({"biased", "1.0.0", "Ill"}),
                  contact_law<LovesTheXAxis>({"loves_the_x_axis", "1.0.0", "Ill"}), contact_law<Pulls>({"pulls", "1.0.0", "Ill"}),
                  contact_law<Drives>({"drives", "1.0.0", "Ill"}), contact_law<HalfDamped>({"half_damped", "1.0.0", "Ill"}),
                  contact_law<WrongParity>({"wrong_parity", "1.0.0", "Ill"}), contact_law<Hurried>({"hurried", "1.0.0", "Ill"}),
                  contact_law<Reckless>({"reckless", "1.0.0", "Ill"}), contact_law<AfraidOfWalls>({"afraid_of_walls", "1.0.0", "Ill"}),
                  contact_law<ThrowsWhenAskedForTime>({"throws_when_asked_for_time", "1.0.0", "Ill"}))
