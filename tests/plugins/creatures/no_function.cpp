#include "creature.h"

namespace {
constexpr similitude_drag_functions k_empty{sizeof(similitude_drag_functions), 0, nullptr, nullptr};
constexpr similitude_descriptor idle() {
  similitude_descriptor model = zoo::sound_model("no_function");
  model.functions = &k_empty;
  return model;
}
}  // namespace

ZOO_TAG(zoo::sound_tag())
ZOO_ENTRY(idle())
