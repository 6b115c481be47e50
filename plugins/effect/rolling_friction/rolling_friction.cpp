#include <similitude/effect.h>
#include <similitude/restitution.h>
#include <similitude/sphere_in_gas.h>

namespace {
using namespace similitude;

constexpr double k_neighbours = 12;   // at most, of a sphere among equal ones

/// Resistance against rolling, of spheres that are not quite round. Ai, Chen, Rotter & Ooi (2011), Powder Technol. 206, 269:
/// model A (constant torque) and model C (elastic-plastic spring-dashpot, EPSD).
struct RollingFriction {
  enum class Model { constant_torque, epsd };
  double coefficient;   // [-], mu_r
  Model model;
  double stiffness;     // [N/m], normal, of the contact law; epsd alone
  double damping;       // [-], eta_r; epsd alone

  static constexpr HistoryValue history[] = {{"rolling_angle_x", "rad", Parity::odd},
                                             {"rolling_angle_y", "rad", Parity::odd},
                                             {"rolling_angle_z", "rad", Parity::odd}};

  static void parameters(Parameters<RollingFriction>& p) {
    using R = RollingFriction;
    p.real("coefficient", &R::coefficient,
           {.min = 0, .typical_min = 1e-4, .typical_max = 0.3, .doc = "mu_r: largest rolling torque over R* F_n; the shape's doing."});
    p.choice("model", &R::model,
             {.choices = "constant_torque|epsd", .def = "constant_torque",
              .doc = "epsd has a spring, so that heaps come to rest; constant_torque needs no memory."});
    p.real("stiffness", &R::stiffness,
           {.unit = "N/m", .def = not_given, .min = 0, .doc = "Normal spring that epsd's rolling spring is derived from.", .taken_from = "contact"});
    p.real("damping", &R::damping, {.def = 0.3, .min = 0, .max = 1, .doc = "Damping ratio eta_r of epsd's spring."});
  }

  void prepare() {
    if (model == Model::epsd && !(stiffness > 0)) {
      throw std::invalid_argument("stiffness: the rolling spring of epsd needs the contact's normal stiffness, and this contact law "
                                  "declares none.\n  Give stiffness, for example 1000 N/m, or take model: constant_torque.");
    }
  }

  bool remembers() const { return model == Model::epsd; }
  unsigned reads() const { return SIMILITUDE_READS_ANGULAR_VELOCITY; }
  unsigned adds() const { return SIMILITUDE_ADDS_COUPLE; }

  /// Relative rolling: spin of i against j, without that about the normal.
  template <class V>
  static Vec3<V> rolling(const Contact<V>& c) {
    const Vec3<V> spin = c.angular_velocity_i - c.angular_velocity_j;
    return spin - dot(spin, c.normal) * c.normal;
  }

  /// [kg m^2], that rolling about the contact point must turn: 1/I_r = sum 1/(I + m r^2), 7/5 m* r^2 for alike spheres and on walls.
  template <class V>
  static V inertia(const V& effective_mass, const V& radius) {
    return 1.4 * effective_mass * (radius * radius);
  }

  /// [N m], mu_r R* F_n.
  template <class V>
  V largest_torque(const EffectContact<V>& c) const {
    return coefficient * c.effective_radius() * max(c.law_normal_force(), V(0));
  }

  /// Against the rolling, but never so much that one step would turn it round: each contact takes at most its share of what stops
  /// the spin, for a sphere has up to twelve at once.
  template <class V>
  Force<V> contact(const EffectContact<V>& c) const {
    const Vec3<V> spin = rolling(c);
    const V speed = magnitude(spin);
    const V radius = min(c.radius_i, c.radius_j);
    const V stopping = 0.4 / k_neighbours * c.effective_mass * (radius * radius) / c.dt;   // [N m s], solid spheres: 2/5 m r^2
    const V factor = min(largest_torque(c) / speed, stopping);
    return {{V(0), V(0), V(0)}, select(speed > 0.0, -factor, V(0)) * spin};
  }

