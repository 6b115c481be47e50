// A contact law that answers nothing before a run: every set-up function throws.
#include <similitude/contact_law.h>

#include <stdexcept>

namespace {
using namespace similitude;

struct Mute {
  template <class V>
  Force<V> force(const Contact<V>& c) const {
    return along(c.normal, 100 * c.overlap);
  }
  double contact_time(double, double, double) const { throw std::domain_error("I have no watch."); }
  double largest_stable_step(double, double, double) const { throw std::domain_error("I do not step."); }
  double reach(double) const { throw std::domain_error("I do not reach out."); }
};

struct WillNotSay : Mute {
  bool rotates() const { throw std::domain_error("whether I turn is nobody's business."); }
};

}  // namespace

SIMILITUDE_PLUGIN(contact_law<Mute>({"throws_in_setup", "1.0.0", "A creature of the zoo"}),
                  contact_law<WillNotSay>({"throws_when_asked_what_it_needs", "1.0.0", "A creature of the zoo"}))
