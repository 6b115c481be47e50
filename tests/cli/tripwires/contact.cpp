// A spring that goes wrong on purpose once a contact is deep enough.
#include <similitude/contact_law.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

enum class Trip { complaint, poison };

template <class Mask>
bool any(const Mask& mask) {
  if constexpr (std::is_same_v<Mask, bool>) {
    return mask;
  } else {
    return any_of(mask);
  }
}

struct Tripwire {
  Trip trip = Trip::complaint;
  double stiffness = 100;   // [N/m]
  double depth = 0;         // [m]

  static void parameters(similitude::Parameters<Tripwire>& p) {
    p.choice("trip", &Tripwire::trip, {.choices = "complaint|poison", .def = "complaint", .doc = "what goes wrong"});
    p.real("stiffness", &Tripwire::stiffness, {.unit = "N/m", .def = 100, .min = 0, .doc = "normal spring"});
    p.real("depth", &Tripwire::depth, {.unit = "m", .def = 1e-7, .min = 0, .doc = "overlap at which it goes wrong", .scales_as = similitude::Scales::as_length});
  }

  // Given, so that no impact is played through at the start: that would trip it.
  double contact_time(double effective_mass, double, double) const { return 3.14159 * std::sqrt(effective_mass / stiffness); }
  double largest_stable_step(double effective_mass, double, double) const { return 2 * std::sqrt(effective_mass / stiffness); }

  template <class V>
  similitude::Force<V> force(const similitude::Contact<V>& c) const {
    const auto tripped = c.overlap > V(depth);
    if (trip == Trip::complaint && any(tripped)) throw std::runtime_error("a contact is deeper than this tripwire");
    return along(c.normal, similitude::select(tripped, V(std::numeric_limits<double>::quiet_NaN()), stiffness * c.overlap));
  }
};

}  // namespace

SIMILITUDE_CONTACT_LAW(Tripwire, "tripwire", "1.0.0", "A spring that goes wrong on purpose")
