#pragma once
/// The books of a run: what particles and gas held at the start, what came and went, and how far the sum is off. A residual
/// is a mistake of the program or of its plugins, not of the model: it should be rounding for the particles, and the
/// solver's tolerance for the gas.

#include <array>

#include "output/gas_boundary.h"
#include "particles/budget.h"
#include "particles/store.h"

namespace similitude {

/// Relative residuals [-]: what is missing over all that was moved. 0 where nothing has moved yet.
struct Balances {
  double momentum = 0;   // of the particles, over the impulses' magnitudes, or over theirs, m |v|, if that is more
  double energy = 0;     // of the particles, over the sum of the works' magnitudes
  double gas_mass = 0;   // over what came in and went out, or over what there is if that is more
  /// Of the gas, over what it was given and what it gave: wall friction and half a cell at the boundary are in it, some per cent.
  double gas_momentum = 0;
};

/// The gas at an instant.
struct GasHeld {
  double mass = 0;                    // [kg]
  std::array<double, 3> momentum{};   // [kg m/s], what is owed to or by the particles included
};

/// What an account holds, for checkpoints.
struct AccountsState {
  std::array<double, 3> momentum{};   // [kg m/s], at the start
  double energy = 0;                  // [J], at the start
  double gas_mass = 0;                // [kg], at the start
  double gas_in = 0, gas_out = 0;     // [kg], since the start
  std::array<double, 3> boundary_impulse{};   // [N s], of walls, plates and patches on the gas, since the start
  std::array<double, 3> buoyancy{};           // [N s], of the gas's own weight on the particles, since the start
  double pumping_work = 0;                    // [J], pressure times volume through patches, since the start
};

class Accounts {
 public:
  Accounts() = default;
  explicit Accounts(const AccountsState& state) : state_(state) {}
  /// At the start of a run; gas_mass [kg] of all cells.
  Accounts(const ParticleStore& particles, double gas_mass);

  /// After a gas step of dt [s]: what flowed through patches [kg/s], what the boundary did, and the buoyancy [N] of the
  /// gas's own weight on the particles, which pressures here do not hold.
  void add_gas_step(double inflow, double outflow, const BoundaryAction& boundary, const std::array<double, 3>& buoyancy, double dt);

  Balances balances(const ParticleStore& particles, const ParticleBudget& budget, const GasHeld& gas) const;
  double gas_in() const { return state_.gas_in; }     // [kg], since the start
  double gas_out() const { return state_.gas_out; }   // [kg]
  double boundary_impulse() const { return state_.boundary_impulse[2]; }   // [N s], z, since the start
  double pumping_work() const { return state_.pumping_work; }              // [J]
  const AccountsState& state() const { return state_; }

 private:
  AccountsState state_;
};

/// [kg m/s], of all rows.
std::array<double, 3> momentum_of(const ParticleStore& particles);
/// [J], kinetic, of translation and spin of all rows.
double energy_of(const ParticleStore& particles);

}  // namespace similitude
