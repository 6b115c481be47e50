#pragma once
#include <cstdio>
#include <string>

namespace similitude {

/// "67.5 mm" of a length [m] to four digits: one that was scaled and scaled back shows no rounding (in_mm of alignment.h shows all).
inline std::string rounded_mm(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", length / 1e-3);
  return text;
}

}  // namespace similitude
