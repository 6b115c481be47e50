// Small models that show the SDK at work, several in one library.
#include <similitude/contact_law.h>
#include <similitude/drag_law.h>
#include <similitude/effect.h>
#include <similitude/scaling_law.h>

#include <stdexcept>

namespace {
using namespace similitude;

/// Has every kind of parameter.
struct Catalogued {
  enum class Shape { round, square };
  double length, speed, fraction, wanted;
  int count;
  bool on;
  Shape shape;
  static void parameters(Parameters<Catalogued>& p) {
    p.real("length", &Catalogued::length, {.unit = "m", .doc = "a length", .scales_as = Scales::as_diameter});
    p.real("speed", &Catalogued::speed, {.unit = "m/s", .def = 2, .min = 1, .max = 3, .typical_min = 1.5, .typical_max = 2.5});
    p.real("fraction", &Catalogued::fraction, {.unit = "1", .def = 0.5});
    p.real("wanted", &Catalogued::wanted, {.unit = "Pa", .def = not_given});
    p.integer("count", &Catalogued::count, {.def = 3, .min = 1});
    p.flag("on", &Catalogued::on, {.def = true});
    p.choice("shape", &Catalogued::shape, {.choices = "round|square", .def = "square"});
  }
  // Tells what arrived: ratios are the one output of any length.
  Ratios ratios(const Bed& bed) const {
    return {.length = length, .diameter = speed, .drag_diameter = fraction, .particle_density = std::isnan(wanted) ? -1 : wanted,
            .gas_density = static_cast<double>(count), .gas_viscosity = on ? 1.0 : 0.0,
            .velocity = static_cast<double>(shape), .time = bed.gravity};
  }
};

struct Forgetful {   // a metre that says not how it scales
  double gap;
  static void parameters(Parameters<Forgetful>& p) { p.real("gap", &Forgetful::gap, {.unit = "m", .def = 1e-3}); }
  Ratios ratios(const Bed&) const { return {}; }
};

struct Throws {
  Ratios ratios(const Bed&) const { throw std::runtime_error("no ratios today"); }
};

struct ThrowsAnInteger {
  void prepare(const Bed&) { throw 7; }
  Ratios ratios(const Bed&) const { return {}; }
};

/// K = Sauter diameter + 10 cell sizes.
struct Curious {
  static constexpr bool needs_sauter_diameter = true;
  static constexpr bool needs_cell_size = true;
  template <class V>
  V exchange(const DragState<V>& s) const {
    return s.sauter_diameter + 10.0 * s.cell_size;
  }
};

/// Rolling friction of a constant size, and a reach: no force needs memory, all need spin.
struct Rolls {
  static constexpr bool couple = true;
  double reach(double diameter) const { return 0.1 * diameter; }
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return {1000.0 * c.overlap * c.normal, -1e-9 * (c.angular_velocity_i - c.angular_velocity_j)};
  }
};

/// A force of one newton along x, one unit of drag, and a group.
struct Pushes {
  Relevance relevance(const Evidence& evidence) const {
    const double ratio = evidence.bed.gas_density / evidence.bed.particle_density;
    return {.verdict = ratio > 0.01 ? Verdict::needed : Verdict::negligible, .value = ratio, .threshold = 0.01,
            .group = "rho_f/rho_p", .source = "a text book"};
  }
  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    return {.force = {p.mass / p.mass, V(0), V(0)}, .linear_coefficient = p.diameter};
  }
};

}  // namespace

SIMILITUDE_PLUGIN(scaling_law<Catalogued>({"catalogued", "1.2.3", "All kinds of parameters", "somebody", "somewhere"}),
                  scaling_law<Forgetful>({"forgetful", "1.0.0", "A unit without a scaling"}),
                  scaling_law<Throws>({"throws", "1.0.0", "Throws"}),
                  scaling_law<ThrowsAnInteger>({"throws_an_integer", "1.0.0", "Throws"}),
                  drag_law<Curious>({"curious", "1.0.0", "Wants all columns"}),
                  contact_law<Rolls>({"rolls", "1.0.0", "Has a couple"}),
                  effect<Pushes>({"pushes", "1.0.0", "An effect"}))
