#include "stepper/version.h"

namespace similitude {

const char* program_version() { return SIMILITUDE_VERSION; }

}  // namespace similitude
