// The gas solver as a plugin.
#include <similitude/fluid_solver.h>

#include "solver.h"
#include "viscous.h"

namespace {

using similitude::vans::Advection;
using similitude::vans::GasOptions;
using similitude::vans::GasSolver;
using similitude::vans::Momentum;

/// Volume-averaged Navier-Stokes: Anderson & Jackson 1967, Ind. Eng. Chem. Fundam. 6, 527; models A and B after Gidaspow
/// 1994, Multiphase Flow and Fluidization.
struct Vans {
  Momentum momentum = Momentum::model_a;
  Advection advection = Advection::tvd;
  double tolerance = 0;   // [-]
  int iterations = 0;

  static void parameters(similitude::Parameters<Vans>& p) {
    p.choice("momentum", &Vans::momentum,
             {.choices = "model_a|model_b|as_printed", .def = "model_a",
              .doc = "who feels the pressure gradient: gas and particles by volume, the gas alone with the drag divided by "
                     "the gas fraction, or the gas by volume and the particles not at all (momentum is lost)",
              .reference = "Zhou et al. 2010, J. Fluid Mech. 661, 482"});
    p.choice("advection", &Vans::advection,
             {.choices = "tvd|upwind", .def = "tvd",
              .doc = "transport of momentum: second order with Koren's limiter, or first-order upwind"});
    p.real("tolerance", &Vans::tolerance,
           {.unit = "1", .def = 1e-7, .min = 1e-14, .max = 1e-2, .typical_min = 1e-10, .typical_max = 1e-5,
            .doc = "largest imbalance of a cell's gas relative to the throughput"});
    p.integer("iterations", &Vans::iterations,
              {.def = 100, .min = 1, .max = 10000, .doc = "most iterations of the pressure equation per step"});
  }

  void prepare(const similitude::Bed& bed) {
    density_ = bed.gas_density;
    viscosity_ = bed.gas_viscosity;
  }

  void initialise(const similitude_grid& grid, const similitude_gas_step& fields) {
    solver_ = std::make_unique<GasSolver>(grid, GasOptions{.density = density_,
                                                           .viscosity = viscosity_,
                                                           .advection = advection,
                                                           .momentum = momentum,
                                                           .tolerance = tolerance,
                                                           .most_iterations = iterations});
    solver_->start(fields);
  }
  void advance(const similitude_gas_step& step, similitude_gas_report& report) { solver_->advance(step, report); }
  double largest_stable_step(const similitude_grid& grid) const {
    return similitude::vans::viscous_limit(density_, viscosity_, {grid.spacing[0], grid.spacing[1], grid.spacing[2]});
  }
  similitude_fluid_needs needs() const {
    similitude_fluid_needs needs{};
    needs.drag_over_gas_fraction = momentum == Momentum::model_b ? 1 : 0;
    needs.takes_added_viscosity = needs.gives_flux = 1;
    return needs;
  }
  std::uint64_t state_size() const { return solver_->state_size(); }
  void save_state(double* out) const { solver_->save(out); }
  void load_state(const double* in) { solver_->load(in); }

 private:
  double density_ = 0;     // [kg/m^3]
  double viscosity_ = 0;   // [Pa s]
  std::unique_ptr<GasSolver> solver_;
};

}  // namespace

SIMILITUDE_FLUID_SOLVER(Vans, "vans", "1.0.0", "Volume-averaged Navier-Stokes, incompressible", nullptr,
                        "Anderson & Jackson 1967, Ind. Eng. Chem. Fundam. 6, 527; Gidaspow 1994, Multiphase Flow and "
                        "Fluidization")
