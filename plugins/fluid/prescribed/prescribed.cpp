#include <similitude/fluid_solver.h>

#include <algorithm>
#include <cmath>

namespace {

/// A uniform gas that nothing changes: particles feel it, it does not feel them.
struct Prescribed {
  double velocity_x = 0, velocity_y = 0, velocity_z = 0;  // [m/s]
  static constexpr bool sees_particles = false;

  static void parameters(similitude::Parameters<Prescribed>& p) {
    p.real("velocity_x", &Prescribed::velocity_x, {.unit = "m/s", .def = 0, .doc = "velocity of the gas along x"});
    p.real("velocity_y", &Prescribed::velocity_y, {.unit = "m/s", .def = 0, .doc = "velocity of the gas along y"});
    p.real("velocity_z", &Prescribed::velocity_z, {.unit = "m/s", .def = 0, .doc = "velocity of the gas along z"});
  }

  void prepare(const similitude::Bed& bed) { density_ = bed.gas_density; }

  void initialise(const similitude_grid& grid, const similitude_gas_step& fields) {
    cells_ = static_cast<std::ptrdiff_t>(grid.cells[0]) * grid.cells[1] * grid.cells[2];
    std::copy_n(grid.spacing, 3, spacing_);
    std::fill_n(fields.velocity, cells_, velocity_x);
    std::fill_n(fields.velocity + cells_, cells_, velocity_y);
    std::fill_n(fields.velocity + 2 * cells_, cells_, velocity_z);
    std::fill_n(fields.pressure, cells_, 0.0);
    std::fill_n(fields.stress_force, 3 * cells_, 0.0);
  }

  void advance(const similitude_gas_step& step, similitude_gas_report& report) const {
    const double velocity[3] = {velocity_x, velocity_y, velocity_z};
    const double volume = static_cast<double>(cells_) * (spacing_[0] * spacing_[1] * spacing_[2]);
    for (int a = 0; a < 3; ++a) {
      report.momentum[a] = density_ * volume * velocity[a];
      report.courant += std::abs(velocity[a]) * step.dt / spacing_[a];
    }
  }

 private:
  double density_ = 0;  // [kg/m^3]
  std::ptrdiff_t cells_ = 0;
  double spacing_[3]{};  // [m]
};

}  // namespace

SIMILITUDE_FLUID_SOLVER(Prescribed, "prescribed", "1.0.0", "A uniform gas that nothing changes")
