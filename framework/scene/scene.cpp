#include "scene/scene.h"

#include <algorithm>
#include <limits>

namespace similitude {

std::string face_name(Face face) {
  static const char* const names[3][2] = {{"left", "right"}, {"front", "back"}, {"bottom", "top"}};
  return names[static_cast<int>(face.axis)][static_cast<int>(face.side)];
}

char axis_name(Axis axis) { return "xyz"[static_cast<int>(axis)]; }

double value_of(const GivenValues& values, std::string_view name) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const GivenValue& given) { return given.name == name; });
  return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

}  // namespace similitude
