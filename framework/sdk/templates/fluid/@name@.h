#pragma once
#include <similitude/fluid_solver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

/// A uniform gas that nothing changes: particles feel it, it does not feel them. Put your solver here, and the source of its
/// equations into this comment.
struct @Type@ {
  double velocity;  // [m/s]
  static constexpr bool sees_particles = false;  // true: the host hands over the solids fraction and its exchange with the gas

  static void parameters(similitude::Parameters<@Type@>& p) {
    p.real("velocity", &@Type@::velocity, {.unit = "m/s", .def = 0, .doc = "of the gas, upward"});
  }

  void prepare(const similitude::Bed& bed) { density_ = bed.gas_density; }

  void initialise(const similitude_grid& grid, const similitude_gas_step& fields) {
    cells_ = static_cast<std::ptrdiff_t>(grid.cells[0]) * grid.cells[1] * grid.cells[2];
    std::copy_n(grid.spacing, 3, spacing_);
    std::fill_n(fields.velocity, 2 * cells_, 0.0);
    std::fill_n(fields.velocity + 2 * cells_, cells_, velocity);
    std::fill_n(fields.pressure, cells_, 0.0);
    std::fill_n(fields.stress_force, 3 * cells_, 0.0);
  }

  void advance(const similitude_gas_step& step, similitude_gas_report& report) const {
    report.momentum[2] = density_ * static_cast<double>(cells_) * (spacing_[0] * spacing_[1] * spacing_[2]) * velocity;
    report.courant = std::abs(velocity) * step.dt / spacing_[2];
  }

 private:
  double density_ = 0;        // [kg/m^3]
  std::ptrdiff_t cells_ = 0;  // in the whole bed
  double spacing_[3]{};       // [m]
};
