// Effects and gas solvers that throw where the boundary has no status for their words.
#include <similitude/effect.h>
#include <similitude/fluid_solver.h>

#include <stdexcept>

namespace {
using namespace similitude;

struct Silent {
  Relevance relevance(const Evidence&) const { return {}; }
};
struct WillNotRead : Silent {
  unsigned reads() const { throw std::domain_error("I do not read."); }
};
struct WillNotAdd : Silent {
  unsigned adds() const { throw std::domain_error("I do not add."); }
};
struct WillNotRemember : Silent {
  static constexpr HistoryValue history[] = {{"stretch", "m", Parity::even}};
  template <class V>
  Force<V> contact(const EffectContact<V>& c) const {
    return along(c.normal, V(0));
  }
  template <class V>
  Force<V> contact(const EffectContact<V>& c, History<V>&) const {
    return along(c.normal, V(0));
  }
  bool remembers() const { throw std::domain_error("I forgot whether I do."); }
};
struct HasNoPartners : Silent {
  const char* partners() const { throw std::domain_error("I dance alone."); }
};
struct HasNoConflicts : Silent {
  const char* conflicts() const { throw std::domain_error("I quarrel with nobody."); }
};
struct UsesNothing : Silent {
  static constexpr similitude_quantity quantities[] = {quantity(SIMILITUDE_GAS_SCALAR, "scent", "1", "what lingers", {.def = 0, .amount_unit = "kg"})};
  bool uses(unsigned) const { throw std::domain_error("I am of no use."); }
};

struct Still {
  void initialise(const similitude_grid&, const similitude_gas_step&) {}
  void advance(const similitude_gas_step&, similitude_gas_report&) {}
};
struct NeedsNothing : Still {
  similitude_fluid_needs needs() const { throw std::domain_error("I am in want of nothing."); }
};
struct CannotCount : Still {
  std::uint64_t state_size() const { throw std::domain_error("one, two, many."); }
  void save_state(double*) const {}
  void load_state(const double*) {}
};
struct Forgetful : Still {
  std::uint64_t state_size() const { return 2; }
  void save_state(double* out) const { out[0] = out[1] = 1, throw std::domain_error("it has slipped my mind."); }
  void load_state(const double*) { throw std::domain_error("that was somebody else."); }
};

constexpr const char* k_title = "A creature of the zoo";

}  // namespace

SIMILITUDE_PLUGIN(effect<WillNotRead>({"will_not_read", "1.0.0", k_title}), effect<WillNotAdd>({"will_not_add", "1.0.0", k_title}),
                  effect<WillNotRemember>({"will_not_remember", "1.0.0", k_title}),
                  effect<HasNoPartners>({"has_no_partners", "1.0.0", k_title}),
                  effect<HasNoConflicts>({"has_no_conflicts", "1.0.0", k_title}), effect<UsesNothing>({"uses_nothing", "1.0.0", k_title}),
                  fluid_solver<NeedsNothing>({"needs_nothing", "1.0.0", k_title}),
                  fluid_solver<CannotCount>({"cannot_count", "1.0.0", k_title}), fluid_solver<Forgetful>({"forgetful", "1.0.0", k_title}))
