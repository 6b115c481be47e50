#pragma once
#include <string>

#include "scene/scene.h"

namespace similitude {

/// The case with every default filled in, as JSON text: the real bed in SI units, which the names carry.
std::string resolved_case_json(const RealScene& real);

}  // namespace similitude
