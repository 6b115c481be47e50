#pragma once
/// Exchange between particles and gas: solids fraction, smoothing, interpolation, momentum, parcel weight.
/// Invariant: what the gas loses the particles gain, to rounding. Interpolation is the adjoint of the deposit.
///
/// With W the tent weights (particles to cells), S the smoothing and V_c the volume of a cell:
///   eps = 1 - S W V_p / V_c      E = S W K / V_c      Ev = S W (K v) / V_c      u at particles = W^T S u
/// hence sum over particles of K u = sum over cells of E u V_c, whatever the bed.
///
/// One gas step: deposit(dt), the fluid plugin, interpolate(dt), the DEM sub-steps, settle_accounts().

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "coupling/exchange_coefficient.h"
#include "fluid/grid.h"
#include "loader/catalogue.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude {

/// Cell fields that the coupling owns and the fluid plugin reads. 3 x cells: x of all cells, then y, then z.
struct ExchangeFields {
  Column<double> gas_fraction;        // [-], end of the gas step
  Column<double> gas_fraction_old;    // [-], start of the gas step
  Column<double> exchange;            // [kg/(m^3 s)]
  Column<double> exchange_velocity;   // [kg/(m^2 s^2)], 3 x cells
  Column<double> remainder;           // [N/m^3], 3 x cells
};

/// Cell fields that the fluid plugin fills.
struct GasFields {
  Column<double> velocity;       // [m/s], 3 x cells
  Column<double> pressure;       // [Pa]
  Column<double> stress_force;   // [N/m^3], 3 x cells
  // Of effects; empty without them.
  std::vector<NamedColumn> scalars;      // what the gas carries
  Column<double> added_viscosity;        // [Pa s], the solver reads it
  std::array<Column<double>, 3> flux;    // [m/s], faces: eps u
};

/// What a coupling remembers between two gas steps, beside the particles' own rows.
struct CouplingState {
  ExchangeFields fields;
  std::array<double, 3> pending{};   // [kg m/s]
  std::uint64_t accounts_opened = 0, accounts_left = 0;
};

/// What a gas solver is handed for a step of `dt` [s] that ends at `time` [s]; the fields stay their owners'.
similitude_gas_step gas_step(const ExchangeFields& exchange, GasFields& gas, double time, double dt);

class Coupling {
 public:
  /// `coupled` false: a given gas (one-way); no solids fraction is deposited, eps is 1, nothing is charged to the gas and
  /// nothing is smoothed. Grid and drag law stay alive with the coupling; particle stores need StoreFields::coupling.
  Coupling(const ModelScene& scene, const Grid& grid, const DragModel& drag, bool coupled,
           DragForm form = DragForm::as_given);
  ~Coupling();
  Coupling(const Coupling&) = delete;
  Coupling& operator=(const Coupling&) = delete;

  const ExchangeFields& fields() const { return fields_; }
  ExchangeFields& fields() { return fields_; }

  /// First call: deposits the solids fraction and sets gas_fraction_old equal to it.
  void start(const ParticleStore& particles);

  /// Before the gas step of length dt: solids fraction at both ends, K by the drag law with the gas of the last step, the pair
  /// (sum K, sum K v) and the remainder, all deposited and smoothed alike. Leaves K in particles.gas[].w. The remainder is
  /// what particles.drag_impulse says the gas is still owed (see interpolate), so a bed read from a checkpoint goes on as it was.
  /// The gas velocity must still be what the last interpolate() was given, if there was one since start() or restore().
  /// A gas fraction out of range is for the caller to judge; throws SimulationError when the drag law fails.
  void deposit(ParticleStore& particles, const GasFields& gas, double dt);

  /// After the gas step: gas velocity and stress force at the particles (same weights, adjoint), parcel weight and
  /// buoyancy -rho_f V_p g applied; the particle's own weight m g is the engine's. The gas was charged K (u - v) dt of each
  /// particle, with K and v of deposit(): drag_impulse starts at minus that, so that after the sub-steps it holds what
  /// the particle received less what the gas was charged, and moves with its row.
  void interpolate(ParticleStore& particles, const GasFields& gas, double dt);

  /// After the DEM sub-steps: adds up what particles really received against what the gas was charged; the difference goes
  /// into the remainder of the next deposit(). A particle that left through an outlet takes its open account with it.
  void settle_accounts(const ParticleStore& particles);

  /// After settle_accounts(); a bed with the same rows and restore() goes on with the same bits.
  void save(CouplingState& state) const;
  void restore(const CouplingState& state);

  /// [kg m/s], taken from or owed to the gas and not yet with the particles: gas + particles + this is the total momentum. Valid
  /// after start(), interpolate() and settle_accounts().
  std::array<double, 3> pending_momentum() const;
  /// Particles that left with an open account since start().
  std::uint64_t accounts_left() const;
  /// [-], smallest gas fraction and, where wanted, its cell.
  double smallest_gas_fraction(std::size_t* cell) const;
  /// [m], full width at half maximum of deposit and smoothing together, as asked for, and the explicit steps it takes.
  double smoothing_length() const;
  int smoothing_steps() const;

 private:
  struct Parts;
  ExchangeFields fields_;
  std::unique_ptr<Parts> parts_;
};

/// [m], of the simulated bed: what the case asks for, or three of its largest diameters.
double smoothing_length_of(const ModelScene& scene);

}  // namespace similitude
