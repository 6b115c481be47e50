#include <similitude/effect.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace {

using similitude::Asked;
using similitude::EffectContact;
using similitude::ScalarParticle;
using similitude::max;
using similitude::pow;
using similitude::quantity;
using similitude::select;
using similitude::sqrt;

enum class Transfer { gunn, ranz_marshall };

/// Heat between gas, particles and walls. One temperature in a particle, one density of the gas.
struct Heat {
  Transfer transfer = Transfer::gunn;
  bool contact_conduction = true;
  double turbulent_prandtl = 0;   // [-]

  enum : unsigned { gas_temperature, gas_heat_capacity, gas_conductivity, temperature, heat_capacity, conductivity, wall_temperature };
  static constexpr similitude_quantity quantities[] = {
      quantity(SIMILITUDE_GAS_SCALAR, "temperature", "K", "temperature of the gas.", {.min = 0, .amount_unit = "J"}),
      quantity(SIMILITUDE_GAS_PROPERTY, "heat_capacity", "J/(kg K)", "heat capacity of the gas.", {.def = 1007, .min = 1}),
      quantity(SIMILITUDE_GAS_PROPERTY, "conductivity", "W/(m K)", "heat conductivity of the gas.", {.def = 0.0263, .min = 1e-6}),
      quantity(SIMILITUDE_PARTICLE_SCALAR, "temperature", "K", "temperature of the particles.",
               {.min = 0, .amount_unit = "J", .capacity = 4}),
      quantity(SIMILITUDE_PARTICLE_PROPERTY, "heat_capacity", "J/(kg K)", "heat capacity of the particles' material.", {.min = 1}),
      quantity(SIMILITUDE_PARTICLE_PROPERTY, "conductivity", "W/(m K)", "heat conductivity of the particles' material.", {.min = 1e-6}),
      quantity(SIMILITUDE_WALL_PROPERTY, "temperature", "K", "temperature of all walls; left out, they are insulated.", {.min = 0}),
  };
  static_assert(heat_capacity == 4);

  static void parameters(similitude::Parameters<Heat>& p) {
    p.choice("transfer", &Heat::transfer,
             {.choices = "gunn|ranz_marshall", .def = "gunn",
              .doc = "Nusselt number of a particle: in beds of any gas fraction, or of a single sphere",
              .reference = "Gunn 1978, Int. J. Heat Mass Transfer 21, 467; Ranz & Marshall 1952, Chem. Eng. Prog. 48, 141"});
    p.flag("contact_conduction", &Heat::contact_conduction,
           {.def = true, .doc = "whether heat flows through contacts, between particles and to walls",
            .reference = "Batchelor & O'Brien 1977, Proc. R. Soc. Lond. A 355, 313"});
    p.real("turbulent_prandtl", &Heat::turbulent_prandtl,
           {.unit = "1", .def = 0.85, .min = 0.1, .max = 10, .doc = "Prandtl number of motion below the cells, where an effect adds viscosity",
            .reference = "Kays 1994, J. Heat Transfer 116, 284"});
  }

  void configure(const double* property, similitude_gas_scalar_law* law) {
    gas_capacity_ = property[gas_heat_capacity];
    gas_conducts_ = property[gas_conductivity];
    prandtl_ = viscosity_ * gas_capacity_ / gas_conducts_;
    law[gas_temperature].capacity = gas_capacity_;
    law[gas_temperature].diffusivity = gas_conducts_ / (density_ * gas_capacity_);
    law[gas_temperature].turbulent_number = turbulent_prandtl;
  }
  void prepare(const similitude::Bed& bed) {
    density_ = bed.gas_density;
    viscosity_ = bed.gas_viscosity;
  }

  /// Gunn 1978, eq. 7: gas fractions 0.35 ... 1, Re up to 1e5. Ranz & Marshall 1952: a single sphere, Re up to 200.
  template <class V>
  V nusselt(const V& fraction, const V& reynolds, double prandtl) const {
    const double third = std::cbrt(prandtl);
    if (transfer == Transfer::ranz_marshall) return 2 + 0.6 * sqrt(reynolds) * third;
    const V r_fifth = pow(reynolds, 0.2);
    return (7 - 10 * fraction + 5 * fraction * fraction) * (1 + 0.7 * r_fifth * third) +
           (1.33 - 2.4 * fraction + 1.2 * fraction * fraction) * pow(reynolds, 0.7) * third;
  }

