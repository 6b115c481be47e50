#pragma once
/// One row of the run's log book: what the whole bed holds and does at an instant.

#include <array>
#include <limits>

#include "coupling/coupling.h"
#include "fluid/grid.h"
#include "output/accounts.h"
#include "output/csv.h"
#include "output/directory.h"
#include "output/map_back.h"
#include "particles/engine.h"
#include "particles/store.h"

namespace similitude {

inline constexpr const char* k_monitors_file = "monitors.csv";

/// Of the real bed. NaN: this run has no such thing (no gas, no rotation).
struct Monitors {
  static constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
  double time = 0;                          // [s]
  double particles = 0;                     // simulated ones
  double removed_particles = 0;             // left through outlets since the start
  double solids_mass = 0;                   // [kg]
  std::array<double, 3> solids_momentum{};  // [kg m/s]
  double kinetic_energy = 0;                // [J], translation of the solids
  double rotational_energy = k_none;        // [J]
  double bed_height = k_none;               // [m], see expanded_bed_height()
  double mean_height = k_none;              // [m], of the solids' mass
  double largest_speed = 0;                 // [m/s]
  double largest_overlap = 0;               // [% of the smaller diameter], since the last row
  double contacts = 0;
  double gas_mass = k_none;                                    // [kg]
  std::array<double, 3> gas_momentum{k_none, k_none, k_none};  // [kg m/s]
  double pressure_drop = k_none;                               // [Pa], mean over the bottom face minus the outlets'
  double smallest_gas_fraction = k_none;                       // [-]
  double courant = k_none;                                     // [-]
  double gas_mass_residual = k_none;                           // [-]
  double pressure_iterations = k_none;
  double inflow = k_none, outflow = k_none;  // [kg/s]
  // Since the start: what moved the solids, and how far the books are off.
  double gravity_impulse = k_none, drag_impulse = k_none, stress_impulse = k_none, wall_impulse = k_none;  // [kg m/s], z
  double gravity_work = k_none, drag_work = k_none, stress_work = k_none, contact_work = k_none;           // [J]
  double gas_in = k_none, gas_out = k_none;                                                                // [kg]
  double boundary_impulse = k_none;                                                                        // [kg m/s], z
  double pumping_work = k_none;                                                                            // [J]
  Balances residual{k_none, k_none, k_none, k_none};                                                               // [-]
};

/// The simulated bed at an instant; null where the run has none.
struct Observed {
  double time = 0;  // [s], simulated
  const ParticleStore* particles = nullptr;
  const EngineReport* engine = nullptr;
  const Grid* grid = nullptr;
  const GasFields* gas = nullptr;
  const Column<double>* gas_fraction = nullptr;  // null with a gas: one-way, eps = 1
  const similitude_gas_report* gas_report = nullptr;
  const Accounts* accounts = nullptr;
  Balances balances{};
  double gas_density = 0;            // [kg/m^3], simulated
  double largest_overlap_ratio = 0;  // [-], since the last row: the engine's report spans one advance() only
};
Monitors observe(const Observed& simulated, const MapBack& map_back);

/// [m]: 95 % of the solids' mass lies below 0.95 times this height. It is the height of a level bed of even density,
/// and a few particles thrown high do not move it. NaN without particles.
double expanded_bed_height(const ParticleStore& particles);

/// monitors.csv; every column is named with its unit.
class MonitorFile {
 public:
  explicit MonitorFile(const OutputDirectory& directory);
  /// Goes on after the first `length` bytes.
  MonitorFile(const OutputDirectory& directory, std::uint64_t length);
  std::uint64_t length() const { return csv_.length(); }
  void write(const Monitors& monitors);

 private:
  CsvWriter csv_;
};

}  // namespace similitude
