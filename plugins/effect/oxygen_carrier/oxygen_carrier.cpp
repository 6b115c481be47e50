#include <similitude/effect.h>
#include <similitude/sphere_in_gas.h>

#include "kinetics.h"

namespace {

using oxygen_carrier::Carrier;
using oxygen_carrier::Gas;
using similitude::Asked;
using similitude::ScalarParticle;
using similitude::cbrt;
using similitude::max;
using similitude::min;
using similitude::pow;
using similitude::quantity;

/// Reduction or oxidation of a metal-oxide oxygen carrier, grains of a shrinking core, one temperature everywhere.
struct OxygenCarrier {
  Carrier carrier = Carrier::nickel;
  Gas gas = Gas::methane;
  double temperature = 0;        // [K]
  double diffusivity = 0;        // [m^2/s], of the gas that reacts
  double turbulent_schmidt = 0;  // [-]

  enum : unsigned { fuel, oxygen, conversion, oxygen_capacity };
  static constexpr similitude_quantity quantities[] = {
      quantity(SIMILITUDE_GAS_SCALAR, "fuel", "1", "mass fraction of the fuel that reduces the carrier.",
               {.min = 0, .max = 1, .amount_unit = "kg"}),
      quantity(SIMILITUDE_GAS_SCALAR, "oxygen", "1", "mass fraction of the oxygen that oxidises the carrier.",
               {.min = 0, .max = 1, .amount_unit = "kg"}),
      quantity(SIMILITUDE_PARTICLE_SCALAR, "conversion", "1", "share of its oxygen that the carrier has given off.",
               {.min = 0, .max = 1, .amount_unit = "kg", .capacity = 3}),
      quantity(SIMILITUDE_PARTICLE_PROPERTY, "oxygen_capacity", "1", "oxygen that a kilogram of carrier can give off [kg/kg].",
               {.min = 1e-6, .max = 0.5}),
  };
  static_assert(oxygen_capacity == 3);

  static void parameters(similitude::Parameters<OxygenCarrier>& p) {
    constexpr const char* k_source = "Abad et al. 2007, Chem. Eng. Sci. 62, 533, tables 2 and 3";
    p.choice("carrier", &OxygenCarrier::carrier,
             {.choices = "NiO|CuO|Fe2O3", .def = "NiO", .doc = "the oxide: Ni40Al-FG, Cu10Al-I or Fe45Al-FG", .reference = k_source});
    p.choice("gas", &OxygenCarrier::gas,
             {.choices = "CH4|CO|H2|O2", .def = "CH4", .doc = "what reacts with it: a fuel that reduces it, or O2 that oxidises it",
              .reference = k_source});
    p.real("temperature", &OxygenCarrier::temperature,
           {.unit = "K", .def = 1173, .min = 300, .max = 2000, .typical_min = 873, .typical_max = 1273, .doc = "temperature of the reaction, the same everywhere"});
    p.real("diffusivity", &OxygenCarrier::diffusivity,
           {.unit = "m^2/s", .def = 2e-4, .min = 0, .max = 1, .doc = "diffusivity of the reacting gas in the gas",
            .scales_as = similitude::Scales::as_diffusivity});
    p.real("turbulent_schmidt", &OxygenCarrier::turbulent_schmidt,
           {.unit = "1", .def = 0.7, .min = 0.1, .max = 10, .doc = "Schmidt number of motion below the cells, where an effect adds viscosity"});
  }

  void prepare(const similitude::Bed& bed) {
    const auto kinetics = oxygen_carrier::kinetics(carrier, gas);
    const auto grain = oxygen_carrier::grain(carrier, gas);
    stoichiometry_ = oxygen_carrier::stoichiometry(carrier, gas);
    order_ = kinetics.order;
    sphere_ = grain.sphere;
    const double k = kinetics.k0 * std::exp(-kinetics.activation_energy / (oxygen_carrier::k_gas_constant * temperature));
    rate_ = stoichiometry_.solid_per_gas * k / (grain.molar_density * grain.length);
    gas_density_ = bed.gas_density;
  }

  bool oxidises() const { return gas == Gas::oxygen; }
  bool uses(unsigned q) const { return oxidises() ? q != fuel : q != oxygen; }
  unsigned reacting() const { return oxidises() ? oxygen : fuel; }

