#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "doctor/guarded_column.h"
#include "doctor/suites.h"
#include "doctor/trial_values.h"
#include "fluid/grid.h"

namespace similitude::doctor {
namespace {

constexpr double k_inlet_velocity = 0.5;   // [m/s], superficial
constexpr double k_packed = 0.45;          // [-], gas fraction of the lower half
constexpr double k_drag = 2e3;             // [kg/(m^3 s)], sum of K per volume there: a bed near fluidisation
constexpr double k_dt = 5e-4;              // [s]

/// 8 x 4 x 12 cells of 5 mm: gas in at the bottom if `inlet`, out at the top.
RealScene box(bool inlet) {
  RealScene scene = trial_scene();
  scene.size = {0.04, 0.02, 0.06};
  scene.patches.clear();
  if (inlet) {
    Patch in;
    in.name = "inlet";
    in.extent = {Interval{0, 0.04}, Interval{0, 0.02}, Interval{0, 0}};
    in.velocity = k_inlet_velocity;
    scene.patches.push_back(in);
  }
  Patch out;
  out.name = "outlet";
  out.face = {Axis::z, Side::high};
  out.kind = PatchKind::pressure;
  out.extent = {Interval{0, 0.04}, Interval{0, 0.02}, Interval{0.06, 0.06}};
  scene.patches.push_back(out);
  return scene;
}

/// A solver in a box whose lower half is packed with particles at rest.
class Run {
 public:
  Run(const PluginEntry& plugin, bool inlet, Edge edge = Edge::far, double drag = k_drag)
      : grid_(box(inlet)), model_(create_model<similitude_fluid_functions>(plugin, trial_bed(), trial_values(*plugin.descriptor))) {
    const std::size_t cells = grid_.cell_count();
    gas_fraction = GuardedColumn("gas_fraction", cells, edge);
    gas_fraction_old = GuardedColumn("gas_fraction_old", cells, edge);
    exchange = GuardedColumn("exchange", cells, edge);
    exchange_velocity = GuardedColumn("exchange_velocity", 3 * cells, edge);
    remainder = GuardedColumn("remainder", 3 * cells, edge);
    velocity = GuardedColumn("velocity", 3 * cells, edge);
    pressure = GuardedColumn("pressure", cells, edge);
    stress_force = GuardedColumn("stress_force", 3 * cells, edge);
    for (std::size_t c = 0; c < cells; ++c) {
      const bool below = c < cells / 2;
      gas_fraction[c] = gas_fraction_old[c] = below ? k_packed : 1;
      exchange[c] = below ? drag : 0;
    }
    if (edge != Edge::far) forbid_writing();
    similitude_gas_step fields = step();
    similitude_status status{};
    model_.functions().initialise(model_.instance(), &grid_.table(), &fields, &status);
    if (status.code != 0) throw Complaint(status);
  }

  void advance() {
    time_ += k_dt;
    similitude_gas_step now = step();
    report = {};
    report.struct_size = sizeof report;
    similitude_status status{};
    model_.functions().advance(model_.instance(), &now, &report, &status);
    if (status.code != 0) throw Complaint(status);
  }
  void advance(int steps) {
    for (int n = 0; n < steps; ++n) advance();
  }

  double largest_speed() const {   // [m/s]
    double most = 0;
    for (std::size_t c = 0; c < velocity.rows(); ++c) most = std::isfinite(velocity[c]) ? std::max(most, std::abs(velocity[c])) : INFINITY;
    return most;
  }
  bool same_bits(const Run& other) const {
    const auto equal = [](const GuardedColumn& a, const GuardedColumn& b) { return std::equal(a.data(), a.data() + a.rows(), b.data()); };
    return equal(velocity, other.velocity) && equal(pressure, other.pressure) && equal(stress_force, other.stress_force);
  }
  /// Fields and state, as a checkpoint holds them.
  void take_over(const Run& other) {
    time_ = other.time_;
    std::copy(other.velocity.data(), other.velocity.data() + velocity.rows(), velocity.data());
    std::copy(other.pressure.data(), other.pressure.data() + pressure.rows(), pressure.data());
    std::copy(other.stress_force.data(), other.stress_force.data() + stress_force.rows(), stress_force.data());
    std::vector<double> state;
    save_state_of(other.model_, state);
    if (!state.empty()) model_.functions().load_state(model_.instance(), state.data());
  }

  const Grid& grid() const { return grid_; }
  double inlet_flow() const { return trial_bed().gas_density * k_inlet_velocity * 0.04 * 0.02; }   // [kg/s]

  GuardedColumn gas_fraction, gas_fraction_old, exchange, exchange_velocity, remainder, velocity, pressure, stress_force;
  similitude_gas_report report{};

 private:
  void forbid_writing() {
    for (GuardedColumn* column : {&gas_fraction, &gas_fraction_old, &exchange, &exchange_velocity, &remainder}) column->forbid_writing();
  }
  similitude_gas_step step() {
    similitude_gas_step step{};
    step.struct_size = sizeof step;
    step.time = time_;
    step.dt = k_dt;
    step.gas_fraction = gas_fraction.data();
    step.gas_fraction_old = gas_fraction_old.data();
    step.exchange = exchange.data();
    step.exchange_velocity = exchange_velocity.data();
    step.remainder = remainder.data();
    step.velocity = velocity.data();
    step.pressure = pressure.data();
    step.stress_force = stress_force.data();
    return step;
  }

