#pragma once
/// What the gas carries: a temperature, a mass fraction. On the staggered grid, with the fluxes of a gas solver:
///
///   d(eps phi)/dt + div(F phi) = div(eps D grad phi) - a phi + b
///
/// F = eps u on faces, d(eps)/dt + div F = 0 to the gas solver's tolerance; a and b from the particles, linear and implicit.
/// Solved for phi - reference, so that a gas that is the same everywhere stays so to the last bit although F balances
/// to a tolerance only, and in flux form, so that what leaves a cell enters its neighbour.
///
/// Two stages (Heun) with Koren's limiter; exchange is implicit in both, so that a steady state does not depend on the step.
/// Where the flow is too fast or the diffusion too strong for one step, the step is cut into equal parts.
///
/// Inlets bring their patch's value, by the flow alone; openings let out what their cell holds and bring back their patch's
/// value. Walls are closed, or hold a value half a cell away. Baffles are closed.

#include <vector>

#include "fluid/face_tables.h"

namespace similitude {

/// One gas step, as the transport sees it. [main]
struct ScalarStep {
  double dt = 0;                               // [s]
  const double* gas_fraction = nullptr;        // [-], cells, end of step
  const double* gas_fraction_old = nullptr;    // [-], cells, start of step
  std::array<const double*, 3> flux{};         // [m/s], faces: eps u at the end of the step, positive along the axis
};

/// One scalar in that step. phi in its own unit.
struct ScalarTerms {
  double diffusivity = 0;                      // [m^2/s], D
  const double* added_diffusivity = nullptr;   // [m^2/s], cells: of unresolved motion; null: none
  double reference = 0;                        // of the amounts in ScalarBudget
  double wall = 0;                             // what walls hold; NaN: they are closed
  const double* patch_value = nullptr;         // by patch: what flows in there
  const double* exchange = nullptr;            // a [1/s], cells, >= 0; null: none
  const double* exchange_source = nullptr;     // b [unit/s], cells
};

/// What a step did, as integrals of phi - reference over gas volume [unit m^3].
struct ScalarBudget {
  double in = 0, out = 0;      // through patches, both positive where phi exceeds the reference
  double walls = 0;            // from walls into the gas
  double exchanged = 0;        // from particles into the gas
};

class ScalarTransport {
 public:
  /// `grid` stays valid.
  explicit ScalarTransport(const similitude_grid& grid);

  /// phi: cells, in and out. `mean` (cells): the value that the exchange of the step saw, so that particles which receive
  /// a (mean) - b per volume and time receive what the gas gave. The same bits for any number of threads.
  ScalarBudget advance(const ScalarStep& step, const ScalarTerms& terms, double* phi, double* mean);
  /// Equal parts that a step is cut into: no cell loses more than half of what it holds in one stage.
  int parts(const ScalarStep& step, const ScalarTerms& terms);
  /// Integral of phi - reference over the gas [unit m^3].
  double amount(const double* gas_fraction, const double* phi, double reference) const;

 private:
  struct OpenFace {
    flow::Row face, below, above, far_below, far_above;   // beyond an inlet: a mirror's slot; beyond other closed faces: the cell
  };
  /// Behind an inlet: the linear continuation of its value and its cell's. Slots follow the cells.
  struct Mirror {
    flow::Row slot, cell;
    int patch;
  };
  struct WallFace {
    flow::Row face, cell;
    int side;   // 0: the cell lies above the face, 1: below
  };

  flow::Row beyond(std::size_t axis, flow::Row cell, int direction);
  void carry(const ScalarStep& step, const ScalarTerms& terms, const double* gas_fraction, std::vector<double>& theta);
  void collect(std::vector<double>& gain) const;
  void count(const ScalarTerms& terms, double volume_per_flux_time, ScalarBudget& budget) const;

  Staggered mesh_;
  std::array<flow::FaceTable, 3> tables_;
  std::array<std::vector<OpenFace>, 3> open_;
  std::array<std::vector<WallFace>, 3> walls_;
  std::vector<Mirror> mirrors_;
  flow::FaceFields transported_;                    // [unit m/s], positive along the axis
  std::vector<double> theta_, stage_;     // cells, then mirrors
  std::vector<double> gain_, content_;    // cells
};

}  // namespace similitude
