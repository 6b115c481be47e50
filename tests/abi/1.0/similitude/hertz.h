#pragma once
/// Hertz's normal contact and Mindlin's tangential stiffness: the elastic constants of two materials, how long an impact
/// takes and how deep it goes, and the law that the shipped Hertz models share.
///
/// Damping is proportional to the square root of the contact's own stiffness, eta = 2 sqrt(5/6) zeta sqrt(S m*) (Tsuji, Tanaka &
/// Ishida 1992). An impact then is a linear spring-dashpot in disguise: with y = delta^(5/4) and d(tau) = (5/4) delta^(1/4) dt,
///
///   m* delta'' = -4/3 E* sqrt(R*) delta^(3/2) - eta delta'    becomes    y'' + 2 zeta w y' + w^2 y = 0,
///
/// the same zeta, at the same velocities: dy/d(tau) = d(delta)/dt. So restitution.h holds word for word, whatever the speed: zeta
/// follows from the restitution as for a linear spring, with attraction at the end of the contact or without.

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <similitude/contact.h>
#include <similitude/parameters.h>
#include <similitude/tangential_spring.h>

namespace similitude {

struct ElasticMaterial {
  double youngs_modulus;   // [Pa]; infinite: rigid
  double poisson_ratio;    // [-]
};

/// E* [Pa]: 1/E* = sum of (1 - nu^2) / E over the partners.
inline double effective_modulus(const ElasticMaterial& a, const ElasticMaterial& b) {
  const auto compliance = [](const ElasticMaterial& m) { return (1 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus; };
  return 1 / (compliance(a) + compliance(b));
}

/// G* [Pa]: 1/G* = sum of (2 - nu) / G over the partners, G = E / (2 (1 + nu)).
inline double effective_shear_modulus(const ElasticMaterial& a, const ElasticMaterial& b) {
  const auto compliance = [](const ElasticMaterial& m) {
    return 2 * (2 - m.poisson_ratio) * (1 + m.poisson_ratio) / m.youngs_modulus;
  };
  return 1 / (compliance(a) + compliance(b));
}

/// Largest overlap [m] of an elastic impact, (15 m* v^2 / (16 E* sqrt(R*)))^(2/5), with the power taken of a pure number.
inline double hertz_largest_overlap(double modulus, double effective_mass, double effective_radius, double speed) {
  const double energy = 15.0 / 16 * effective_mass * (speed * speed);
  return effective_radius * std::pow(energy / (modulus * (effective_radius * effective_radius * effective_radius)), 0.4);
}

/// Duration of an impact over (largest elastic overlap / speed), 2.94328 without damping. In the disguise above it is
/// 4/5 of the integral of y^(-1/5), y as of a linear spring-dashpot that meets its wall at unit speed and is released
/// after `linear_duration` [1/w] (restitution.h).
inline double hertz_impact_duration(double damping_ratio, double linear_duration) {
  const double square = 1 - damping_ratio * damping_ratio;
  const auto swing = [=](double t) {
    const double root = std::sqrt(std::abs(square));
    const double wave = root * t < 1e-6 ? t : (square > 0 ? std::sin(root * t) : std::sinh(root * t)) / root;
    return std::exp(-damping_ratio * t) * wave;
  };
  // Midpoint rule; the substitution t = T u^3 (10 - 15 u + 6 u^2) takes the singularity out of both ends.
  constexpr int points = 2000;
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const double u = (k + 0.5) / points;
    const double t = linear_duration * u * u * u * (10 - 15 * u + 6 * u * u);
    sum += std::pow(swing(t), -0.2) * 30 * u * u * (1 - u) * (1 - u);
  }
  return 0.8 * linear_duration * sum / points;
}

inline constexpr double k_hertz_damping = 0.91287092917527690;   // [-], sqrt(5/6): eta / (2 sqrt(S_n m*)) over zeta

/// Hertz-Mindlin with Coulomb friction. With attraction the dashpot may pull the partners together before they part, as in
/// Tsuji's model; without, the force ends at zero as in Thornton's, and the damping allows for it.
///
/// Tangential: k_t = 8 G* sqrt(R* delta) grows and falls with the overlap. While it grows, the force that the spring already
/// carries stays; while it falls, the force falls with it (Thornton, Cummins & Cleary 2013; "rescaled" Mindlin). A plain
/// k_t s would let a loaded spring grow by being pressed, and push a sliding sphere forward.
template <bool Attraction>
struct HertzLaw {
  double youngs_modulus;           // [Pa]
  double poisson_ratio;            // [-]
  double restitution;              // [-], e
  double friction;                 // [-], mu
  double partner_youngs_modulus;   // [Pa], NaN: the same material
  double partner_poisson_ratio;    // [-], NaN: the same material
  double modulus;                  // [Pa], E*
  double stiffness_ratio;          // [-], k_t / S_n = 4 G* / E*
  double damping;                  // [-], zeta, from restitution
  double duration;                 // [-], of an impact, over largest overlap / speed

  static constexpr HistoryValue history[] = {{"tangential_spring_x", "m", Parity::odd},
                                             {"tangential_spring_y", "m", Parity::odd},
                                             {"tangential_spring_z", "m", Parity::odd},
                                             {"last_overlap", "m", Parity::even}};

