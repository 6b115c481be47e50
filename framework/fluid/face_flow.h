#pragma once
/// What solvers of an incompressible gas with velocities on faces share: gas fractions, gradients and divergences, the
/// projection onto div(eps u) = -d(eps)/dt, and what a step tells its host. A solver derives from it, predicts u under the
/// old pressure, sets mobility_ and coefficient_, and projects.

#include <array>
#include <vector>

#include "fluid/face_tables.h"
#include "fluid/multigrid_cg.h"

namespace similitude::flow {

class FaceFlow {
 public:
  /// Velocities on faces; for checkpoints. A solver with further state appends to it.
  std::uint64_t state_size() const;
  void save(double* out) const;
  void load(const double* in);

  /// [m/s], in the layout of similitude_grid; u is interstitial, the superficial one on inlets.
  const std::vector<double>& face_velocity(std::size_t axis) const { return velocity_[axis]; }

 protected:
  struct Options {
    double density = 0;          // [kg/m^3]
    double tolerance = 1e-7;     // [-], of a cell's mass balance relative to the throughput
    int most_iterations = 100;   // of the pressure equation
  };

  /// `grid` stays valid. Throws std::invalid_argument if an inlet has no outlet.
  FaceFlow(const similitude_grid& grid, const Options& options);
  ~FaceFlow() = default;
  FaceFlow(FaceFlow&&) noexcept = default;

  /// Gas at rest at p = 0.
  void start(const similitude_gas_step& fields);
  /// Means of the two cells; 1 on inlets.
  void set_face_fractions(const double* gas_fraction, FaceFields& fraction) const;
  void set_flux(const FaceFields& fraction);
  void divergence_of(const FaceFields& field, std::vector<double>& out) const;
  /// gradient_ = grad p at active faces, patches of given pressure at theirs.
  void set_pressure_gradient(const double* pressure);

  struct Projected {
    int iterations = 0;
    double throughput = 0;   // [1/s], the most gas that crosses a cell, of its volume; what residuals are measured by
  };
  /// u -= mobility_ grad(p' - p), p = p', with div(coefficient_ grad(p' - p)) = div(fraction_ u) + d(eps)/dt; gradient_
  /// becomes that of the new pressure. Throws std::runtime_error with cause and advice if that does not converge.
  Projected project(const similitude_gas_step& step);

  /// Cell means of the velocity; what is immersed at an inlet meets the flux between its particles.
  void fill_velocity(const similitude_gas_step& step) const;
  /// eps u on faces, where the step asks for it: after fill_report(), whose mass balance it is.
  void fill_flux(const similitude_gas_step& step) const;
  /// Cell means of a force per volume over active faces, one-sided at walls, as the step's stress_force.
  void fill_stress(const FaceFields& force, const similitude_gas_step& step) const;
  /// Mass balance, Courant number and flow through patches. Throws std::runtime_error if a velocity is not finite.
  void fill_report(const similitude_gas_step& step, const Projected& projected, similitude_gas_report& report);

  Staggered mesh_;
  std::array<FaceTable, 3> tables_;
  FaceFields velocity_;      // [m/s]
  FaceFields flux_;          // [m/s], eps u
  FaceFields fraction_;      // [-], end of step
  FaceFields mobility_;      // [m^3 s/kg], velocity per pressure gradient, at active faces
  FaceFields coefficient_;   // [m^3 s/kg], of the pressure equation: fraction times mobility
  FaceFields gradient_;      // [Pa/m]
  std::vector<double> divergence_;   // cells

 private:
  template <class PatchValue>
  void set_gradient(const double* field, PatchValue&& patch_value);
  void refuse_inlets_without_outlet() const;
  void set_active_shares(std::size_t axis);
  double measure_throughput(const similitude_gas_step& step) const;
  [[noreturn]] void throw_not_converged(const SolveReport& solved) const;

  Options options_;
  MultigridCG pressure_equation_;
  std::array<std::vector<double>, 3> active_share_;   // [-], cells: one over the number of active faces along the axis
  std::vector<double> right_side_, increment_;        // cells
};

}  // namespace similitude::flow