  /// k_r = 2.25 k_n (mu_r R*)^2 [N m/rad], as Ai et al. take it from Jiang, Yu & Harris (2005).
  template <class V>
  V rolling_stiffness(const V& effective_radius) const {
    const V arm = coefficient * effective_radius;
    return 2.25 * stiffness * (arm * arm);
  }

  template <class V>
  Force<V> contact(const EffectContact<V>& c, History<V>& history) const {
    const Vec3<V> spin = rolling(c);
    const V spring = rolling_stiffness(c.effective_radius());
    const Vec3<V> before = history.vector(0);
    Vec3<V> angle = before - dot(before, c.normal) * c.normal + c.dt * spin;
    const V held = spring * magnitude(angle);
    const V limit = largest_torque(c);
    const auto gives_way = held > limit;
    angle = select(gives_way, limit / held, V(1)) * angle;
    const V dashpot = 2 * damping * sqrt(inertia(c.effective_mass, min(c.radius_i, c.radius_j)) * spring);
    history.set_vector(0, angle);
    return {{V(0), V(0), V(0)}, -(spring * angle) - select(gives_way, V(0), dashpot) * spin};
  }

  /// Of epsd's spring-dashpot, at the radius of the sphere itself.
  double largest_stable_step(double effective_mass, double effective_radius, double) const {
    if (model == Model::constant_torque || !(coefficient > 0)) return std::numeric_limits<double>::infinity();
    return std::sqrt(inertia(effective_mass, effective_radius) / rolling_stiffness(effective_radius)) * stable_step(damping);
  }

  /// Rolling resists where contacts endure: in slow dense flow, whose inertial number is small. How much the shape resists, no
  /// scene tells.
  Relevance relevance(const Evidence& e) const {
    constexpr double k_threshold = 0.1;
    const double number = inertial_number(e);
    Relevance r{.value = number,
                .threshold = k_threshold,
                .group = "I",
                .source = "inertial number: enduring contacts below, collisions above; GDR MiDi (2004), Eur. Phys. J. E 14, 341",
                .needed_below = true,
                .missing = "a coefficient in a list, [{id: rolling_friction, coefficient: 0.1}] (it is the particles' shape),"};
    if (number >= k_threshold) {
      r.verdict = Verdict::negligible;
    } else if (coefficient > 0) {
      r.verdict = Verdict::needed;
    } else if (coefficient == 0) {
      r.verdict = Verdict::negligible;
    }
    return r;
  }

 private:
  /// I = shear rate x d / sqrt(P / rho_p): the bed falls past itself, sqrt(g H) over H, under its own weight,
  /// P = phi (rho_p - rho_f) g H less what a uniform flow carries of it. After a run by its mean speed and solids fraction.
  static double inertial_number(const Evidence& e) {
    const Bed& bed = e.bed;
    if (!(bed.bed_height > 0) || !(bed.gravity > 0)) return std::numeric_limits<double>::infinity();
    const bool uniform = bed.largest_inlet_velocity <= (1 + 1e-9) * bed.superficial_velocity;   // to rounding
    const double excess = bed.particle_density - bed.gas_density;   // [kg/m^3]; light particles press against the top
    const double minimum = excess > 0 ? minimum_fluidisation_ergun(sphere_in_gas(bed), k_gas_fraction_at_minimum) : 0;
    const double carried = uniform && bed.superficial_velocity > 0 && minimum > 0 ? std::min(1.0, bed.superficial_velocity / minimum) : 0;
    const double solids = e.occurred ? e.occurred->solids_fraction.mean : k_settled_packing;
    const double speed = e.occurred ? e.occurred->particle_speed.mean : std::sqrt(bed.gravity * bed.bed_height);
    const double pressure = solids * std::abs(excess) * bed.gravity * bed.bed_height * (1 - carried);
    return speed / bed.bed_height * bed.particle_diameter / std::sqrt(pressure / bed.particle_density);
  }
};

}  // namespace

SIMILITUDE_EFFECT(RollingFriction, "rolling_friction", "1.0.0", "Rolling friction: constant torque, or elastic-plastic spring-dashpot",
                  "Similitude authors", "Ai, Chen, Rotter & Ooi (2011), Powder Technol. 206, 269")
