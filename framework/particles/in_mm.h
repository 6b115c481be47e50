#pragma once
#include <cstdio>
#include <string>

namespace similitude {

/// "67.5 mm" of a length [m], for messages.
inline std::string in_mm(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", length / 1e-3);
  return text;
}

}  // namespace similitude
