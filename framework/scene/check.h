#pragma once
/// What a case must satisfy beyond its keys: does the bed fit, do patches lie on their faces, can the scaling law mean this?

#include <string>
#include <vector>

#include "scene/document.h"
#include "scene/scene.h"

namespace similitude {

/// Solids fraction of a settled bed of equal spheres: poured loosely, typical, densest by shaking (Scott & Kilgour 1969,
/// J. Phys. D 2, 863: 0.60 and 0.637; with friction and near walls a poured bed is looser).
inline constexpr double k_loosest_packing = 0.50;
inline constexpr double k_densest_packing = 0.64;

/// Throws InputError at the first thing that cannot be; appends what is only doubtful to `warnings`. `document` gives places.
void check_case(const RealScene& scene, const Document& document, std::vector<std::string>& warnings);

}  // namespace similitude
