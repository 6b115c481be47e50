#pragma once
/// From the real bed to the simulated one and back. The ratios come from a scaling plugin; they are applied here, once.

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

/// The real bed as a scaling law or a model sees it.
similitude_bed describe(const RealScene& scene);
similitude_bed describe(const ModelScene& scene);

/// The bed to be simulated. Lengths, speeds, times, densities, model parameters: everything is scaled here and nowhere else.
ModelScene simulated_bed(const RealScene& real, const similitude_ratios& ratios);

/// How results map back: x/r, t/sqrt(r), v/sqrt(r), omega sqrt(r); pressure and force by bed weight.
ResultRatios result_ratios(const RealScene& real, const similitude_ratios& ratios);

}  // namespace similitude
