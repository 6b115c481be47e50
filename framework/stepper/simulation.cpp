#include "stepper/simulation.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>

#include "stepper/seconds_since.h"

namespace similitude {
namespace {

constexpr std::int64_t k_steps_between_balances = 100;   // sums over all rows: a fraction of a percent of a step's cost

std::array<double, 3> cell_centre(const Grid& grid, std::size_t cell) {
  const auto nx = static_cast<std::size_t>(grid.cells(0));
  const auto ny = static_cast<std::size_t>(grid.cells(1));
  return {(static_cast<double>(cell % nx) + 0.5) * grid.spacing(0),
          (static_cast<double>(cell / nx % ny) + 0.5) * grid.spacing(1),
          (static_cast<double>(cell / (nx * ny)) + 0.5) * grid.spacing(2)};
}

}  // namespace

Simulation::Simulation(const Assembly& assembly, const TimeSteps& steps, ParticleStore particles,
                       std::function<void(const std::string&)> warn)
    : assembly_(assembly), steps_(steps), particles_(std::move(particles)), boundary_(*assembly.grid),
      guards_(assembly.results, std::move(warn), hardness_of(assembly.contact.descriptor()), assembly.fluid_needs.any_courant_number == 0) {
  const std::size_t cells = assembly.grid->cell_count();
  gas_.velocity.assign(3 * cells, 0);
  gas_.pressure.assign(cells, 0);
  gas_.stress_force.assign(3 * cells, 0);
  coupling_ = std::make_unique<Coupling>(assembly.model, *assembly.grid, assembly.drag, assembly.coupled(), assembly.drag_form());
  coupling_->start(particles_);

  set_up_effects();
  const similitude_gas_step fields = next_gas_step();
  similitude_status status{};
  assembly.fluid.functions().initialise(assembly.fluid.instance(), &assembly.grid->table(), &fields, &status);
  guards_.check_gas(gas_report_, status, 0);

  engine_ = std::make_unique<Engine>(particles_, assembly.model, assembly.contact,
                                     EngineOptions{.dt = steps.dt, .gravity = assembly.model.gravity}, assembly.effects);
  accounts_ = Accounts(particles_, gas_mass());
  assemble_stages();
}

/// Passes and fields that the case's effects ask for, and nothing else.
void Simulation::set_up_effects() {
  const Grid& grid = *assembly_.grid;
  if ((assembly_.effect_reads & (SIMILITUDE_READS_GAS_VORTICITY | SIMILITUDE_READS_GAS_ACCELERATION)) != 0) {
    gas_motion_ = std::make_unique<GasMotion>(assembly_.model, grid, assembly_.coupled(), assembly_.effect_reads);
  }
  for (const EffectModel& effect : assembly_.effects) {
    if (effect.functions().particles != nullptr) effects_.emplace_back(assembly_.model, grid, effect, gas_motion_.get());
    if (effect.functions().cells != nullptr) cell_effects_.emplace_back(assembly_.model, grid, effect);
  }
  if (!cell_effects_.empty()) gas_.added_viscosity.assign(grid.cell_count(), 0);
  const ScalarPlan& plan = assembly_.scalars;
  if (plan.empty()) return;
  if (!plan.gas.empty() && assembly_.coupled()) {
    for (int axis = 0; axis < 3; ++axis) gas_.flux[static_cast<std::size_t>(axis)].assign(grid.face_count(axis), 0);
  }
  scalars_ = std::make_unique<ScalarExchange>(assembly_.model, grid, plan, assembly_.coupled());
  scalars_->start(particles_, gas_, coupling_->fields().gas_fraction);
  if (ContactFlows::wanted(plan)) contact_flows_ = std::make_unique<ContactFlows>(assembly_.model, plan);
}

/// The step to come. A given gas finds eps = 1 and no exchange.
similitude_gas_step Simulation::next_gas_step() {
  const double dt = steps_.gas_dt();
  return gas_step(coupling_->fields(), gas_, static_cast<double>(steps_done_ + 1) * dt, dt);
}

void Simulation::advance_gas() {
  const similitude_gas_step step = next_gas_step();
  similitude_status status{};
  gas_report_ = {};
  gas_report_.struct_size = sizeof(gas_report_);
  assembly_.fluid.functions().advance(assembly_.fluid.instance(), &step, &gas_report_, &status);
  guards_.check_gas(gas_report_, status, step.time);
  keep_books_of_gas(step.dt, step.time);
}

void Simulation::keep_books_of_gas(double dt, double at) {
  const double density = assembly_.model.gas_density;
  const Grid& grid = *assembly_.grid;
  const double displaced = grid.cell_volume() * static_cast<double>(grid.cell_count()) - gas_mass() / density;   // [m^3]
  std::array<double, 3> buoyancy{};
  for (std::size_t axis = 0; axis < 3; ++axis) buoyancy[axis] = -density * displaced * assembly_.model.gravity[axis];
  const BoundaryAction boundary = boundary_.action(gas_, exchange().gas_fraction, density, at);
  accounts_.add_gas_step(gas_report_.inflow, gas_report_.outflow, boundary, buoyancy, dt);
}

void Simulation::assemble_stages() {
  const double gas_dt = steps_.gas_dt();
  stages_.push_back({assembly_.coupled() ? "deposit" : "drag", [this, gas_dt] { coupling_->deposit(particles_, gas_, gas_dt); }});
  if (assembly_.coupled()) {
    stages_.push_back({"guard: gas fraction", [this] {
                         std::size_t cell = 0;
                         const double smallest = coupling_->smallest_gas_fraction(&cell);
                         guards_.check_gas_fraction(smallest, cell_centre(*assembly_.grid, cell), time());
                       }});
  }
  for (CellPass& effect : cell_effects_) {
    const bool first = &effect == &cell_effects_.front();
    stages_.push_back({std::string("effect: ") + effect.id(), [this, first, &effect] {
                         if (first) std::fill(gas_.added_viscosity.begin(), gas_.added_viscosity.end(), 0.0);
                         effect.apply(gas_, coupling_->fields().gas_fraction, time());
                       }});
  }
  if (gas_motion_ && gas_motion_->acceleration()) {
    stages_.push_back({"effects: gas before its step", [this] { gas_motion_->remember(gas_); }});
  }
  stages_.push_back({std::string("fluid: ") + assembly_.fluid.descriptor().id, [this] { advance_gas(); }});
  stages_.push_back({"interpolate", [this, gas_dt] { coupling_->interpolate(particles_, gas_, gas_dt); }});
  if (gas_motion_) {
    stages_.push_back({std::string("effects: ") + (gas_motion_->vorticity() ? "vorticity" : "") +
                           (gas_motion_->vorticity() && gas_motion_->acceleration() ? " and " : "") +
                           (gas_motion_->acceleration() ? "acceleration" : "") + " of the gas",
                       [this, gas_dt] { gas_motion_->update(gas_, time() + gas_dt, gas_dt); }});
  }
  if (particles_.fields.added_mass) {
    stages_.push_back({"effects: no added mass yet", [this] { std::ranges::fill(particles_.added_mass, 0.0); }});
  }
  for (EffectPass& effect : effects_) {
    stages_.push_back({std::string("effect: ") + effect.id(),
                       [this, gas_dt, &effect] { effect.apply(particles_, coupling_->fields().gas_fraction, gas_dt); }});
  }
  if (scalars_) {
    std::string names;
    for (const NamedColumn& scalar : gas_.scalars) names += ", gas " + scalar.name;
    for (const NamedColumn& scalar : particles_.scalars) names += ", " + scalar.name;
    stages_.push_back({"scalars: " + names.substr(2), [this, gas_dt] { scalars_->advance(particles_, gas_, coupling_->fields(), gas_dt); }});
  }
  stages_.push_back({"particles", [this] { engine_->advance(steps_.sub_steps); }});
  if (contact_flows_) {
    stages_.push_back({"scalars: through contacts", [this, gas_dt] {
                         engine_->touching(touching_);
                         contact_flows_->apply(particles_, touching_, gas_dt);
                       }});
  }
  if (assembly_.coupled()) {
    stages_.push_back({"settle accounts", [this] { coupling_->settle_accounts(particles_); }});
  }
  stages_.push_back({"guard: overlap", [this] { guards_.check_particles(engine_->report(), time() + steps_.gas_dt()); }});
  stages_.push_back({"guard: balances", [this] {
                       if ((steps_done_ + 1) % k_steps_between_balances == 0) guards_.check_balances(balances(), time() + steps_.gas_dt());
                     }});
}

void Simulation::step() {
  for (Stage& stage : stages_) {
    const auto start = std::chrono::steady_clock::now();
    stage.work();
    stage.seconds += seconds_since(start);
  }
  ++steps_done_;
}

void Simulation::save(SimulationState& state) const {
  state.steps_done = steps_done_;
  state.particles.copy_rows(particles_);
  engine_->save(state.engine);
  state.gas = gas_;
  coupling_->save(state.coupling);
  state.gas_report = gas_report_;
  save_state_of(assembly_.fluid, state.fluid);
  state.accounts = accounts_.state();
  state.scalar_totals = scalars_ ? scalars_->totals() : std::vector<ScalarTotals>();
  state.scalars_from_walls = contact_flows_ ? contact_flows_->from_walls() : std::vector<double>();
  state.warnings_given = guards_.warnings_given();
}

void Simulation::restore(const SimulationState& state) {
  const std::size_t size = state_size_of(assembly_.fluid);
  if (state.fluid.size() != size) throw std::invalid_argument("the gas solver remembers another number of values");
  if (state.gas.pressure.size() != assembly_.grid->cell_count()) throw std::invalid_argument("the gas has another number of cells");
  if (state.particles.fields.rotation != particles_.fields.rotation || state.particles.fields.coupling != particles_.fields.coupling) {
    throw std::invalid_argument("the particles have other columns");
  }
  if (state.particles.scalars.size() != particles_.scalars.size() || state.gas.scalars.size() != gas_.scalars.size()) {
    throw std::invalid_argument("other scalars are carried");
  }
  steps_done_ = state.steps_done;
  particles_.copy_rows(state.particles);
  engine_->restore(state.engine);
  gas_.velocity = state.gas.velocity;
  gas_.pressure = state.gas.pressure;
  gas_.stress_force = state.gas.stress_force;
  for (std::size_t s = 0; s < gas_.scalars.size(); ++s) gas_.scalars[s].value = state.gas.scalars[s].value;
  if (scalars_) scalars_->set_totals(state.scalar_totals);
  if (contact_flows_) contact_flows_->set_from_walls(state.scalars_from_walls);
  coupling_->restore(state.coupling);
  gas_report_ = state.gas_report;
  gas_report_.struct_size = sizeof(gas_report_);
  if (size > 0) assembly_.fluid.functions().load_state(assembly_.fluid.instance(), state.fluid.data());
  accounts_ = Accounts(state.accounts);
  guards_.restore_warnings_given(state.warnings_given);
}

void Simulation::replay(const SimulationState& state, std::int64_t steps_done) {
  const std::vector<std::uint8_t> given = guards_.warnings_given();
  restore(state);
  guards_.restore_warnings_given(given);
  while (steps_done_ < steps_done) step();
}

double Simulation::gas_mass() const {
  double volume = 0;   // [cells]
  for (const double gas_fraction : exchange().gas_fraction) volume += gas_fraction;
  return assembly_.model.gas_density * assembly_.grid->cell_volume() * volume;
}

Balances Simulation::balances() const {
  GasHeld gas{.mass = gas_mass(), .momentum = coupling_->pending_momentum()};
  for (std::size_t axis = 0; axis < 3; ++axis) gas.momentum[axis] += gas_report_.momentum[axis];
  Balances balances = accounts_.balances(particles_, engine_->report().budget, gas);
  if (!assembly_.coupled()) balances.gas_momentum = std::numeric_limits<double>::quiet_NaN();   // a given gas gives without having
  return balances;
}

std::array<double, 3> Simulation::momentum() const {
  std::array<double, 3> total = momentum_of(particles_);
  const std::array<double, 3> pending = coupling_->pending_momentum();
  for (std::size_t axis = 0; axis < 3; ++axis) total[axis] += gas_report_.momentum[axis] + pending[axis];
  return total;
}

std::vector<StageTime> Simulation::stage_times() const {
  std::vector<StageTime> times;
  for (const Stage& stage : stages_) {
    if (stage.name != "particles") {
      times.push_back({stage.name, stage.seconds});
      continue;
    }
    double accounted = 0;
    for (StageTime part : engine_->stage_times()) {
      accounted += part.seconds;
      part.name = "particles: " + part.name;
      times.push_back(part);
    }
    times.push_back({"particles: other", stage.seconds > accounted ? stage.seconds - accounted : 0});
  }
  return times;
}

std::vector<std::string> Simulation::pipeline() const {
  std::vector<std::string> words;
  for (const Stage& stage : stages_) {
    if (stage.name != "particles") {
      words.push_back(stage.name);
      continue;
    }
    std::string inner = std::to_string(steps_.sub_steps) + " x [";
    for (const std::string& pass : engine_->passes()) inner += (inner.back() == '[' ? "" : " -> ") + pass;
    words.push_back(inner + "]");
  }
  return words;
}

}  // namespace similitude
