#pragma once
/// Parameters to try a model with, from what its table declares, and the bed it is tried in.

#include <similitude/abi.h>

#include <vector>

#include "scene/scene.h"

namespace similitude::doctor {

/// Alumina of 1 mm in air, in a bed of 150 x 20 mm with a jet: the bed of the reference tables.
RealScene trial_scene();
similitude_bed trial_bed();

/// One value per parameter: the default where there is one; else `position` (0 ... 1) of the way through the typical range,
/// or the hard range (by magnitude where it spans decades); else what fits the trial bed by how the parameter scales.
std::vector<similitude_value> trial_values(const similitude_descriptor& model, double position = 0.5);

/// The same, every number moved to `position` whether it has a default or not, as far as it has a range. Sets for several
/// material pairs.
std::vector<similitude_value> moved_values(const similitude_descriptor& model, double position);

}  // namespace similitude::doctor
