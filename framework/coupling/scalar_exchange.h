#pragma once
/// What the gas carries and the particles hold, over one gas step: exchange of every particle with its gas, transport in the
/// gas, and what each particle received.
///
/// As with momentum, tent weights W and smoothing S take the coefficients to the cells and the gas's values back to the
/// particles, S W c and W^T S s, so that the sum over particles of c (s - level) is the gas's own: nothing is lost between
/// them, to rounding. The exchange is implicit in the gas, and an effect makes it so in the particle (see abi.h).
///
/// The gas has one density, whatever its temperature and composition.

#include <array>
#include <memory>
#include <vector>

#include "coupling/coupling.h"
#include "coupling/scalar_plan.h"

namespace similitude {

/// Since the start, in amounts (J, kg), counted from the scalar's value at the start.
struct ScalarTotals {
  double at_start = 0;    // in the gas
  double in = 0, out = 0;   // through patches
  double walls = 0;       // from walls into the gas
  double exchanged = 0;   // from particles into the gas
};

class ScalarExchange {
 public:
  /// `coupled` false: a given gas, whose scalars stay what they are. Scene, grid, plan and its effects outlive this.
  ScalarExchange(const ModelScene& scene, const Grid& grid, const ScalarPlan& plan, bool coupled);
  ~ScalarExchange();
  ScalarExchange(const ScalarExchange&) = delete;
  ScalarExchange& operator=(const ScalarExchange&) = delete;

  /// Once: columns of particles and fields of the gas, with the case's values. `gas_fraction` of the first instant.
  void start(ParticleStore& particles, GasFields& gas, const Column<double>& gas_fraction);
  /// After Coupling::interpolate, over the same gas step. Throws SimulationError with an effect's own words.
  void advance(ParticleStore& particles, GasFields& gas, const ExchangeFields& fields, double dt);

  /// In the order of the plan's gas scalars.
  const std::vector<ScalarTotals>& totals() const;
  void set_totals(const std::vector<ScalarTotals>& totals);
  /// [J, kg, …], in the gas and in all particles.
  double gas_amount(std::size_t scalar, const GasFields& gas, const Column<double>& gas_fraction) const;
  double particle_amount(std::size_t scalar, const ParticleStore& particles) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace similitude
