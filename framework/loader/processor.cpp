#include "loader/processor.h"

#include <array>
#include <string_view>

#if defined(__x86_64__)
#include <xmmintrin.h>
#else
#include <similitude/plugin.h>
#endif

namespace similitude {

#if defined(__x86_64__)
namespace {

constexpr std::array<std::string_view, 4> k_ladder{"x86-64", "x86-64-v2", "x86-64-v3", "x86-64-v4"};
constexpr std::uint32_t k_sticky_flags = 0x3f;  // exceptions that have happened: any arithmetic sets them

/// The features that compilers use at each rung. Single features, because not every compiler knows the rungs by name.
int highest_rung() {
  const bool v2 = __builtin_cpu_supports("sse3") && __builtin_cpu_supports("ssse3") &&
                  __builtin_cpu_supports("sse4.1") && __builtin_cpu_supports("sse4.2") &&
                  __builtin_cpu_supports("popcnt");
  const bool v3 = v2 && __builtin_cpu_supports("avx") && __builtin_cpu_supports("avx2") &&
                  __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  return v4 ? 3 : v3 ? 2 : v2 ? 1 : 0;
}

}  // namespace

std::string processor_instruction_set() { return std::string(k_ladder[static_cast<std::size_t>(highest_rung())]); }

bool processor_has(const std::string& wanted) {
  for (std::size_t rung = 0; rung <= static_cast<std::size_t>(highest_rung()); ++rung)
    if (k_ladder[rung] == wanted) return true;
  return false;
}

std::uint32_t floating_point_control() { return _mm_getcsr() & ~k_sticky_flags; }

void set_floating_point_control(std::uint32_t control) { _mm_setcsr((_mm_getcsr() & k_sticky_flags) | control); }

#else

std::string processor_instruction_set() { return instruction_set(); }  // the one this program was built for
bool processor_has(const std::string& wanted) { return wanted == instruction_set(); }
std::uint32_t floating_point_control() { return 0; }
void set_floating_point_control(std::uint32_t) {}

#endif

}  // namespace similitude
