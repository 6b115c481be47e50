#include <fmt/format.h>
#include <similitude/drag_law.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "doctor/at_once.h"
#include "doctor/guarded_column.h"
#include "doctor/suites.h"
#include "doctor/trial_values.h"

namespace similitude::doctor {
namespace {

/// One particle in its gas, and where the answer is to be found again.
struct State {
  double gas_fraction, slip;   // [-], [m/s]
  double diameter = trial_bed().drag_diameter, density = trial_bed().gas_density, viscosity = trial_bed().gas_viscosity;
  double cell_size = 5e-3;     // [m]

  double reynolds() const { return density * diameter * slip / viscosity; }
  std::string text() const { return fmt::format("gas fraction {:g}, Re {:g}", gas_fraction, reynolds()); }
};

DragModel made(const PluginEntry& plugin, const similitude_bed& bed = trial_bed()) {
  return create_model<similitude_drag_functions>(plugin, bed, trial_values(*plugin.descriptor));
}

/// A block of states. Columns that the law did not ask for are not there.
class Block {
 public:
  Block(const DragModel& law, const std::vector<State>& states, Edge edge = Edge::far)
      : law_(law), asked_(states.size()), rows_((states.size() + SIMILITUDE_ROW_MULTIPLE - 1) / SIMILITUDE_ROW_MULTIPLE * SIMILITUDE_ROW_MULTIPLE) {
    needs_.struct_size = sizeof needs_;
    if (law.functions().needs != nullptr) law.functions().needs(law.instance(), &needs_);
    const auto column = [&](const char* name, auto value) {
      GuardedColumn c(name, rows_, edge);
      for (std::size_t row = 0; row < rows_; ++row) c[row] = value(states[std::min(row, asked_ - 1)]);
      return c;
    };
    columns_.push_back(column("diameter", [](const State& s) { return s.diameter; }));
    columns_.push_back(column("gas_fraction", [](const State& s) { return s.gas_fraction; }));
    columns_.push_back(column("slip_speed", [](const State& s) { return s.slip; }));
    columns_.push_back(column("gas_density", [](const State& s) { return s.density; }));
    columns_.push_back(column("gas_viscosity", [](const State& s) { return s.viscosity; }));
    columns_.push_back(column("sauter_diameter", [](const State& s) { return s.diameter; }));
    columns_.push_back(column("cell_size", [](const State& s) { return s.cell_size; }));
    exchange_ = GuardedColumn("exchange", rows_, edge);
  }

  void forbid_writing() {
    for (GuardedColumn& column : columns_) column.forbid_writing();
  }

  /// K [kg/s] of every state. Throws Complaint.
  std::vector<double> exchange() {
    const similitude_drag_block block = {sizeof block,
                                         static_cast<std::uint32_t>(rows_),
                                         columns_[0].data(),
                                         columns_[1].data(),
                                         columns_[2].data(),
                                         columns_[3].data(),
                                         columns_[4].data(),
                                         needs_.sauter_diameter != 0 ? columns_[5].data() : nullptr,
                                         needs_.cell_size != 0 ? columns_[6].data() : nullptr,
                                         exchange_.data()};
    for (std::size_t row = 0; row < rows_; ++row) exchange_[row] = std::nan("");   // a row left out is not a number
    similitude_status status{};
    status.row = -1;
    law_.functions().exchange(law_.instance(), &block, &status);
    if (status.code != 0) throw Complaint(status);
    return {exchange_.data(), exchange_.data() + asked_};
  }