  template <class V>
  void exchange(const ScalarParticle<V>& p, Asked<V>* asked) const {
    const V superficial_reynolds = p.gas_fraction * p.gas_density * p.slip_speed * p.diameter / p.gas_viscosity;
    const V h_area = std::numbers::pi * p.diameter * gas_conducts_ * nusselt(p.gas_fraction, superficial_reynolds, prandtl_);   // [W/K]
    const V capacity = p.mass * p.value[heat_capacity];                                                                          // [J/K]
    asked[gas_temperature] = {h_area / (1 + h_area * p.dt / capacity), p.value[temperature]};
  }
  template <class V>
  void take(ScalarParticle<V>& p, const V* received) const {
    p.value[temperature] += received[gas_temperature] / (p.mass * p.value[heat_capacity]);
  }

  unsigned adds() const { return contact_conduction ? SIMILITUDE_ADDS_FLOW : 0; }
  /// H = 2 k_ij a through a circle of radius a between two half spaces (Batchelor & O'Brien 1977); k_ij the harmonic mean of both;
  /// a wall's material conducts as well as needed, so that the particle's own k remains, twice over.
  template <class V>
  void flow(const EffectContact<V>& c, V* into_i) const {
    const V touching = max(c.overlap, V(0));
    const auto wall = c.radius_j > V(1e30);
    const V effective_radius = 1 / (1 / c.radius_i + 1 / c.radius_j);
    const V circle = sqrt(touching * effective_radius);   // [m], of Hertz's elastic spheres
    const V k_i = c.value_i[conductivity], k_j = select(wall, k_i, c.value_j[conductivity]);
    const V mean = select(wall, 2 * k_i, 2 * k_i * k_j / (k_i + k_j));
    const V wall_holds = c.value_j[temperature];
    const V other = select(wall_holds == wall_holds, wall_holds, c.value_i[temperature]);   // NaN: an insulated wall
    into_i[temperature] = 2 * mean * circle * (other - c.value_i[temperature]);
  }

  /// How far apart the temperatures of this scene lie, relative to the lowest.
  similitude::Relevance relevance(const similitude::Evidence& evidence) const {
    similitude::Relevance r;
    r.group = "(T_max - T_min)/T_min";
    r.threshold = 0.05;
    r.source = "Incropera 2007, Fundamentals of Heat and Mass Transfer, app. A: 5 % of T change air's viscosity by 4 %";
    r.missing = "scene.gas.temperature";
    if (evidence.value == nullptr) return r;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    const auto see = [&](double kelvin) {
      if (!(kelvin > 0)) return;
      lowest = std::min(lowest, kelvin);
      highest = std::max(highest, kelvin);
    };
    for (const unsigned q : {unsigned(gas_temperature), unsigned(temperature), unsigned(wall_temperature)}) see(evidence.value[q]);
    if (evidence.inflow_value != nullptr) {
      see(evidence.inflow_value[gas_temperature]);
      see(evidence.inflow_value[temperature]);
    }
    if (!(highest > 0)) return r;
    r.missing = nullptr;
    r.value = (highest - lowest) / lowest;
    r.verdict = r.value > r.threshold ? similitude::Verdict::needed : similitude::Verdict::negligible;
    return r;
  }

 private:
  double density_ = 0;        // [kg/m^3], of the gas
  double viscosity_ = 0;      // [Pa s]
  double prandtl_ = 0;        // [-]
  double gas_capacity_ = 0;   // [J/(kg K)]
  double gas_conducts_ = 0;   // [W/(m K)]
};

}  // namespace

SIMILITUDE_EFFECT(Heat, "heat", "1.0.0", "Heat between gas, particles and walls", nullptr,
                  "Gunn 1978, Int. J. Heat Mass Transfer 21, 467; Ranz & Marshall 1952, Chem. Eng. Prog. 48, 141; Batchelor & "
                  "O'Brien 1977, Proc. R. Soc. Lond. A 355, 313")
