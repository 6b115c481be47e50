// The bed as a porous medium, as a plugin.
#include <similitude/fluid_solver.h>

#include "porous_solver.h"

namespace {

using similitude::porous::GasOptions;
using similitude::porous::PorousSolver;

/// Darcy's law with the drag law's own resistance (Ergun 1952, Chem. Eng. Prog. 48, 89, if that is the drag law).
struct Porous {
  double free_resistance = 0;   // [-]
  double tolerance = 0;         // [-]
  int iterations = 0;

  static void parameters(similitude::Parameters<Porous>& p) {
    p.real("free_resistance", &Porous::free_resistance,
           {.unit = "1", .def = 1e-3, .min = 1e-8, .max = 1, .typical_min = 1e-5, .typical_max = 1e-2,
            .doc = "least resistance anywhere, of the bed's own: what stands in for inertia where there are no particles"});
    p.real("tolerance", &Porous::tolerance,
           {.unit = "1", .def = 1e-6, .min = 1e-14, .max = 1e-2, .typical_min = 1e-10, .typical_max = 1e-5,
            .doc = "largest imbalance of a cell's gas relative to the throughput"});
    p.integer("iterations", &Porous::iterations,
              {.def = 100, .min = 1, .max = 10000, .doc = "most iterations of the pressure equation per step"});
  }

  void prepare(const similitude::Bed& bed) { density_ = bed.gas_density; }

  void initialise(const similitude_grid& grid, const similitude_gas_step& fields) {
    solver_ = std::make_unique<PorousSolver>(grid, GasOptions{.density = density_,
                                                              .free_resistance = free_resistance,
                                                              .tolerance = tolerance,
                                                              .most_iterations = iterations});
    solver_->start(fields);
  }
  void advance(const similitude_gas_step& step, similitude_gas_report& report) { solver_->advance(step, report); }
  similitude_fluid_needs needs() const {
    similitude_fluid_needs needs{};
    needs.any_courant_number = 1;
    needs.gives_flux = 1;
    return needs;
  }
  std::uint64_t state_size() const { return solver_->state_size(); }
  void save_state(double* out) const { solver_->save(out); }
  void load_state(const double* in) { solver_->load(in); }

 private:
  double density_ = 0;   // [kg/m^3]
  std::unique_ptr<PorousSolver> solver_;
};

}  // namespace

SIMILITUDE_FLUID_SOLVER(Porous, "porous", "1.0.0", "Gas without inertia in a porous bed: drag and pressure only", nullptr,
                        "Darcy 1856, Les fontaines publiques de la ville de Dijon; Ergun 1952, Chem. Eng. Prog. 48, 89")
