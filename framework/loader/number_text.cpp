#include "loader/number_text.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace similitude {

std::string number_text(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

std::string two_digits(double value) {
  constexpr double k_most_without_exponent = 1e6;
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  if (const double rounded = std::strtod(text, nullptr); std::abs(rounded) >= 100 && std::abs(rounded) < k_most_without_exponent)
    std::snprintf(text, sizeof text, "%.0f", rounded);
  return text;
}

std::string range_text(double minimum, double maximum) {
  std::string text = "[";
  text += std::isinf(minimum) ? "..." : number_text(minimum);
  text += ", ";
  text += std::isinf(maximum) ? "..." : number_text(maximum);
  return text += "]";
}

}  // namespace similitude
