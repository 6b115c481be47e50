#include <similitude/drag_correlations.h>
#include <similitude/sphere_in_gas.h>

#include <iterator>

namespace {
using namespace similitude;

enum class FallingSphere { schiller_naumann, stokes };

/// A cubic that holds from one solids fraction to the next.
struct Piece {
  double from;          // [-], solids fraction
  double origin;        // [-], x = phi - origin
  double c0, c1, c2, c3;
};

/// Published piecewise fits of Radl & Sundaresan (2014). The cell's share of the clusters' size.
constexpr Piece k_size[] = {{0, 0, 21.51, 0, 0, 0},
                            {0.016, 0, 1.96, 29.40, 164.91, -1923},
                            {0.1, 0.1, 4.63, 4.68, -412.04, 2254},
                            {0.18, 0.18, 3.52, -17.99, 128.80, -603},
                            {0.25, 0.25, 2.68, -8.82, 2.18, 112.33},
                            {0.4, 0.4, 1.79, 0, 0, 0}};
/// The largest reduction, of cells much larger than clusters.
constexpr Piece k_reduction[] = {{0, 0, 0, 7.97, 0, 0},
                                 {0.03, 0.03, 0.239, 4.64, -4.41, 253.63},
                                 {0.08, 0.08, 0.492, 6.10, 33.63, -789.6},
                                 {0.12, 0.12, 0.739, 5.01, -61.1, 310.8},
                                 {0.18, 0.18, 0.887, 1.03, -5.17, 5.99},
                                 {0.34, 0.34, 0.943, -0.17, -2.29, -9.12},
                                 {0.48, 0.48, 0.850, -1.35, -6.13, -132.6},
                                 {0.55, 0.55, 0.680, -2.34, -225.2, 0},
                                 {0.6, 0.6, 0, 0, 0, 0}};

template <std::size_t N, class V>
V piecewise(const Piece (&pieces)[N], const V& solids_fraction) {
  V value(0);
  for (const Piece& piece : pieces) {
    const V x = solids_fraction - piece.origin;
    value = select(solids_fraction >= piece.from, piece.c0 + x * (piece.c1 + x * (piece.c2 + x * piece.c3)), value);
  }
  return value;
}

/// Beetstra's drag less what the clusters that a cell does not resolve take from it. Radl & Sundaresan (2014), Chem. Eng.
/// Sci. 117, 416.
struct RadlFiltered {
  static constexpr bool needs_cell_size = true;

  FallingSphere terminal_velocity;
  double cluster_size;   // [m], L_c

  static void parameters(Parameters<RadlFiltered>& p) {
    p.choice("terminal_velocity", &RadlFiltered::terminal_velocity,
             {.choices = "schiller_naumann|stokes", .def = "schiller_naumann",
              .doc = "Drag of the falling sphere that sets the clusters' size; stokes as in MFIX."});
  }

  /// Re f(Re) = Ar / 18 by halving, in dimensionless numbers: a bed scaled by powers of two keeps its bits. f >= 1.
  static double terminal_reynolds(double creeping) {
    double low = 0, high = creeping;
    while (true) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) return high;
      (middle * schiller_naumann_factor(middle) < creeping ? low : high) = middle;
    }
  }

  void prepare(const Bed& bed) {
    const double weight = archimedes(sphere_in_gas(bed));
    if (!(weight > 0)) {
      throw std::invalid_argument(
          "radl_filtered needs particles that fall in their gas.\n"
          "  Check scene.particles, scene.gas.density and scene.gravity, or use beetstra.");
    }
    const double reynolds = terminal_velocity == FallingSphere::stokes ? weight / 18 : terminal_reynolds(weight / 18);
    // Fr_p = u_t^2 / (g d), and L_c = u_t^2 / g Fr_p^(-2/3) is d Fr_p^(1/3). With u_t = Re mu / (rho_f d):
    const double speed = reynolds * bed.gas_viscosity / (bed.gas_density * bed.drag_diameter);
    const double froude = speed * speed / (bed.gravity * bed.drag_diameter);
    cluster_size = bed.drag_diameter * cbrt(froude);
  }

  template <class V>
  V exchange(const DragState<V>& s) const {
    const V solids_fraction = 1.0 - s.gas_fraction;
    const V filtered = s.cell_size / (s.cell_size + cluster_size * piecewise(k_size, solids_fraction));
    return stokes_exchange(s) * beetstra_factor(particle_reynolds(s), s.gas_fraction) *
           (1.0 - filtered * piecewise(k_reduction, solids_fraction));
  }
};

}  // namespace

SIMILITUDE_DRAG_LAW(RadlFiltered, "radl_filtered", "1.0.0", "Beetstra, reduced by the clusters that a cell does not resolve",
                    "Similitude authors", "Radl & Sundaresan (2014), Chem. Eng. Sci. 117, 416")
