#pragma once
#include <string>

namespace similitude {

/// The shortest text that reads back as the same number: "0.1", "500000", "1e-12".
std::string number_text(double value);

/// Two digits that count, without an exponent from 1e-4 to a million: "0.0012", "3.4", "170", "32000".
std::string two_digits(double value);

/// "[0, 1]", with "..." where it is open: "[0, ...]".
std::string range_text(double minimum, double maximum);

}  // namespace similitude
