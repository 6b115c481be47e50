#include "scene/scene.h"

namespace similitude {

std::string face_name(Face face) {
  static const char* const names[3][2] = {{"left", "right"}, {"front", "back"}, {"bottom", "top"}};
  return names[static_cast<int>(face.axis)][static_cast<int>(face.side)];
}

char axis_name(Axis axis) { return "xyz"[static_cast<int>(axis)]; }

}  // namespace similitude
