#include "loader/number_text.h"

#include <charconv>
#include <cmath>

namespace similitude {

std::string number_text(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

std::string range_text(double minimum, double maximum) {
  std::string text = "[";
  text += std::isinf(minimum) ? "..." : number_text(minimum);
  text += ", ";
  text += std::isinf(maximum) ? "..." : number_text(maximum);
  return text += "]";
}

}  // namespace similitude