  Grid grid_;
  FluidModel model_;
  double time_ = 0;
};

bool sees_particles(const PluginEntry& plugin) {
  return static_cast<const similitude_fluid_functions*>(plugin.descriptor->functions)->sees_particles != 0;
}
const char* const k_given = "it declares that it does not see particles: a given gas";

Outcome check_edges(const PluginEntry& plugin) {
  for (const Edge edge : {Edge::end, Edge::start}) Run(plugin, true, edge).advance(3);
  return ok("8 x 4 x 12 cells between forbidden pages, inputs write-protected");
}

/// Against the speed that gravity would give the gas over the box's height.
Outcome check_quiescent(const PluginEntry& plugin) {
  constexpr double rounding = 1e-10;
  if (!sees_particles(plugin)) return skipped(k_given);
  Run run(plugin, false);
  run.advance(20);
  const double free_fall = std::sqrt(trial_bed().gravity * 0.06);
  if (!(run.largest_speed() <= rounding * free_fall))
    return fail(fmt::format("closed but for its outlet, over a bed at rest, the gas moves at {:.3g} m/s after 20 steps.", run.largest_speed()),
                "The pressure is the full one minus rho g.x, so gravity drives nothing: look for a force that is there without a cause.");
  return ok(fmt::format("20 steps over a bed at rest: largest speed {:.2g} m/s", run.largest_speed()));
}

/// Every cell's imbalance is bounded by the solver's own tolerance, at loosest 1e-6 of the throughput: 384 cells' 4e-4.
Outcome check_mass(const PluginEntry& plugin) {
  constexpr double tolerance = 1e-3;
  if (!sees_particles(plugin)) return skipped(k_given);
  Run run(plugin, true);
  run.advance(40);
  const double in = run.inlet_flow();
  const char* const what = "div(eps u) = -d(eps)/dt in every cell, and the report counts what crosses the patches.";
  if (!(std::abs(run.report.inflow / in - 1) <= tolerance))
    return fail(fmt::format("{:.6g} kg/s enter by its report, and the inlet gives {:.6g}.", run.report.inflow, in), what);
  if (!(std::abs(run.report.outflow / in - 1) <= tolerance))
    return fail(fmt::format("{:.6g} kg/s enter and {:.6g} kg/s leave a bed at rest.", in, run.report.outflow), what);
  const Grid& grid = run.grid();
  const std::size_t cells = grid.cell_count();
  for (const int k : {2, 9}) {   // away from the step of the gas fraction
    double flux = 0;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 8; ++i)
        flux += run.gas_fraction[grid.cell(i, j, k)] * run.velocity[2 * cells + grid.cell(i, j, k)] * grid.spacing(0) * grid.spacing(1);
    const double through = trial_bed().gas_density * flux;
    if (!(std::abs(through / in - 1) <= tolerance))
      return fail(fmt::format("{:.6g} kg/s enter and {:.6g} kg/s pass the cells of layer {}.", in, through, k), what);
  }
  const double out = run.report.outflow;
  double pushed = 0;   // [kg/s]: the bed swells into the gas above it
  for (std::size_t c = cells / 2; c < 3 * cells / 4; ++c) {
    run.gas_fraction[c] = 0.98;
    pushed += trial_bed().gas_density * (run.gas_fraction_old[c] - run.gas_fraction[c]) * grid.cell_volume() / k_dt;
  }
  run.advance();
  if (!(std::abs(run.report.outflow / (in + pushed) - 1) <= tolerance))
    return fail(fmt::format("{:.6g} kg/s enter, swelling solids displace {:.6g} kg/s, and {:.6g} kg/s leave.", in, pushed, run.report.outflow), what);
  return ok(fmt::format("{:.4g} kg/s in, {:.4g} out, {:.4g} while solids swell; residual {:.2g}", in, out, run.report.outflow, run.report.mass_residual));
}

/// A drag whose time scale is a millionth of the step: taken explicitly it would blow up in the first one.
Outcome check_stiff_drag(const PluginEntry& plugin) {
  constexpr double stiff = 2.5e9;   // [kg/(m^3 s)]
  if (!sees_particles(plugin)) return skipped(k_given);
  Run run(plugin, true, Edge::far, stiff);
  run.advance(10);
  const double fastest = k_inlet_velocity / k_packed;   // [m/s], plug flow through the bed
  if (!(run.largest_speed() <= 5 * fastest))
    return fail(fmt::format("with a drag a million times stiffer than its step the gas reaches {:.3g} m/s.", run.largest_speed()),
                "Take the drag implicitly, in the momentum predictor and in the pressure equation: 1/(1 + beta dt/(eps rho)).");
  return ok(fmt::format("a drag a million times stiffer than the step: largest speed {:.3g} m/s", run.largest_speed()));
}

Outcome check_threads(const PluginEntry& plugin) {
  omp_set_num_threads(1);
  Run one(plugin, true);
  one.advance(5);
  omp_set_num_threads(3);
  Run three(plugin, true);
  three.advance(5);
  if (!one.same_bits(three))
    return fail("with 1 and with 3 threads the fields differ.", "Sum in a fixed order: no float atomics, no reduction clause over cells.");
  return ok("5 steps give the same bits with 1 and with 3 threads");
}

Outcome check_restart(const PluginEntry& plugin) {
  Run through(plugin, true);
  through.advance(5);
  Run resumed(plugin, true);
  resumed.take_over(through);
  through.advance(5);
  resumed.advance(5);
  if (!through.same_bits(resumed))
    return fail("5 steps after a restart the fields differ from those of a run without one.",
                "What a step leaves for the next beyond velocity and pressure belongs in save_state().");
  return ok("5 steps after a restart give the same bits");
}

}  // namespace

std::vector<Check> fluid_suite() {
  return {{"stays in its columns", check_edges}, {"quiescent stays quiescent", check_quiescent}, {"mass balance", check_mass},
          {"stiff drag", check_stiff_drag}, {"threads", check_threads}, {"restart", check_restart}};
}

}  // namespace similitude::doctor
