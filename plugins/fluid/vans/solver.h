#pragma once
/// Volume-averaged Navier-Stokes, incompressible, on a staggered grid:
///
///   d(eps)/dt + div(eps u) = 0
///   rho [d(eps u)/dt + div(eps u u)] = s (-grad p + div(tau)) - E u + (E v) + R
///
/// with s = eps in model A and 1 in model B, E, (E v) and R from the particles (similitude_gas_step) and p without its
/// hydrostatic part. A step predicts u with the old pressure, drag already implicit, and projects:
/// rho eps (u' - u*)/dt = -s grad(p' - p) - E (u' - u*), so that the coefficient of the pressure equation, eps s/(rho eps/dt
/// + E), carries 1/(1 + E dt/(eps rho)).
///
/// Face values of cell fields are means of the two cells. With interpolation back by the same mean, what the gas loses on
/// faces is what particles receive in cells: in a periodic box the momentum of gas and particles is conserved to rounding.
///
/// Advection takes two stages (Heun) with the flux of the step's beginning: one Euler stage with a second-order limiter
/// steepens smooth waves into stairs, and two keep the scheme stable up to a Courant number near one. The stage in between
/// is the whole prediction, forces included, so that a steady state does not depend on the time step.

#include <memory>
#include <string>

#include "advection.h"
#include "fluid/face_flow.h"

namespace similitude::vans {

/// Where the stress on what is immersed goes. Zhou et al. 2010, J. Fluid Mech. 661, 482 name the first two sets II and III.
enum class Momentum {
  model_a,      // the gas keeps eps (-grad p + div tau), the particles the rest
  model_b,      // the gas keeps all of it, and the drag is K / eps
  as_printed    // the gas as in model A, the particles none of it: momentum is lost
};

struct GasOptions {
  double density = 0;               // [kg/m^3]
  double viscosity = 0;             // [Pa s]
  Advection advection = Advection::tvd;
  Momentum momentum = Momentum::model_a;
  double tolerance = 1e-7;          // [-], of a cell's mass balance relative to the throughput
  int most_iterations = 100;
};

class GasSolver : public flow::FaceFlow {
 public:
  /// `grid` stays valid. Throws std::invalid_argument if an inlet has no outlet.
  GasSolver(const similitude_grid& grid, const GasOptions& options);

  /// Gas at rest at p = 0. Fills the step's fields.
  using FaceFlow::start;
  /// Throws std::runtime_error with cause and advice if the pressure equation does not converge or a velocity is not finite.
  void advance(const similitude_gas_step& step, similitude_gas_report& report);

 private:
  void viscous_force(const similitude_gas_step& step);
  void set_added_viscosity(const double* added_in_cells);
  void add_transport(const FaceFields& velocity, Gain kind);
  void predict(const similitude_gas_step& step, double share, FaceFields& predicted);
  void fill_stress(const similitude_gas_step& step);
  void fill_momentum(similitude_gas_report& report) const;

  GasOptions options_;
  std::array<Component, 3> components_;

  // velocity_ holds slots after the faces (stencils.h).
  FaceFields stage_;          // [m/s], the intermediate velocity of advection
  FaceFields fraction_old_;   // [-], start of step
  std::array<std::vector<double>, 3> gain_;     // [m/s^2], active faces: advection
  std::array<std::vector<double>, 3> viscous_;  // [N/m^3], active faces
  SiteFields sites_;          // scratch, of one component
  // Only where something adds viscosity.
  FaceFields added_viscosity_;                              // [Pa s], faces
  std::array<std::vector<std::array<Row, 2>>, 3> cells_of_;   // of every face; one cell twice at the edge of the domain
};

}  // namespace similitude::vans
