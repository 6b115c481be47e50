#pragma once
/// Gas without inertia and viscosity in the bed as a porous medium whose resistance is the drag law's own:
///
///   d(eps)/dt + div(eps u) = 0
///   0 = -eps grad p - E u + (E v) + R
///
/// with E, (E v) and R from the particles (similitude_gas_step) and p without its hydrostatic part. One elliptic equation
/// for p a step, with the coefficient eps^2/E. Where fewer particles are than make a thousandth of the bed's own resistance
/// (GasOptions::free_resistance), that takes the place of E.
///
/// E comes from the velocity of the last step. With drag that grows as the square of the slip, u = G/E(u_old) swings about
/// its goal with a factor of up to -1; the geometric mean of this and the last step's E makes that factor 0 ... 1/2:
/// with E ~ u^n, ln u falls short of its goal by (1 - n)/2 of what it fell short before. (E v) shrinks or grows with E, so
/// that gas in a bed that moves as a whole moves with it.

#include "fluid/face_flow.h"

namespace similitude::porous {

struct GasOptions {
  double density = 0;               // [kg/m^3], of the masses that are reported: nothing in the flow depends on it
  double free_resistance = 1e-3;    // [-], of the bed's own
  double tolerance = 1e-6;          // [-], of a cell's mass balance relative to the throughput
  int most_iterations = 100;
};

class PorousSolver : public flow::FaceFlow {
 public:
  /// `grid` stays valid. Throws std::invalid_argument if an inlet has no outlet.
  PorousSolver(const similitude_grid& grid, const GasOptions& options);

  /// Gas at rest at p = 0. Fills the step's fields.
  void start(const similitude_gas_step& fields);
  /// Throws std::runtime_error with cause and advice if the pressure equation does not converge or a velocity is not finite.
  void advance(const similitude_gas_step& step, similitude_gas_report& report);

  /// The resistances on faces: velocities follow from them and the pressure.
  std::uint64_t state_size() const { return FaceFlow::state_size(); }
  void save(double* out) const;
  void load(const double* in);

  /// [kg/(m^3 s)], in the layout of similitude_grid: what resisted the flow in the last step, at active faces.
  const std::vector<double>& face_resistance(std::size_t axis) const { return resistance_[axis]; }

 private:
  double least_resistance(const similitude_gas_step& step) const;
  void predict(const similitude_gas_step& step);
  void fill_stress(const similitude_gas_step& step);

  GasOptions options_;
  flow::FaceFields damped_;       // [kg/(m^3 s)], E as damped, 0 where no particles have been
  flow::FaceFields resistance_;   // [kg/(m^3 s)], the larger of that and the least
};

}  // namespace similitude::porous