  static void parameters(Parameters<HertzLaw>& p) {
    using L = HertzLaw;
    p.real("youngs_modulus", &L::youngs_modulus,
           {.unit = "Pa", .min = 0, .typical_min = 1e5, .typical_max = 1e12, .doc = "Young's modulus."});
    p.real("poisson_ratio", &L::poisson_ratio, {.min = 0, .max = 0.5, .doc = "Poisson's ratio."});
    p.real("restitution", &L::restitution,
           {.min = 0.01, .max = 1, .typical_min = 0.3, .typical_max = 1, .doc = "Of a head-on impact, at any speed.",
            .scales_as = Scales::as_restitution});
    p.real("friction", &L::friction,
           {.min = 0, .typical_min = 0, .typical_max = 1, .doc = "Coulomb coefficient; 0 leaves out spin and history."});
    p.real("partner_youngs_modulus", &L::partner_youngs_modulus,
           {.unit = "Pa", .def = not_given, .min = 0, .doc = "Of the other partner, if it is of another material."});
    p.real("partner_poisson_ratio", &L::partner_poisson_ratio,
           {.def = not_given, .min = 0, .max = 0.5, .doc = "Of the other partner, if it is of another material."});
  }

  void prepare() {
    const auto or_own = [](double partner, double own) { return std::isnan(partner) ? own : partner; };
    const ElasticMaterial here = {youngs_modulus, poisson_ratio};
    const ElasticMaterial there = {or_own(partner_youngs_modulus, youngs_modulus), or_own(partner_poisson_ratio, poisson_ratio)};
    if (!(here.youngs_modulus > 0)) refuse_modulus("youngs_modulus");
    if (!(there.youngs_modulus > 0)) refuse_modulus("partner_youngs_modulus");
    modulus = effective_modulus(here, there);
    stiffness_ratio = 4 * effective_shear_modulus(here, there) / modulus;
    damping = Attraction ? damping_ratio(restitution) : damping_ratio_without_attraction(restitution);
    duration = hertz_impact_duration(
        damping, Attraction ? impact_duration(damping) : impact_duration_without_attraction(damping));
  }

  bool remembers() const { return friction > 0; }

  /// S_n = dF/d(delta) = 2 E* sqrt(R* delta) [N/m]
  template <class V>
  V normal_stiffness(const Contact<V>& c) const {
    return 2 * modulus * sqrt(c.effective_radius() * max(c.overlap, V(0)));
  }

  /// eta = 2 sqrt(5/6) zeta sqrt(S_n m*) [kg/s]
  template <class V>
  V damping_coefficient(const Contact<V>& c, const V& stiffness) const {
    return 2 * k_hertz_damping * damping * sqrt(stiffness * c.effective_mass);
  }

  /// 4/3 E* sqrt(R*) delta^(3/2) = 2/3 S_n delta, less the dashpot's share [N].
  template <class V>
  V normal_force(const Contact<V>& c, const V& stiffness) const {
    const V force = 2.0 / 3 * stiffness * c.overlap - damping_coefficient(c, stiffness) * c.normal_velocity;
    return Attraction ? force : max(force, V(0));
  }

  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, normal_force(c, normal_stiffness(c)));
  }

  template <class V>
  Force<V> force(const Contact<V>& c, History<V>& history) const {
    const V stiffness = normal_stiffness(c);
    const V normal = normal_force(c, stiffness);

    const V grown = min(history.value[3] / c.overlap, V(1));   // overlap before over now; 1 while it falls
    Vec3<V> spring = select(c.overlap > 0.0, sqrt(grown), V(0)) * history.vector(0);
    const Vec3<V> tangential = tangential_force(c, normal, V(stiffness_ratio * stiffness),
                                                V(sqrt(stiffness_ratio) * damping_coefficient(c, stiffness)), friction, spring);
    history.set_vector(0, spring);
    history.value[3] = c.overlap;
    return along(c.normal, normal) + Force<V>{tangential};
  }

  /// A contact at no speed never ends.
  double contact_time(double effective_mass, double effective_radius, double speed) const {
    if (!(speed > 0)) return std::numeric_limits<double>::infinity();
    return duration * hertz_largest_overlap(modulus, effective_mass, effective_radius, speed) / speed;
  }

  /// From the stiffness at the largest overlap of an elastic impact, of the normal and, with friction, the tangential spring.
  double largest_stable_step(double effective_mass, double effective_radius, double speed) const {
    const double overlap = hertz_largest_overlap(modulus, effective_mass, effective_radius, speed);
    const double unit = sqrt(effective_mass / (2 * modulus * sqrt(effective_radius * overlap)));
    const double share = k_hertz_damping * damping;
    if (!remembers()) return unit * stable_step_in_a_bed(share);
    return unit * min(stable_step_in_a_bed(share), stable_tangential_step(stiffness_ratio, sqrt(stiffness_ratio) * share));
  }

 private:
  [[noreturn]] static void refuse_modulus(const char* name) {
    throw std::invalid_argument(std::string(name) +
                                ": a contact without stiffness holds nothing apart.\n  Give a modulus above 0 Pa.");
  }
};

}  // namespace similitude