 private:
  const DragModel& law_;
  std::size_t asked_, rows_;
  similitude_drag_needs needs_{};
  std::vector<GuardedColumn> columns_;
  GuardedColumn exchange_;
};

std::vector<double> coefficients(const DragModel& law, const std::vector<State>& states) { return Block(law, states).exchange(); }
double coefficient(const DragModel& law, const State& state) { return coefficients(law, {state}).front(); }

State at(double gas_fraction, double reynolds) {
  State state{gas_fraction, 0};
  state.slip = reynolds * state.viscosity / (state.density * state.diameter);
  return state;
}

/// From denser than any packing to one particle in an empty gas, from rest to a fast jet.
std::vector<State> all_states() {
  std::vector<State> states;
  for (const double eps : {0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 0.98, 0.99, 0.999, 1 - 1e-9, 1.0})
    for (const double re : {0.0, 1e-300, 1e-9, 1e-3, 0.1, 1.0, 10.0, 30.0, 100.0, 300.0, 999.0, 1001.0, 3000.0, 1e4})
      states.push_back(at(eps, re));
  return states;
}

const char* const k_look_for_zero =
    "Write the law as Stokes' drag times a factor, 3 pi mu d f(Re, eps), and keep Re = 0 and eps = 1 out of denominators.";

Outcome check_finite(const PluginEntry& plugin) {
  const DragModel law = made(plugin);
  const std::vector<State> states = all_states();
  const std::vector<double> k = coefficients(law, states);
  for (std::size_t n = 0; n < states.size(); ++n) {
    if (!std::isfinite(k[n])) return fail(fmt::format("K is {:g} kg/s at {}.", k[n], states[n].text()), k_look_for_zero);
    // Nothing moves and there are no neighbours: a law of packed beds has nothing left there.
    const bool may_vanish = states[n].gas_fraction == 1 && states[n].reynolds() < 1e-200;
    if (k[n] < 0 || (k[n] == 0 && !may_vanish))
      return fail(fmt::format("K is {:g} kg/s at {}.", k[n], states[n].text()),
                  "Drag brakes: K multiplies u - v and is above zero wherever something moves or has neighbours.");
  }
  const auto [least, most] = std::minmax_element(k.begin(), k.end());
  return ok(fmt::format("K from {:.3g} to {:.3g} kg/s over gas fractions 0.2 to 1 and Re 0 to 10000", *least, *most));
}

/// A particle that leaves the others must not feel a step. The steepest published law grows as 0.48 phi^(1/3): 2e-5 at
/// this distance from an empty gas.
Outcome check_limits(const PluginEntry& plugin) {
  constexpr double step = 1e-13, tolerance = 3e-5;   // [-]
  constexpr double far_from_stokes = 10;             // no shape or filter changes a single particle's drag by more
  const DragModel law = made(plugin);
  const double stokes = 3 * k_pi * trial_bed().gas_viscosity * trial_bed().drag_diameter;
  for (const double re : {0.0, 1.0, 100.0, 900.0}) {
    const double empty = coefficient(law, at(1, re)), nearly = coefficient(law, at(1 - step, re));
    if (!(std::abs(nearly - empty) <= tolerance * (empty + stokes)))
      return fail(fmt::format("K steps from {:.6g} to {:.6g} kg/s where the gas becomes empty, at Re {:g}.", nearly, empty, re),
                  "Let the law of the dense bed tend to that of a single sphere at gas fraction 1.");
  }
  const double single = coefficient(law, at(1, 0)) / stokes;
  if (single != 0 && (single > far_from_stokes || single < 1 / far_from_stokes))
    return fail(fmt::format("K of a single sphere at rest is {:.3g} times Stokes' drag, 3 pi mu d.", single),
                "Return K [kg/s] of one particle, (beta/phi) V_p in terms of the usual beta [kg/(m^3 s)].");
  return ok(fmt::format("no step towards an empty gas; a single sphere at rest feels {:.3g} of Stokes' drag", single));
}

/// The force, K times the slip, grows with the slip: else a bed has two answers to one gas flow.
Outcome check_monotone(const PluginEntry& plugin) {
  const DragModel law = made(plugin);
  for (const double eps : {0.35, 0.45, 0.6, 0.75, 0.85, 0.95, 0.995, 1.0}) {
    std::vector<State> states;
    for (double re = 1e-3; re < 1e4; re *= 1.02) states.push_back(at(eps, re));
    const std::vector<double> k = coefficients(law, states);
    for (std::size_t n = 1; n < k.size(); ++n) {
      if (k[n] * states[n].slip > k[n - 1] * states[n - 1].slip) continue;
      return fail(fmt::format("the drag force falls from {:.6g} to {:.6g} N while the gas gets faster, at {}.",
                              k[n - 1] * states[n - 1].slip, k[n] * states[n].slip, states[n].text()),
                  "Look at where two correlations meet: the join must not step down.");
    }
  }
  return ok("the force grows with the slip from Re 0.001 to 10000, at 8 gas fractions");
}

/// r = 1/4 of the exactly similar beds: d and cell 2^-2, u 2^-1, mu 2^-3, rho 1; K goes as r^(5/2) = 2^-5. Parameters
/// follow by what they declare of their scaling.
Outcome check_similar(const PluginEntry& plugin) {
  constexpr double rounding = 1e-9;   // of thousands of operations
  const similitude_descriptor& model = *plugin.descriptor;
  std::vector<similitude_value> values = trial_values(model);
  const DragModel law = create_model<similitude_drag_functions>(plugin, trial_bed(), values);
  similitude_bed bed = trial_bed();
  for (double* length : {&bed.particle_diameter, &bed.drag_diameter, &bed.bed_width, &bed.bed_depth, &bed.bed_height}) *length /= 4;
  for (double* speed : {&bed.superficial_velocity, &bed.largest_inlet_velocity}) *speed /= 2;
  bed.gas_viscosity /= 8;
  for (std::uint32_t p = 0; p < model.parameter_count; ++p) {
    const int as = model.parameters[p].scales_as;
    const bool length = as == SIMILITUDE_SCALES_AS_LENGTH || as == SIMILITUDE_SCALES_AS_DIAMETER || as == SIMILITUDE_SCALES_AS_MODULUS;
    if (length) values[p].real /= 4;
    if (as == SIMILITUDE_SCALES_AS_TIME || as == SIMILITUDE_SCALES_AS_VELOCITY) values[p].real /= 2;
    if (as == SIMILITUDE_SCALES_AS_STIFFNESS) values[p].real /= 16;
  }
  const DragModel small_law = create_model<similitude_drag_functions>(plugin, bed, values);
  for (const State& real : {at(0.42, 30), at(0.6, 3), at(0.75, 300), at(0.9, 100), at(0.99, 50), at(1, 1)}) {
    State small = real;
    small.slip /= 2;
    small.diameter /= 4;
    small.cell_size /= 4;
    small.viscosity /= 8;
    const double there = coefficient(law, real), here = 32 * coefficient(small_law, small);
    if (!(std::abs(here - there) <= rounding * std::abs(there)))
      return fail(fmt::format("in an exactly similar bed a quarter of the size K is {:.6g} of what it must be, at {}.", here / there, real.text()),
                  "Somewhere a number with a unit stands in the formula: make it a parameter that says how it scales.");
  }
  return ok("an exactly similar bed a quarter of the size has the same drag");
}

Outcome check_edges(const PluginEntry& plugin) {
  const DragModel law = made(plugin);
  const std::vector<State> states = all_states();
  for (const std::size_t rows : {std::size_t{8}, std::size_t{64}, states.size()}) {
    for (const Edge edge : {Edge::end, Edge::start}) {
      Block block(law, {states.begin(), states.begin() + static_cast<std::ptrdiff_t>(rows)}, edge);
      block.forbid_writing();
      block.exchange();
    }
  }
  return ok("blocks of 8, 64 and 296 rows between forbidden pages, inputs write-protected");
}

Outcome check_split(const PluginEntry& plugin) {
  const DragModel law = made(plugin);
  const std::vector<State> states = all_states();
  const std::vector<double> whole = coefficients(law, states);
  constexpr std::size_t step = 101;   // prime to the count: every state once, in another order
  for (std::size_t first = 0; first < states.size(); first += 16) {
    std::vector<State> part;
    std::vector<std::size_t> from;
    for (std::size_t n = first; n < std::min(first + 16, states.size()); ++n) {
      from.push_back(n * step % states.size());
      part.push_back(states[from.back()]);
    }
    const std::vector<double> k = coefficients(law, part);
    for (std::size_t n = 0; n < k.size(); ++n)
      if (k[n] != whole[from[n]] && !(std::isnan(k[n]) && std::isnan(whole[from[n]])))
        return fail(fmt::format("K is {:.17g} kg/s in one block and {:.17g} in another, at {}.", whole[from[n]], k[n], states[from[n]].text()),
                    "A row's answer may depend on that row alone, not on its place or its neighbours.");
  }
  return ok(fmt::format("{} rows give the same bits in one block and in shuffled blocks of 16", states.size()));
}

Outcome check_threads(const PluginEntry& plugin) {
  constexpr std::size_t threads = 4;
  constexpr int rounds = 200;
  const DragModel law = made(plugin);
  const std::vector<State> states = all_states();
  const std::vector<double> alone = coefficients(law, states);
  std::vector<Block> blocks;
  for (std::size_t t = 0; t < threads; ++t) {
    std::vector<State> turned = states;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(t * states.size() / threads), turned.end());
    blocks.emplace_back(law, turned);
  }
  std::vector<std::size_t> wrong(threads, 0);
  const std::vector<std::string> thrown = at_once(threads, [&](std::size_t t) {
    for (int round = 0; round < rounds; ++round) {
      const std::vector<double> k = blocks[t].exchange();
      for (std::size_t n = 0; n < k.size(); ++n)
        wrong[t] += k[n] != alone[(n + t * states.size() / threads) % states.size()] && !std::isnan(k[n]) ? 1 : 0;
    }
  });
  for (const std::string& word : thrown)
    if (!word.empty()) return fail("with 4 threads it reports: " + word, "Keep nothing between calls: several threads call one model at once.");
  const std::size_t all = std::accumulate(wrong.begin(), wrong.end(), std::size_t{0});
  if (all != 0)
    return fail(fmt::format("{} of {} answers differ when 4 threads ask at once.", all, threads * rounds * states.size()),
                "Keep nothing between calls, in the model or in statics: several threads call one model at once.");
  return ok(fmt::format("4 threads at once, {} answers, the same bits as one", threads * rounds * states.size()));
}

}  // namespace

std::vector<Check> drag_suite() {
  return {{"stays in its columns", check_edges},
          {"finite and positive", check_finite, true},
          {"block split", check_split, true},
          {"limits", check_limits},
          {"grows with the slip", check_monotone},
          {"similar beds", check_similar},
          {"threads", check_threads}};
}

}  // namespace similitude::doctor
