#pragma once
/// What this processor can run, and the state of its floating-point unit.

#include <cstdint>
#include <string>

namespace similitude {

/// The largest instruction set of the x86-64 ladder that this processor has: "x86-64", "x86-64-v2", "-v3" or "-v4".
/// On other processors what this program was built for.
std::string processor_instruction_set();

/// Whether a library built for `wanted` (a rung of that ladder) runs here. False for a name that is not on the ladder.
bool processor_has(const std::string& wanted);

/// Rounding, flush-to-zero and exception masks of the calling thread (MXCSR without its sticky flags). 0 where there is
/// none.
std::uint32_t floating_point_control();
void set_floating_point_control(std::uint32_t control);

}  // namespace similitude
