#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

enum class Hindrance { none, wen_yu };

/// Particles that are no spheres, by the diameter of the sphere of equal volume. Haider & Levenspiel (1989), Powder
/// Technol. 58, 63: C_D = 24/Re (1 + A Re^B) + C / (1 + D/Re). Single particles; what neighbours add is Wen and Yu's.
struct HaiderLevenspiel {
  double sphericity;   // [-], surface of the sphere of equal volume over the particle's
  Hindrance hindrance;
  double a, b, c, d;   // [-]

  static void parameters(Parameters<HaiderLevenspiel>& p) {
    using L = HaiderLevenspiel;
    p.real("sphericity", &L::sphericity,
           {.def = 1, .min = 0.026, .max = 1, .typical_min = 0.6, .typical_max = 1,
            .doc = "Surface of the sphere of equal volume over the particle's own surface."});
    p.choice("hindrance", &L::hindrance,
             {.choices = "none|wen_yu", .def = "wen_yu",
              .doc = "How neighbours raise the drag: eps^-2.65 at the superficial Reynolds number, or not at all."});
  }

  void prepare() {
    const double s = sphericity;
    a = exp(2.3288 - 6.4581 * s + 2.4486 * s * s);
    b = 0.0964 + 0.5565 * s;
    c = exp(4.905 - 13.8944 * s + 18.4222 * s * s - 10.2599 * s * s * s);
    d = exp(1.4681 + 12.2584 * s - 20.7322 * s * s + 15.8855 * s * s * s);
  }

  /// C_D Re / 24
  template <class V>
  V alone(const V& reynolds) const {
    return 1.0 + a * pow(reynolds, V(b)) + c / 24 * (reynolds * reynolds) / (reynolds + d);
  }

  template <class V>
  V exchange(const DragState<V>& s) const {
    const V reynolds = particle_reynolds(s);
    const V factor = hindrance == Hindrance::none
                         ? alone(reynolds)
                         : V(alone(V(s.gas_fraction * reynolds)) * wen_yu_hindrance(s.gas_fraction));
    return stokes_exchange(s) * factor;
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(HaiderLevenspiel, "haider_levenspiel", "1.0.0", "Particles of any shape, by their sphericity",
                    "Similitude authors", "Haider & Levenspiel (1989), Powder Technol. 58, 63")
