// Drag laws as an author writes them with the SDK, each ill in one way.
#include <similitude/drag_law.h>

#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace {
using namespace similitude;

struct Healthy {
  template <class V>
  V exchange(const DragState<V>& s) const {
    return stokes_exchange(s) * schiller_naumann_factor(V(s.gas_fraction * particle_reynolds(s))) * pow(s.gas_fraction, V(-3.65));
  }
};

struct NotANumberWhenFast {
  template <class V>
  V exchange(const DragState<V>& s) const {
    return select(particle_reynolds(s) > 500.0, V(std::numeric_limits<double>::quiet_NaN()), stokes_exchange(s));
  }
};

struct Accelerates {
  template <class V>
  V exchange(const DragState<V>& s) const {
    return -1.0 * stokes_exchange(s);
  }
};

/// The usual beta [kg/(m^3 s)] of a single sphere's worth of volume.
struct ReturnsBeta {
  template <class V>
  V exchange(const DragState<V>& s) const {
    return stokes_exchange(s) / sphere_volume(s.diameter);
  }
};

struct StepsAtTheEmptyGas {
  template <class V>
  V exchange(const DragState<V>& s) const {
    return stokes_exchange(s) * select(s.gas_fraction < 1.0, V(2), V(1));
  }
};

struct WeakerWhenFaster {
  template <class V>
  V exchange(const DragState<V>& s) const {
    const V re = particle_reynolds(s);
    return stokes_exchange(s) / (1.0 + re * re);
  }
};

struct HidesAMillimetre {
  template <class V>
  V exchange(const DragState<V>& s) const {
    return stokes_exchange(s) * (1.0 + s.diameter / 1e-3);
  }
};

struct Complains {
  template <class V>
  V exchange(const DragState<V>& s) const {
    if (any_of(s.gas_fraction < V(0.3))) throw std::domain_error("gas fractions below 0.3 are too dense for me.");
    return stokes_exchange(s);
  }
};

struct EndsTheProgram {
  template <class V>
  V exchange(const DragState<V>& s) const {
    if (any_of(s.gas_fraction == V(0.995))) std::_Exit(7);
    return stokes_exchange(s);
  }
};

struct RefusesItself {
  void prepare() const { throw std::invalid_argument("nothing pleases me.\n  Give up."); }
  template <class V>
  V exchange(const DragState<V>& s) const {
    return stokes_exchange(s);
  }
};

struct OddUnit {
  double length;   // [furlong]
  static void parameters(Parameters<OddUnit>& p) {
    p.real("length", &OddUnit::length, {.unit = "furlong", .def = 1, .doc = "A length.", .scales_as = Scales::as_length});
  }
  template <class V>
  V exchange(const DragState<V>& s) const {
    return stokes_exchange(s);
  }
};

}  // namespace

SIMILITUDE_PLUGIN(drag_law<Healthy>({"healthy", "1.0.0", "Nothing is wrong with it"}),
                  drag_law<NotANumberWhenFast>({"not_a_number_when_fast", "1.0.0", "Ill"}),
                  drag_law<Accelerates>({"accelerates", "1.0.0", "Ill"}),
                  drag_law<ReturnsBeta>({"returns_beta", "1.0.0", "Ill"}),
                  drag_law<StepsAtTheEmptyGas>({"steps_at_the_empty_gas", "1.0.0", "Ill"}),
                  drag_law<WeakerWhenFaster>({"weaker_when_faster", "1.0.0", "Ill"}),
                  drag_law<HidesAMillimetre>({"hides_a_millimetre", "1.0.0", "Ill"}),
                  drag_law<Complains>({"complains", "1.0.0", "Ill"}),
                  drag_law<EndsTheProgram>({"ends_the_program", "1.0.0", "Ill"}),
                  drag_law<RefusesItself>({"refuses_itself", "1.0.0", "Ill"}), drag_law<OddUnit>({"odd_unit", "1.0.0", "Ill"}))
