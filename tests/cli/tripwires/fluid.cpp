// A gas at rest whose report goes wrong on purpose after some steps.
#include <similitude/fluid_solver.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace {

enum class Trip { failure, not_finite, courant, mass, drift, no_way_back };

struct Tripwire {
  Trip trip = Trip::failure;
  double steps = 5;

  static void parameters(similitude::Parameters<Tripwire>& p) {
    p.choice("trip", &Tripwire::trip, {.choices = "failure|not_finite|courant|mass|drift|no_way_back", .def = "failure", .doc = "what goes wrong"});
    p.real("steps", &Tripwire::steps, {.unit = "1", .def = 5, .min = 0, .doc = "gas steps before it does"});
  }

  void initialise(const similitude_grid& grid, const similitude_gas_step& fields) {
    const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(grid.cells[0]) * grid.cells[1] * grid.cells[2];
    std::fill_n(fields.velocity, 3 * cells, 0.0);
    std::fill_n(fields.pressure, cells, 0.0);
    std::fill_n(fields.stress_force, 3 * cells, 0.0);
  }

  void advance(const similitude_gas_step&, similitude_gas_report& report) {
    if (trip == Trip::drift) report.inflow = 1e-3;   // nothing of it ever arrives
    if (++done_ <= steps) return;
    if (trip == Trip::failure || trip == Trip::no_way_back) throw std::runtime_error("this gas has had enough.\n  Give it a rest.");
    if (trip == Trip::not_finite) report.courant = std::numeric_limits<double>::quiet_NaN();
    if (trip == Trip::courant) report.courant = 1.5;
    if (trip == Trip::mass) report.mass_residual = 1e-3;
  }

  // Of another size, what was saved before is refused.
  std::uint64_t state_size() const { return trip == Trip::no_way_back && done_ > steps ? 2 : 1; }
  void save_state(double* out) const { *out = done_; }
  void load_state(const double* in) { done_ = *in; }

 private:
  double done_ = 0;
};

}  // namespace

SIMILITUDE_FLUID_SOLVER(Tripwire, "tripwire", "1.0.0", "A gas that goes wrong on purpose")
