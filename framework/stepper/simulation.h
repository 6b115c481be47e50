#pragma once
/// The time loop's one step, assembled once: deposit solids, gas step, N DEM sub-steps, accounts, guards.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "coupling/cell_pass.h"
#include "coupling/contact_flows.h"
#include "coupling/coupling.h"
#include "coupling/effect_pass.h"
#include "coupling/scalar_exchange.h"
#include "output/accounts.h"
#include "output/gas_boundary.h"
#include "output/run_state.h"
#include "particles/engine.h"
#include "stepper/assembly.h"
#include "stepper/guards.h"
#include "stepper/time_steps.h"

namespace similitude {

/// One entry of the step: what it is called in the printed pipeline and in timing.json, and what it does.
struct Stage {
  std::string name;
  std::function<void()> work;
  double seconds = 0;
};

class Simulation {
 public:
  /// `particles` is a filled bed at rest. All objects live on this one's side; the assembly must outlive it.
  Simulation(const Assembly& assembly, const TimeSteps& steps, ParticleStore particles, std::function<void(const std::string&)> warn);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// One gas step and its sub-steps. Throws SimulationError when a guard trips.
  void step();

  /// Between two steps. A simulation of the same assembly and steps that restores the state goes on with the same bits, for
  /// any number of threads. [main]
  void save(SimulationState& state) const;
  /// Throws std::invalid_argument if the state is not one of this assembly.
  void restore(const SimulationState& state);
  /// Back to a state of this very run and forward again to the end of step `steps_done`, as after a step that failed in its
  /// middle. Warnings are not repeated.
  void replay(const SimulationState& state, std::int64_t steps_done);

  std::int64_t steps_done() const { return steps_done_; }
  double time() const { return static_cast<double>(steps_done_) * steps_.gas_dt(); }   // [s], simulated bed
  const ParticleStore& particles() const { return particles_; }
  const GasFields& gas() const { return gas_; }
  const ExchangeFields& exchange() const { return coupling_->fields(); }
  const similitude_gas_report& gas_report() const { return gas_report_; }
  const Engine& engine() const { return *engine_; }
  const Coupling& coupling() const { return *coupling_; }
  const Accounts& accounts() const { return accounts_; }
  /// What effects carry; null without such.
  const ScalarExchange* scalars() const { return scalars_.get(); }
  const ContactFlows* contact_flows() const { return contact_flows_.get(); }
  double gas_mass() const;   // [kg], of all cells
  /// How far the books are off; `step()` keeps them.
  Balances balances() const;
  /// Total momentum of gas, particles and what is owed between them [kg m/s].
  std::array<double, 3> momentum() const;

  const std::vector<Stage>& stages() const { return stages_; }
  /// Stage times with the engine's own stages in place of its total.
  std::vector<StageTime> stage_times() const;
  /// The pipeline in words, e.g. for the start of a run.
  std::vector<std::string> pipeline() const;

 private:
  void set_up_effects();
  void assemble_stages();
  similitude_gas_step next_gas_step();
  void advance_gas();
  void keep_books_of_gas(double dt, double at);

  const Assembly& assembly_;
  TimeSteps steps_;
  ParticleStore particles_;
  GasFields gas_;
  std::unique_ptr<Coupling> coupling_;
  std::unique_ptr<GasMotion> gas_motion_;   // null: no effect reads it
  std::vector<EffectPass> effects_;
  std::vector<CellPass> cell_effects_;
  std::unique_ptr<ScalarExchange> scalars_;      // null without scalars
  std::unique_ptr<ContactFlows> contact_flows_;  // null if nothing flows through contacts
  TouchingContacts touching_;
  std::unique_ptr<Engine> engine_;
  similitude_gas_report gas_report_{};
  GasBoundary boundary_;
  Accounts accounts_;
  Guards guards_;
  std::vector<Stage> stages_;
  std::int64_t steps_done_ = 0;
};

}  // namespace similitude
