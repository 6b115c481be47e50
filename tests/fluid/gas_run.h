#pragma once
/// A gas solver with the fields that its host would own.

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "boxes.h"
#include "solver.h"

namespace similitude::test {

inline std::size_t u(Index row) { return static_cast<std::size_t>(row); }

template <class Solver, class Options>
class RunOf {
 public:
  RunOf(const Box& box, const Options& options) : mesh(box.table()), solver(box.table(), options) {
    const std::size_t cells = u(mesh.cell_count);
    gas_fraction.assign(cells, 1.0);
    gas_fraction_old.assign(cells, 1.0);
    for (auto* field : {&exchange, &pressure}) field->assign(cells, 0.0);
    for (auto* field : {&exchange_velocity, &remainder, &velocity, &stress_force}) field->assign(3 * cells, 0.0);
    solver.start(row());
  }

  /// One step; the gas fraction at its end becomes the old one.
  void advance(double dt) {
    time += dt;
    similitude_gas_step step = row();
    step.time = time;
    step.dt = dt;
    report = {};
    report.struct_size = sizeof report;
    solver.advance(step, report);
    gas_fraction_old = gas_fraction;
  }

  /// Steps until neither velocity nor pressure changes in a step by more than `fraction` of its largest value.
  int advance_until_steady(double dt, double fraction, int most_steps) {
    const auto moved = [&](const std::vector<double>& before, const std::vector<double>& now) {
      double change = 0, largest = 0;
      for (std::size_t c = 0; c < now.size(); ++c) {
        change = std::max(change, std::abs(now[c] - before[c]));
        largest = std::max(largest, std::abs(now[c]));
      }
      return change > fraction * largest;
    };
    for (int n = 1; n <= most_steps; ++n) {
      const std::vector<double> velocity_before = velocity, pressure_before = pressure;
      advance(dt);
      if (!moved(velocity_before, velocity) && !moved(pressure_before, pressure)) return n;
    }
    return most_steps + 1;
  }

  /// Sets face velocities: value(axis, x, y, z) at face centres.
  void set_velocity(const std::function<double(std::size_t, double, double, double)>& value) {
    std::vector<double> state(solver.state_size());
    std::size_t row_of_state = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      Triple at{};
      for (at[2] = 0; at[2] < mesh.face_extent[a][2]; ++at[2]) {
        for (at[1] = 0; at[1] < mesh.face_extent[a][1]; ++at[1]) {
          for (at[0] = 0; at[0] < mesh.face_extent[a][0]; ++at[0]) {
            const auto place = [&](std::size_t b) {
              return (static_cast<double>(at[b]) + (b == a ? 0 : 0.5)) * mesh.spacing[b];
            };
            const std::uint8_t kind = mesh.kind(a, mesh.face(a, at));
            state[row_of_state++] = kind == SIMILITUDE_FACE_OPEN ? value(a, place(0), place(1), place(2)) : 0;
          }
        }
      }
    }
    solver.load(state.data());
  }

  double velocity_at(std::size_t axis, const Triple& cell) const {
    return velocity[axis * u(mesh.cell_count) + u(mesh.cell(cell))];
  }
  double pressure_at(const Triple& cell) const { return pressure[u(mesh.cell(cell))]; }
  double stress_at(std::size_t axis, const Triple& cell) const {
    return stress_force[axis * u(mesh.cell_count) + u(mesh.cell(cell))];
  }

  similitude_gas_step row() {
    similitude_gas_step step{};
    step.struct_size = sizeof step;
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

  Staggered mesh;
  Solver solver;
  std::vector<double> gas_fraction, gas_fraction_old, exchange, exchange_velocity, remainder;
  std::vector<double> velocity, pressure, stress_force;
  similitude_gas_report report{};
  double time = 0;
};

using GasRun = RunOf<vans::GasSolver, vans::GasOptions>;

}  // namespace similitude::test
