#include "stepper/run_outputs.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "stepper/seconds_since.h"

namespace similitude {
namespace {

constexpr double k_profile_interval = 1e-3;   // [s] of the real bed: two or three particle diameters of a fast spout

std::vector<std::string> class_names(const RealScene& scene) {
  std::vector<std::string> names;
  for (const auto& particles : scene.particles) names.push_back(particles.name);
  return names;
}

}  // namespace

bool Schedule::due(double time) {
  if (!(every_ > 0) || time < from_) return false;
  // A step that lands on a multiple up to rounding counts as having reached it.
  const auto reached = static_cast<std::int64_t>(std::floor((time - from_) / every_ * (1 + 1e-12))) + 1;
  if (reached <= served_) return false;
  served_ = reached;
  return true;
}

RunOutputs::RunOutputs(const OutputDirectory& directory, const Assembly& assembly, const OutputsState* state,
                       std::optional<double> time)
    : directory_(directory),
      assembly_(assembly),
      map_back_(map_back(assembly)),
      vtk_(directory, map_back_, class_names(assembly.real)),
      monitors_(state != nullptr ? MonitorFile(directory, state->monitors_length) : MonitorFile(directory)),
      profiles_(profile_settings(assembly.real), map_back_),
      front_view_(directory, map_back_, assembly.real.size[0], assembly.real.size[2],
                  time ? std::optional<double>(map_back_.time(*time)) : std::nullopt),
      front_view_schedule_(assembly.model.time.end / k_front_view_pictures, 0),
      vtk_schedule_(assembly.model.output.vtk_every, 0),
      monitor_schedule_(assembly.model.output.monitor_every, 0),
      profile_schedule_(k_profile_interval * assembly.results.time, assembly.model.output.profiles.from) {
  if (!assembly.scalars.empty()) {
    if (state != nullptr && state->scalars_length > 0) {
      scalars_.emplace(directory, state->scalars_length);
    } else {
      scalars_.emplace(directory);
    }
  }
  const std::vector<Probe>& probes = assembly.model.output.probes;
  if (probes.empty()) return;
  if (state != nullptr && state->probes_length > 0) {
    probes_.emplace(directory, probes, *assembly.grid, map_back_, state->probes_length);
  } else {
    probes_.emplace(directory, probes, *assembly.grid, map_back_);
  }
}

RunOutputs::RunOutputs(const OutputDirectory& directory, const Assembly& assembly) : RunOutputs(directory, assembly, nullptr, {}) {}

RunOutputs::RunOutputs(const OutputDirectory& directory, const Assembly& assembly, const OutputsState& state, double time)
    : RunOutputs(directory, assembly, &state, time) {
  vtk_.go_on_after(state.frames);
  profiles_.restore(state.profiles);
  for (Schedule* schedule : {&front_view_schedule_, &vtk_schedule_, &monitor_schedule_, &profile_schedule_}) schedule->pass(time);
  last_frame_time_ = state.last_frame_time;
  largest_overlap_ = state.largest_overlap;
  largest_overlap_of_run_ = state.largest_overlap_of_run;
}

void RunOutputs::save(OutputsState& state) const {
  state.frames = vtk_.frames();
  state.last_frame_time = last_frame_time_;
  state.monitors_length = monitors_.length();
  state.probes_length = probes_ ? probes_->length() : 0;
  state.scalars_length = scalars_ ? scalars_->length() : 0;
  state.largest_overlap = largest_overlap_;
  state.largest_overlap_of_run = largest_overlap_of_run_;
  state.profiles = profiles_.state();
}

void RunOutputs::write_frame(const Simulation& simulation) {
  vtk_.particles(simulation.particles(), simulation.time());
  vtk_.fluid(*assembly_.grid, simulation.gas(), simulation.exchange().gas_fraction, simulation.time());
  last_frame_time_ = simulation.time();
}

void RunOutputs::write_monitors(const Simulation& simulation) {
  const Observed observed{.time = simulation.time(),
                    .particles = &simulation.particles(),
                    .engine = &simulation.engine().report(),
                    .grid = assembly_.grid.get(),
                    .gas = &simulation.gas(),
                    .gas_fraction = &simulation.exchange().gas_fraction,
                    .gas_report = &simulation.gas_report(),
                    .accounts = &simulation.accounts(),
                    .balances = simulation.balances(),
                    .gas_density = assembly_.model.gas_density,
                    .largest_overlap_ratio = largest_overlap_};
  monitors_.write(similitude::observe(observed, map_back_));
  if (probes_) probes_->write(simulation.time(), simulation.gas(), simulation.exchange().gas_fraction);
  if (scalars_) write_scalars(simulation);
  largest_overlap_ = 0;
}

/// A bed with scalars has the real bed's gas and particles (assembly.cpp), so that values and amounts need no mapping.
void RunOutputs::write_scalars(const Simulation& simulation) {
  const ScalarPlan& plan = assembly_.scalars;
  const ScalarExchange& scalars = *simulation.scalars();
  const double time = map_back_.time(simulation.time());
  const Column<double>& gas_fraction = simulation.exchange().gas_fraction;
  for (std::size_t s = 0; s < plan.gas.size(); ++s) {
    const Column<double>& value = simulation.gas().scalars[s].value;
    const auto [lowest, highest] = std::ranges::minmax(value);
    double weighted = 0, weight = 0;
    for (std::size_t c = 0; c < value.size(); ++c) {
      weighted += gas_fraction[c] * value[c];
      weight += gas_fraction[c];
    }
    const ScalarTotals& totals = scalars.totals()[s];
    scalars_->write(time, {plan.gas[s].name, plan.gas[s].unit, "gas", plan.gas[s].amount_unit, weighted / weight, lowest, highest,
                           scalars.gas_amount(s, simulation.gas(), gas_fraction) - totals.at_start, totals.in, totals.out, totals.walls,
                           totals.exchanged});
  }
  for (std::size_t s = 0; s < plan.particles.size(); ++s) {
    constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
    const ParticleStore& particles = simulation.particles();
    const Column<double>& value = particles.scalars[s].value;
    if (value.empty()) continue;
    const auto [lowest, highest] = std::ranges::minmax(value);
    double weighted = 0, weight = 0;
    for (std::size_t p = 0; p < value.size(); ++p) {
      weighted += particles.velocity[p].w * value[p];
      weight += particles.velocity[p].w;
    }
    const ContactFlows* flows = simulation.contact_flows();
    scalars_->write(time, {plan.particles[s].name, plan.particles[s].unit, "particles", plan.particles[s].amount_unit, weighted / weight,
                           lowest, highest, scalars.particle_amount(s, particles), k_none, k_none,
                           flows != nullptr ? flows->from_walls()[s] : k_none, k_none});
  }
}

void RunOutputs::observe(const Simulation& simulation) {
  const double overlap = simulation.engine().report().largest_overlap.overlap_ratio;
  largest_overlap_ = std::max(largest_overlap_, overlap);
  largest_overlap_of_run_ = std::max(largest_overlap_of_run_, overlap);
  if (profile_schedule_.due(simulation.time())) {
    profiles_.sample(simulation.particles(), simulation.time());
    profiles_.sample(*assembly_.grid, simulation.exchange().gas_fraction, simulation.time());
  }
  if (monitor_schedule_.due(simulation.time())) write_monitors(simulation);
  if (front_view_schedule_.due(simulation.time())) front_view_.add(simulation.particles(), simulation.time());
  if (vtk_schedule_.due(simulation.time())) write_frame(simulation);
}

double RunOutputs::seconds_to_the_end(const Simulation& simulation) {
  const double end = assembly_.model.time.end;
  const auto times = [&](double every, double from) { return every > 0 ? std::max(0.0, (end - from) / every) : 0.0; };
  const auto seconds_of = [](auto&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return seconds_since(start);
  };
  const Output& asked = assembly_.model.output;
  double seconds = times(asked.monitor_every, 0) * seconds_of([&] { write_monitors(simulation); });
  seconds += k_front_view_pictures * seconds_of([&] { front_view_.add(simulation.particles(), simulation.time()); });
  if (asked.vtk_every > 0) seconds += times(asked.vtk_every, 0) * seconds_of([&] { write_frame(simulation); });
  if (!asked.profiles.z.empty())
    seconds += times(k_profile_interval * assembly_.results.time, asked.profiles.from) * seconds_of([&] {
      profiles_.sample(simulation.particles(), simulation.time());
      profiles_.sample(*assembly_.grid, simulation.exchange().gas_fraction, simulation.time());
    });
  return seconds;
}

void RunOutputs::finish(const Simulation& simulation) {
  if (draws() && last_frame_time_ < simulation.time()) write_frame(simulation);
  if (profiles_.settings().heights.empty()) return;
  write_profiles(directory_, profiles_.rows());
  write_profile_blocks(directory_, profiles_.block_rows());
}

}  // namespace similitude
