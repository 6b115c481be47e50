#include <similitude/drag_law.h>

namespace {

/// A single sphere in an unbounded gas. Schiller & Naumann (1935), Z. Ver. Dtsch. Ing. 77, 318.
struct SchillerNaumann {
  template <class V>
  V exchange(const similitude::DragState<V>& s) const {
    return stokes_exchange(s) * similitude::schiller_naumann_factor(particle_reynolds(s));
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(SchillerNaumann, "schiller_naumann", "1.0.0", "Single sphere", "Similitude authors",
                    "Schiller & Naumann (1935), Z. Ver. Dtsch. Ing. 77, 318")
