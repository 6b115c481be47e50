#include <similitude/drag_law.h>
#include <similitude/effect.h>

namespace {
using namespace similitude;

/// Rubinow and Keller's lift is that of slow flow; spheres at finite Reynolds numbers of the slip feel less.
/// Lun & Liu (1997), Int. J. Multiphase Flow 23, 575: 1 up to Re = 1, then 0.178 + 0.822 Re^-0.522.
template <class V>
V lun_liu_factor(const V& reynolds) {
  return select(reynolds > 1.0, 0.178 + 0.822 * pow(max(reynolds, V(1)), V(-0.522)), V(1));
}

/// Lift of a sphere that spins otherwise than its gas: F = pi/8 rho_f d^3 (curl u / 2 - w_p) x (u - v).
/// Rubinow & Keller (1961), J. Fluid Mech. 11, 447.
struct MagnusLift {
  enum class Correction { none, lun_liu };
  Correction correction;

  static void parameters(Parameters<MagnusLift>& p) {
    p.choice("correction", &MagnusLift::correction,
             {.choices = "none|lun_liu", .def = "lun_liu", .doc = "For finite Reynolds numbers of the slip; none is Rubinow and Keller's limit.",
              .reference = "Lun & Liu (1997), Int. J. Multiphase Flow 23, 575"});
  }

  unsigned reads() const { return SIMILITUDE_READS_ANGULAR_VELOCITY | SIMILITUDE_READS_GAS_VORTICITY; }

  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    const Vec3<V> slip = p.gas_velocity - p.velocity;
    const Vec3<V> spin = V(0.5) * p.gas_vorticity - p.angular_velocity;
    V factor = k_pi / 8 * p.gas_density * (p.diameter * p.diameter * p.diameter);
    if (correction == Correction::lun_liu) factor = factor * lun_liu_factor(V(p.gas_density * p.diameter * magnitude(slip) / p.gas_viscosity));
    return {.force = factor * cross(spin, slip)};
  }

  /// Lift over drag. Before a run the spin is known only between that of the gas and that of rolling at the fastest speed.
  Relevance relevance(const Evidence& e) const {
    constexpr double k_threshold = 0.1;
    Relevance r{.threshold = k_threshold,
                .group = "F_Magnus/F_drag",
                .source = "a tenth of the drag, within which drag laws agree; Rubinow & Keller (1961), Lun & Liu (1997)",
                .missing = "the spins, which only a run with this effect knows,"};
    const Bed& bed = e.bed;
    if (e.occurred) {
      const double slip = e.occurred->slip_speed.mean;
      r.value = lift_over_drag(bed, slip, e.occurred->angular_speed.mean);
      r.lowest = lift_over_drag(bed, slip, e.occurred->angular_speed.lowest);
      r.highest = lift_over_drag(bed, slip, e.occurred->angular_speed.highest);
      if (!std::isnan(r.value)) r.verdict = r.value > k_threshold ? Verdict::needed : Verdict::negligible;
      return r;
    }
    const double fall = std::sqrt(2 * bed.gravity * bed.bed_height);   // [m/s], through the bed's height
    const double speed = std::max(bed.largest_inlet_velocity, fall);
    r.lowest = lift_over_drag(bed, speed, bed.largest_shear_rate / 2);
    r.highest = lift_over_drag(bed, speed, 2 * speed / bed.particle_diameter);
    r.value = r.highest;
    if (r.highest <= k_threshold) r.verdict = Verdict::negligible;
    if (r.lowest > k_threshold) r.verdict = Verdict::needed, r.value = r.lowest;
    return r;
  }

 private:
  /// Of a sphere that slips at `speed` [m/s] and spins at `rate` [rad/s] in a gas that does not turn.
  double lift_over_drag(const Bed& bed, double speed, double rate) const {
    if (!(speed > 0) || rate == 0) return 0;
    const Particle<double> p{.dt = 0, .diameter = bed.drag_diameter, .mass = 0, .velocity = {0, 0, 0}, .gas_velocity = {speed, 0, 0},
                             .gas_fraction = 1, .gas_density = bed.gas_density, .gas_viscosity = bed.gas_viscosity,
                             .angular_velocity = {0, 0, rate}, .gas_vorticity = {0, 0, 0}, .gas_acceleration = {0, 0, 0}};
    const DragState<double> alone{.diameter = p.diameter, .gas_fraction = 1, .slip_speed = speed, .gas_density = p.gas_density,
                                  .gas_viscosity = p.gas_viscosity};
    return magnitude(particles(p).force) / (stokes_exchange(alone) * schiller_naumann_factor(particle_reynolds(alone)) * speed);
  }
};

}  // namespace

SIMILITUDE_EFFECT(MagnusLift, "magnus_lift", "1.0.0", "Lift of spinning particles", "Similitude authors",
                  "Rubinow & Keller (1961), J. Fluid Mech. 11, 447")
