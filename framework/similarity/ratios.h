#pragma once
/// From the real bed to the simulated one and back. The ratios come from a scaling plugin; they are applied here, once.

#include <string>
#include <vector>

#include <similitude/abi.h>

#include "scene/scene.h"

namespace similitude {

/// Simulated / real of the quantities that results carry (maps a result back by division).
struct ResultRatios {
  double length = 1, time = 1, velocity = 1, angular_velocity = 1;
  double pressure = 1;    // by bed weight: (rho_p - rho_f)* r
  double force = 1;       // by particle weight: (rho_p - rho_f)* n^3 / parcel weight
  double mass = 1;        // of solids in the bed: rho_p* r^3
  double diameter = 1;    // n, of what touches. Results show d_sim / length (what touches) and d_sim / diameter (the material)
};

similitude_ratios identity_ratios();

/// The bed as a scaling law or a model sees it, by its first particle class or by the one that is asked for. The settled height
/// follows from the counts if the case gives none (plates taken as thin); count and height are 0 where they are unknown.
similitude_bed describe(const RealScene& scene, std::size_t species = 0);
similitude_bed describe(const ModelScene& scene);

/// The bed to be simulated. Lengths, speeds, times, densities, model parameters: everything is scaled here and nowhere else.
/// Throws InputError if a ratio is not positive, or if collisions would have to lose more energy than they have.
ModelScene simulated_bed(const RealScene& real, const similitude_ratios& ratios);

/// Part of a collision's energy lost, beyond which a law that changes it is near its limit: e below 0.32.
inline constexpr double k_energy_loss_near_limit = 0.9;

/// What is doubtful about these ratios in this bed, in words, as InputError's.
std::vector<std::string> scaling_warnings(const RealScene& real, const similitude_ratios& ratios);

/// How results map back: x/r, t/sqrt(r), v/sqrt(r), omega sqrt(r); pressure and force by bed weight (by the gas's dynamic
/// pressure in a bed without particles).
ResultRatios result_ratios(const RealScene& real, const similitude_ratios& ratios);

}  // namespace similitude
