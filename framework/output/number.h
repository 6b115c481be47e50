#pragma once
#include <string>

namespace similitude {

/// The fewest digits, at most 17, that read back as the same double.
std::string round_trip(double value);

/// `digits` significant digits for people, without trailing zeros: 0.1, 1.23e-05.
std::string readable(double value, int digits = 4);

}  // namespace similitude
