#include <similitude/drag_law.h>
#include <similitude/effect.h>
#include <similitude/hertz.h>

namespace {
using namespace similitude;

/// The JKR contact in numbers without dimension. With w the work of adhesion, a0 = (9 pi w R*^2 / (2 E*))^(1/3) the contact
/// radius without load and y^2 = a / a0:
///   overlap    delta = a0^2 / R* (y^4 - 2/3 y)
///   force      F = 6 pi w R* (y^6 - y^3)
/// Johnson, Kendall & Roberts (1971), Proc. R. Soc. A 324, 301, whose F is least at y^3 = 1/2: -3/2 pi w R*.
namespace jkr {

/// Where a contact that is drawn apart tears: y^3 = 1/6, delta = -0.2752 a0^2 / R*.
inline constexpr double k_tear = 0.27516060407455223;   // 6^(-1/3) / 2, of a0^2 / R*

/// y of the branch that holds, for overlaps from -k_tear on: Ferrari's root of y^4 - 2/3 y - D, and a step of Newton's for
/// the digits that Cardano's formula loses.
template <class V>
V contact_root(const V& overlap) {
  const V cubed = overlap * overlap * overlap / 27.0;
  const V u = cbrt(1.0 / 36 + sqrt(max(1.0 / 1296 + cubed, V(0))));
  const V m = u - overlap / (3.0 * u);   // m^3 + D m = 1/18
  const V s = sqrt(2.0 * m);
  const V y = 0.5 * (s + sqrt(max(4.0 / (3.0 * s) - s * s, V(0))));
  const V cube = y * y * y;
  const V slope = 4.0 * cube - 2.0 / 3;   // zero at the tear, where there is no digit to win
  return y - select(slope > 1e-3, (cube * y - 2.0 / 3 * y - overlap) / slope, V(0));
}

}  // namespace jkr

/// Attraction between particles, and between particles and walls.
struct Cohesion {
  enum class Model { van_der_waals, jkr };
  Model model;
  double hamaker;          // [J]
  double separation;       // [m], closest distance of two surfaces
  double asperity;         // [m], radius of the roughness; 0: smooth
  double surface_energy;   // [J/m^2], work of adhesion w
  double youngs_modulus;   // [Pa], NaN: the contact law has none
  double poisson_ratio;    // [-]
  double modulus = 0;      // [Pa], E*

  static constexpr HistoryValue history[] = {{"joined", "1", Parity::even}};

  static void parameters(Parameters<Cohesion>& p) {
    using C = Cohesion;
    p.choice("model", &C::model,
             {.choices = "van_der_waals|jkr", .def = "van_der_waals",
              .doc = "van_der_waals: between rough spheres, any contact law. jkr: of soft elastic spheres, with a Hertzian contact law."});
    p.real("hamaker", &C::hamaker,
           {.unit = "J", .def = 6.5e-20, .min = 0, .typical_min = 1e-20, .typical_max = 5e-19, .doc = "Hamaker constant, van_der_waals alone.",
            .reference = "silica; Israelachvili (2011), Intermolecular and Surface Forces, table 13.2"});
    p.real("separation", &C::separation,
           {.unit = "m", .def = 4e-10, .min = 1e-10, .typical_min = 1.6e-10, .typical_max = 1e-9, .doc = "Distance of surfaces that touch, van_der_waals alone.",
            .reference = "Krupp (1967), Adv. Colloid Interface Sci. 1, 111", .scales_as = Scales::as_diameter});
    p.real("asperity", &C::asperity,
           {.unit = "m", .def = 1e-7, .min = 0, .typical_min = 1e-8, .typical_max = 1e-6, .doc = "Radius of the bumps that keep surfaces apart, van_der_waals alone; 0 is smooth.",
            .reference = "Rumpf (1970), Chem. Ing. Tech. 42, 538", .scales_as = Scales::as_diameter});
    p.real("surface_energy", &C::surface_energy,
           {.unit = "J/m^2", .def = not_given, .min = 0, .typical_min = 1e-3, .typical_max = 1, .doc = "Work of adhesion, twice the surface energy of like bodies; jkr alone."});
    p.real("youngs_modulus", &C::youngs_modulus,
           {.unit = "Pa", .def = not_given, .min = 0, .doc = "Of both partners; jkr alone.", .taken_from = "contact"});
    p.real("poisson_ratio", &C::poisson_ratio, {.def = not_given, .min = 0, .max = 0.5, .doc = "Of both partners; jkr alone.", .taken_from = "contact"});
  }

