#pragma once
/// Grain kinetics of metal-oxide oxygen carriers: time of complete conversion tau = rho_m r_g / (b k C^n), k = k0 exp(-E/(R T)).
/// Abad, Adanez, Garcia-Labiano, de Diego, Gayan & Celaya 2007, Chem. Eng. Sci. 62, 533, tables 2 and 3: Cu10Al-I, Fe45Al-FG
/// and Ni40Al-FG. The constants stand here as they are known by these names and have not been compared with the printed tables.

#include <cmath>

namespace oxygen_carrier {

enum class Carrier { nickel, copper, iron };
enum class Gas { methane, carbon_monoxide, hydrogen, oxygen };

constexpr double k_gas_constant = 8.314462618;   // [J/(mol K)], CODATA 2018

struct Kinetics {
  double k0;                  // [mol^(1-n) m^(3n-2) / s]
  double activation_energy;   // [J/mol]
  double order;               // [-], n
};

/// A grain, or the layer of a plate.
struct Grain {
  double molar_density;       // [mol/m^3], rho_m of the reacting solid
  double length;              // [m], radius of a spherical grain or thickness of a plate
  bool sphere;
};

/// Solid that one mole of gas converts, and gas by the oxygen that it takes or gives.
struct Stoichiometry {
  double solid_per_gas;       // [mol/mol], b
  double molar_mass;          // [kg/mol], of the gas
  double gas_per_oxygen;      // [kg/kg]
};

constexpr Kinetics kinetics(Carrier carrier, Gas gas) {
  constexpr double kilo = 1e3;
  constexpr Kinetics table[3][4] = {
      {{7.1e-1, 78 * kilo, 0.8}, {5.2e-3, 25 * kilo, 0.8}, {9.3e-3, 26 * kilo, 0.5}, {1.8e-3, 7 * kilo, 0.2}},
      {{4.5e-4, 60 * kilo, 0.4}, {5.9e-6, 14 * kilo, 0.8}, {1.0e-4, 33 * kilo, 0.6}, {4.7e-6, 15 * kilo, 1.0}},
      {{8.0e-4, 49 * kilo, 1.3}, {6.2e-4, 20 * kilo, 1.0}, {2.3e-3, 24 * kilo, 0.8}, {3.1e-4, 14 * kilo, 1.0}},
  };
  return table[static_cast<int>(carrier)][static_cast<int>(gas)];
}

/// Of the oxide that is reduced, or of the metal (Fe3O4 of iron) that is oxidised.
constexpr Grain grain(Carrier carrier, Gas gas) {
  const bool oxidises = gas == Gas::oxygen;
  switch (carrier) {
    case Carrier::nickel: return oxidises ? Grain{151200, 5.8e-7, true} : Grain{89290, 6.9e-7, true};
    case Carrier::copper: return oxidises ? Grain{140252, 2.3e-10, false} : Grain{80402, 4.0e-10, false};
    default: return oxidises ? Grain{22472, 2.6e-7, true} : Grain{32811, 2.6e-7, true};
  }
}

/// NiO and CuO to the metal: one O per mole of solid; Fe2O3 to Fe3O4: one O per three moles, 4 Fe3O4 + O2 = 6 Fe2O3.
constexpr Stoichiometry stoichiometry(Carrier carrier, Gas gas) {
  constexpr double oxygen_atom = 15.999e-3;   // [kg/mol]
  const double solid_per_atom = carrier == Carrier::iron ? (gas == Gas::oxygen ? 2.0 : 3.0) : 1.0;
  switch (gas) {
    case Gas::methane: return {4 * solid_per_atom, 16.043e-3, 16.043e-3 / (4 * oxygen_atom)};
    case Gas::carbon_monoxide: return {solid_per_atom, 28.010e-3, 28.010e-3 / oxygen_atom};
    case Gas::hydrogen: return {solid_per_atom, 2.016e-3, 2.016e-3 / oxygen_atom};
    default: return {2 * solid_per_atom, 31.998e-3, 1.0};
  }
}

}  // namespace oxygen_carrier
