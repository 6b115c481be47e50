// Scaling laws, each ill in one way.
#include <similitude/scaling_law.h>

#include <cmath>
#include <stdexcept>

namespace {
using namespace similitude;

/// The exactly similar bed in the same gas's family. The others change one thing.
struct Small {
  double size = 1;   // [-]
  static void parameters(Parameters<Small>& p) { declare(p); }
  template <class Law>
  static void declare(Parameters<Law>& p) {
    p.real("size", &Law::size, {.min = 0.01, .max = 100, .doc = "Of the bed, simulated over real."});
  }
  Ratios ratios(const Bed&) const {
    Ratios r;
    r.length = r.diameter = r.drag_diameter = r.modulus = size;
    r.velocity = r.time = std::sqrt(size);
    r.gas_viscosity = size * std::sqrt(size);
    r.stiffness = size * size;
    return r;
  }
};

struct Negative : Small {
  static void parameters(Parameters<Negative>& p) { declare(p); }
  Ratios ratios(const Bed& bed) const {
    Ratios r = Small::ratios(bed);
    r.gas_density = 10 - size;
    return r;
  }
};

struct NeverTheSameBed : Small {
  static void parameters(Parameters<NeverTheSameBed>& p) { declare(p); }
  Ratios ratios(const Bed& bed) const {
    Ratios r = Small::ratios(bed);
    r.gas_viscosity = 1.5;
    return r;
  }
};

struct WrongClock : Small {
  static void parameters(Parameters<WrongClock>& p) { declare(p); }
  Ratios ratios(const Bed& bed) const {
    Ratios r = Small::ratios(bed);
    r.time = size;
    return r;
  }
};

struct LosesVolume : Small {
  static void parameters(Parameters<LosesVolume>& p) { declare(p); }
  Ratios ratios(const Bed& bed) const {
    Ratios r = Small::ratios(bed);
    r.parcel_weight = std::sqrt(size);
    return r;
  }
};

struct Fickle : Small {
  static void parameters(Parameters<Fickle>& p) { declare(p); }
  Ratios ratios(const Bed& bed) const {
    static int asked = 0;
    Ratios r = Small::ratios(bed);
    r.energy_loss = 1 + 1e-15 * ++asked;
    return r;
  }
};

struct HasNoBed : Small {
  static void parameters(Parameters<HasNoBed>& p) { declare(p); }
  Ratios ratios(const Bed&) const { throw std::domain_error("the bed is too shallow for me."); }
};

}  // namespace

SIMILITUDE_PLUGIN(scaling_law<Small>({"small", "1.0.0", "Nothing is wrong with it"}), scaling_law<Negative>({"negative", "1.0.0", "Ill"}),
                  scaling_law<NeverTheSameBed>({"never_the_same_bed", "1.0.0", "Ill"}),
                  scaling_law<WrongClock>({"wrong_clock", "1.0.0", "Ill"}), scaling_law<LosesVolume>({"loses_volume", "1.0.0", "Ill"}),
                  scaling_law<Fickle>({"fickle", "1.0.0", "Ill"}), scaling_law<HasNoBed>({"has_no_bed", "1.0.0", "Ill"}))