  void prepare() {
    if (model != Model::jkr) return;
    if (!(surface_energy > 0)) {
      throw std::invalid_argument("surface_energy: jkr needs the work of adhesion.\n  Give surface_energy, for example 0.05 J/m^2.");
    }
    if (!(youngs_modulus > 0) || std::isnan(poisson_ratio)) {
      throw std::invalid_argument("youngs_modulus: jkr replaces Hertz's force, and this contact law is not Hertz's.\n  Choose contact: "
                                  "hertz_mindlin or hertz_thornton, or take model: van_der_waals.");
    }
    modulus = effective_modulus({youngs_modulus, poisson_ratio}, {youngs_modulus, poisson_ratio});
  }

  const char* partners() const { return model == Model::jkr ? "hertz_mindlin|hertz_thornton" : nullptr; }
  bool remembers() const { return model == Model::jkr; }

  /// [N], attraction of two rough surfaces at a gap [m]: of the bumps, and of the spheres behind them. Rumpf (1970).
  template <class V>
  V van_der_waals(const V& effective_radius, const V& gap) const {
    const V near = separation + gap, far = asperity + near;
    const V bumps = asperity * effective_radius / ((asperity + effective_radius) * (near * near));
    return hamaker / 6 * (bumps + effective_radius / (far * far));
  }

  template <class V>
  Force<V> contact(const EffectContact<V>& c) const {
    return along(c.normal, V(-van_der_waals(c.effective_radius(), max(-c.overlap, V(0)))));
  }

  /// [m^2], a0^2.
  template <class V>
  V square_of_unloaded_radius(const V& effective_radius) const {
    const V radius = cbrt(4.5 * k_pi * surface_energy * (effective_radius * effective_radius) / modulus);
    return radius * radius;
  }

  /// What JKR adds to Hertz's force, which the contact law has given. A contact begins at touch and ends where it tears.
  template <class V>
  Force<V> contact(const EffectContact<V>& c, History<V>& history) const {
    const V radius = c.effective_radius();
    const V unit = square_of_unloaded_radius(radius) / radius;   // [m]
    const V overlap = c.overlap / unit;
    const auto joined = (overlap > 0.0) || ((history.value[0] > 0.5) && (overlap > -jkr::k_tear));
    const V y = jkr::contact_root(max(overlap, V(-jkr::k_tear)));
    const V cube = y * y * y;
    const V whole = 6 * k_pi * surface_energy * radius * (cube * cube - cube);
    const V touching = max(c.overlap, V(0));
    const V hertz = 4.0 / 3 * modulus * sqrt(radius * touching) * touching;
    history.value[0] = select(joined, V(1), V(0));
    return along(c.normal, V(select(joined, whole - hertz, V(0))));
  }

  /// [m]; of a sphere on a wall, whose R* is largest.
  double reach(double diameter) const {
    constexpr double k_separations = 10;   // at this gap less than a hundredth of the bumps' attraction is left
    if (model == Model::van_der_waals) return k_separations * separation;
    return jkr::k_tear * square_of_unloaded_radius(diameter / 2) / (diameter / 2);
  }

  /// Pull-off over weight, of two alike spheres.
  Relevance relevance(const Evidence& e) const {
    const double radius = e.bed.particle_diameter / 4;
    const double pull = model == Model::jkr ? 1.5 * k_pi * surface_energy * radius : van_der_waals(radius, 0.0);
    const double weight = e.bed.particle_density * sphere_volume(e.bed.particle_diameter) * e.bed.gravity;
    const double bond = weight > 0 ? pull / weight : std::numeric_limits<double>::infinity();
    return {.verdict = bond > 1 ? Verdict::needed : Verdict::negligible,
            .value = bond,
            .threshold = 1,
            .group = "Bo",
            .source = "attraction over weight; Seville, Willett & Knight (2000), Powder Technol. 113, 261"};
  }
};

}  // namespace

SIMILITUDE_EFFECT(Cohesion, "cohesion", "1.0.0", "Attraction in contacts: van der Waals, or JKR", "Similitude authors",
                  "Johnson, Kendall & Roberts (1971), Proc. R. Soc. A 324, 301; Rumpf (1970), Chem. Ing. Tech. 42, 538")
