#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// A smaller bed of relatively larger particles in a denser gas: Froude, Reynolds and Archimedes numbers are kept, hence
/// u0/u_mf and u0/u_t under any drag law. Particle density and gas viscosity stay.
struct TerminalVelocity {
  double geometry;   // [-], r

  static void parameters(Parameters<TerminalVelocity>& p) {
    p.real("geometry", &TerminalVelocity::geometry,
           {.min = 0.001, .max = 1, .typical_min = 1.0 / 16, .typical_max = 1, .doc = "Simulated over real bed length."});
  }

  /// With u* = t* = sqrt(r) the Reynolds number asks rho_f* = 1 / (n sqrt(r)), and the Archimedes number then
  /// rho_p n^2 - (rho_f / sqrt(r)) n - sqrt(r) (rho_p - rho_f) = 0; n is close to r^(1/4).
  Ratios ratios(const Bed& real) const {
    require_heavy_particles(real, "terminal_velocity");
    const double root = std::sqrt(geometry);
    const double linear = real.gas_density / root;
    const double constant = root * (real.particle_density - real.gas_density);
    const double n = (linear + std::sqrt(linear * linear + 4 * real.particle_density * constant)) /
                     (2 * real.particle_density);
    Ratios r = froude_scaled(geometry, n);
    r.gas_density = 1 / (n * root);
    keep_softness(r);
    return r;
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(TerminalVelocity, "terminal_velocity", "1.0.0", "Smaller bed, relatively larger particles, same u0/u_t",
                       "Similitude authors",
                       "Banerjee & Agarwal, of a spouted bed of gamma-alumina (journal and year not known here); the same authors with glass "
                       "beads: Energy & Fuels (2016), doi 10.1021/acs.energyfuels.6b00855")
