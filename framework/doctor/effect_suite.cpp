#include "doctor/suites.h"

namespace similitude::doctor {

std::vector<Check> effect_suite() { return {}; }

}  // namespace similitude::doctor
