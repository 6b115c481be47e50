#include <similitude/drag_correlations.h>

namespace {
using namespace similitude;

enum class SphereDrag { dalla_valle, schiller_naumann };

/// A single sphere's drag at the superficial velocity times a power of the gas fraction.
/// Di Felice (1994), Int. J. Multiphase Flow 20, 153.
struct DiFelice {
  SphereDrag drag_coefficient;

  static void parameters(Parameters<DiFelice>& p) {
    p.choice("drag_coefficient", &DiFelice::drag_coefficient,
             {.choices = "dalla_valle|schiller_naumann", .def = "dalla_valle",
              .doc = "C_D of the single sphere: dalla_valle as in the paper, schiller_naumann as in MFIX."});
  }

  template <class V>
  V exchange(const DragState<V>& s) const {
    const V superficial = s.gas_fraction * particle_reynolds(s);
    const V chi = 3.7 - 0.65 * di_felice_dip(superficial);
    const V alone = drag_coefficient == SphereDrag::dalla_valle ? dalla_valle_factor(superficial)
                                                                : schiller_naumann_factor(superficial);
    return stokes_exchange(s) * alone * pow(s.gas_fraction, V(1.0 - chi));
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(DiFelice, "di_felice", "1.0.0", "Di Felice, C_D of Dalla Valle or of Schiller and Naumann",
                    "Similitude authors", "Di Felice (1994), Int. J. Multiphase Flow 20, 153")
