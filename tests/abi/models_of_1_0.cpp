// One model of every kind, as authors of 1.0 wrote them.
#include <similitude/contact_law.h>
#include <similitude/drag_law.h>
#include <similitude/effect.h>
#include <similitude/fluid_solver.h>
#include <similitude/scaling_law.h>

#include <algorithm>

namespace {

struct Stokes {
  double factor;  // [-]
  static void parameters(similitude::Parameters<Stokes>& p) {
    p.real("factor", &Stokes::factor, {.unit = "1", .def = 2, .min = 0, .max = 10, .doc = "times Stokes' drag"});
  }
  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    return factor * stokes_exchange(s);
  }
};

struct Spring {
  double stiffness;  // [N/m]
  static void parameters(similitude::Parameters<Spring>& p) {
    p.real("stiffness", &Spring::stiffness, {.unit = "N/m", .def = 100, .min = 0, .doc = "of the spring"});
  }
  template <class V>
  similitude::Force<V> force(const similitude::Contact<V>& c) const {
    return along(c.normal, stiffness * c.overlap);
  }
};

struct Half {
  similitude::Ratios ratios(const similitude::Bed& real) const {
    similitude::Ratios r;
    r.diameter = 0.5;
    r.time = real.gravity;
    return r;
  }
};

struct Still {
  void initialise(const similitude_grid&, const similitude_gas_step& fields) { fields.pressure[0] = 7; }
  void advance(const similitude_gas_step&, similitude_gas_report& report) { report.courant = 0.25; }
};

struct Pull {
  template <class V>
  similitude::Addition<V> particles(const similitude::Particle<V>& p) const {
    similitude::Addition<V> added;
    added.linear_coefficient = p.mass / p.dt;
    return added;
  }
};

}  // namespace

SIMILITUDE_PLUGIN(similitude::drag_law<Stokes>({"org.example.stokes", "1.0.0", "Stokes"}),
                  similitude::contact_law<Spring>({"org.example.spring", "1.0.0", "Spring"}),
                  similitude::scaling_law<Half>({"org.example.half", "1.0.0", "Half"}),
                  similitude::fluid_solver<Still>({"org.example.still", "1.0.0", "Still"}),
                  similitude::effect<Pull>({"org.example.pull", "1.0.0", "Pull"}))
