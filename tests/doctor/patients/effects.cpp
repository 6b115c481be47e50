// Effects, each ill in one way.
#include <similitude/effect.h>

namespace {
using namespace similitude;

/// A wind that carries particles along, and glue in contacts. Nothing is wrong with it.
struct Wind {
  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    return {.force = p.mass * (p.gas_velocity - p.velocity)};
  }
  template <class V>
  Force<V> contact(const EffectContact<V>& c) const {
    return along(c.normal, V(-0.1 * c.law_normal_force()));
  }
  template <class V>
  V added_viscosity(const GasCell<V>& c) const {
    return 1e-3 * c.gas_density * c.cell_size * c.cell_size * c.strain_rate;
  }
  Relevance relevance(const Evidence& e) const {
    const double ratio = e.bed.gas_density / e.bed.particle_density;
    return {.verdict = ratio > 0.1 ? Verdict::needed : Verdict::negligible, .value = ratio, .threshold = 0.1, .group = "rho_f/rho_p", .source = "this test"};
  }
};

/// Reads the spin, and gets it only where another effect asked for it.
struct Eavesdrops : Wind {
  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    return {.force = p.mass * cross(p.angular_velocity, p.gas_velocity - p.velocity)};
  }
};

struct HiddenMass : Wind {
  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    return {.force = p.mass * (p.gas_velocity - p.velocity), .added_mass = 0.5 * p.mass};
  }
};

struct OneSided : Wind {
  template <class V>
  Force<V> contact(const EffectContact<V>& c) const {
    return along(c.normal, V(c.law_normal_force() * c.radius_i / (c.radius_i + 1e-3)));
  }
};

struct BlowsAlongX : Wind {
  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    return {.force = {p.mass * 9.81, V(0), V(0)}};
  }
};

struct JudgesBackwards : Wind {
  Relevance relevance(const Evidence& e) const {
    Relevance r = Wind::relevance(e);
    r.verdict = Verdict::needed;
    return r;
  }
};

struct JudgesWithoutAReason : Wind {
  Relevance relevance(const Evidence&) const { return {.verdict = Verdict::needed}; }
};

/// Against the bare boundary: what stood in the columns is lost.
void overwrites(const void*, const similitude_particle_block* b, similitude_status*) {
  for (std::uint32_t row = 0; row < b->rows; ++row) {
    for (std::size_t a = 0; a < 3; ++a) b->force[a][row] = b->mass[row] * (b->gas_velocity[a][row] - b->velocity[a][row]);
  }
}

constexpr similitude_effect_functions overwriting() {
  similitude_effect_functions functions{};
  functions.struct_size = sizeof functions;
  functions.relevance = &EffectTable<Wind>::relevance;
  functions.particles = &overwrites;
  return functions;
}
constexpr similitude_effect_functions k_overwriting = overwriting();

}  // namespace

SIMILITUDE_PLUGIN(effect<Wind>({"wind", "1.0.0", "Nothing is wrong with it"}), effect<Eavesdrops>({"eavesdrops", "1.0.0", "Ill"}),
                  effect<HiddenMass>({"hidden_mass", "1.0.0", "Ill"}), effect<OneSided>({"one_sided", "1.0.0", "Ill"}),
                  effect<BlowsAlongX>({"blows_along_x", "1.0.0", "Ill"}), effect<JudgesBackwards>({"judges_backwards", "1.0.0", "Ill"}),
                  effect<JudgesWithoutAReason>({"judges_without_a_reason", "1.0.0", "Ill"}),
                  describe_model<Wind>("effect", &k_overwriting, {"overwrites", "1.0.0", "Ill"}))
