#pragma once

namespace similitude {

/// The program's version, "1.0.0".
const char* program_version();

}  // namespace similitude