  void configure(const double*, similitude_gas_scalar_law* law) {
    law[reacting()] = {sizeof(similitude_gas_scalar_law), 0, 1, diffusivity, turbulent_schmidt};
  }

  /// [1/s], 1/tau at a mass fraction. Beneath a trace the concentration's power is continued linearly.
  template <class V>
  V pace(const V& fraction, const V& gas_density) const {
    return rate_ * pow(max(fraction, V(k_trace)) * gas_density / stoichiometry_.molar_mass, order_);
  }

  /// Solid that reacts in a step at that pace, as a share of what can: t/tau = 1 - (1 - X)^(1/3) of spherical grains, t/tau = X of
  /// plates, exact for a gas that stays the same, and never more than is left.
  template <class V>
  V reacts(const V& left, const V& steps) const {
    if (!sphere_) return min(left, steps);
    const V core = max(cbrt(left) - steps, V(0));
    return left - core * core * core;
  }

  /// What the carrier takes per second, linear in the gas's fraction at the end of the step.
  template <class V>
  void exchange(const ScalarParticle<V>& p, Asked<V>* asked) const {
    const V seen = max(p.value[reacting()], V(k_trace));
    const V x = p.value[conversion];
    const V left = max(oxidises() ? x : 1 - x, V(0));
    const V share = reacts(left, pace(seen, p.gas_density) * p.dt);
    const V gas_of_all = p.mass * p.value[oxygen_capacity] * stoichiometry_.gas_per_oxygen;   // [kg]
    asked[reacting()].coefficient = gas_of_all * share / (p.dt * seen);
  }

  template <class V>
  void take(ScalarParticle<V>& p, const V* received) const {
    const V share = received[reacting()] / (p.mass * p.value[oxygen_capacity] * stoichiometry_.gas_per_oxygen);
    p.value[conversion] += oxidises() ? -share : share;
  }

  /// Damkohler number of the bed: gas residence time times the rate at which fresh carrier consumes the gas that flows in.
  similitude::Relevance relevance(const similitude::Evidence& evidence) const {
    similitude::Relevance r;
    r.group = "Da";
    r.threshold = 0.1;
    r.source = "Levenspiel 1999, Chemical Reaction Engineering, 3rd ed., ch. 5: conversion 1 - exp(-Da)";
    r.missing = oxidises() ? "scene.gas.oxygen" : "scene.gas.fuel, or list the effect with gas: O2,";
    const similitude::Bed& bed = evidence.bed;
    if (evidence.value == nullptr) return r;
    double fraction = 0;
    bool given = false;
    for (const double* values : {evidence.value, evidence.inflow_value}) {
      if (values == nullptr) continue;
      if (std::isnan(values[reacting()])) continue;
      given = true;
      fraction = std::max(fraction, values[reacting()]);
    }
    const double capacity = evidence.value[oxygen_capacity];
    if (!given) return r;
    r.missing = nullptr;
    r.value = 0;
    if (fraction > 0 && bed.bed_height > 0) {
      if (!(capacity > 0)) {
        r.missing = "scene.particles: oxygen_capacity";
        return r;
      }
      const double initial = sphere_ ? 3 : 1;
      const double taken = similitude::k_settled_packing * bed.particle_density * capacity * stoichiometry_.gas_per_oxygen * initial *
                           pace(fraction, gas_density_);   // [kg/(m^3 s)]
      const double speed = std::abs(bed.superficial_velocity);   // at rest the gas has all the time that it needs
      r.value = speed > 0 ? taken / (fraction * gas_density_) * bed.bed_height / speed : std::numeric_limits<double>::infinity();
    }
    r.verdict = r.value > r.threshold ? similitude::Verdict::needed : similitude::Verdict::negligible;
    return r;
  }

 private:
  static constexpr double k_trace = 1e-6;   // [-], mass fraction

  oxygen_carrier::Stoichiometry stoichiometry_{};
  double order_ = 1;         // [-]
  double rate_ = 0;          // [m^(3n) / (mol^n s)], 1/tau = rate C^n
  double gas_density_ = 0;   // [kg/m^3]
  bool sphere_ = true;
};

}  // namespace

SIMILITUDE_EFFECT(OxygenCarrier, "oxygen_carrier", "1.0.0", "Reduction and oxidation of an oxygen carrier, shrinking core", nullptr,
                  "Abad et al. 2007, Chem. Eng. Sci. 62, 533")
