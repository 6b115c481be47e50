#include <similitude/drag_law.h>
#include <similitude/effect.h>

namespace {
using namespace similitude;

constexpr double k_saffman = 1.615;   // [-], 6.46 / 4. Saffman (1965), J. Fluid Mech. 22, 385; corrected 31 (1968), 624

/// What finite slip makes of Saffman's lift. Mei (1992), Int. J. Multiphase Flow 18, 145: Re = rho_f d |u - v| / mu and
/// beta Re = rho_f d^2 |curl u| / (2 mu).
template <class V>
V mei_factor(const V& slip_reynolds, const V& half_shear_reynolds) {
  const V root = sqrt(half_shear_reynolds / max(slip_reynolds, V(1e-300)));   // sqrt(beta)
  const V slow = (1.0 - 0.3314 * root) * exp(-0.1 * slip_reynolds) + 0.3314 * root;
  return select(slip_reynolds > 40.0, 0.0524 * sqrt(half_shear_reynolds), slow);
}

/// Lift of a sphere that slips through a shear. The component of the vorticity across the slip counts.
struct SaffmanLift {
  enum class Correction { none, mei };
  Correction correction;

  static void parameters(Parameters<SaffmanLift>& p) {
    p.choice("correction", &SaffmanLift::correction,
             {.choices = "none|mei", .def = "mei", .doc = "For finite Reynolds numbers of the slip; none is Saffman's limit.",
              .reference = "Mei (1992), Int. J. Multiphase Flow 18, 145"});
  }

  unsigned reads() const { return SIMILITUDE_READS_GAS_VORTICITY; }

  /// 1.615 d^2 sqrt(mu rho_f / |w|) (u - v) x w, w = curl u.
  template <class V>
  Addition<V> particles(const Particle<V>& p) const {
    const Vec3<V> slip = p.gas_velocity - p.velocity;
    const V turning = magnitude(p.gas_vorticity);
    const V per_mu = p.gas_density * p.diameter / p.gas_viscosity;
    const V slip_reynolds = per_mu * magnitude(slip), shear_reynolds = per_mu * p.diameter * turning;
    V factor = k_saffman * (p.diameter * p.diameter) * sqrt(p.gas_viscosity * p.gas_density / turning);
    if (correction == Correction::mei) factor = factor * mei_factor(slip_reynolds, V(0.5 * shear_reynolds));
    return {.force = select(turning > 0.0, factor, V(0)) * cross(slip, p.gas_vorticity)};
  }

  /// Lift over drag of a sphere at rest in the steepest shear of the scene, or of what the run saw.
  Relevance relevance(const Evidence& e) const {
    constexpr double k_threshold = 0.1;
    const double slip = e.occurred ? e.occurred->slip_speed.mean : e.bed.largest_inlet_velocity;
    const double shear = e.occurred ? e.occurred->vorticity.mean : e.bed.largest_shear_rate;
    const double steepest = e.occurred ? e.occurred->vorticity.highest : shear;
    const double value = lift_over_drag(e.bed, slip, shear), highest = lift_over_drag(e.bed, slip, steepest);
    return {.verdict = value > k_threshold ? Verdict::needed : Verdict::negligible,
            .value = value,
            .threshold = k_threshold,
            .group = "F_Saffman/F_drag",
            .source = "a tenth of the drag, within which drag laws agree; shear Reynolds number of Mei (1992)",
            .lowest = value,
            .highest = highest};
  }

 private:
  /// Of a sphere that slips at `speed` [m/s] along a shear of `rate` [1/s].
  double lift_over_drag(const Bed& bed, double speed, double rate) const {
    if (!(speed > 0) || !(rate > 0)) return 0;
    const Particle<double> p{.dt = 0, .diameter = bed.drag_diameter, .mass = 0, .velocity = {0, 0, 0}, .gas_velocity = {speed, 0, 0},
                             .gas_fraction = 1, .gas_density = bed.gas_density, .gas_viscosity = bed.gas_viscosity,
                             .angular_velocity = {0, 0, 0}, .gas_vorticity = {0, 0, rate}, .gas_acceleration = {0, 0, 0}};
    const DragState<double> alone{.diameter = p.diameter, .gas_fraction = 1, .slip_speed = speed, .gas_density = p.gas_density,
                                  .gas_viscosity = p.gas_viscosity};
    return magnitude(particles(p).force) / (stokes_exchange(alone) * schiller_naumann_factor(particle_reynolds(alone)) * speed);
  }
};

}  // namespace

SIMILITUDE_EFFECT(SaffmanLift, "saffman_lift", "1.0.0", "Lift of particles in a sheared gas", "Similitude authors",
                  "Saffman (1965), J. Fluid Mech. 22, 385")
