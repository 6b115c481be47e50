#include "creature.h"

extern "C" void defined_nowhere(const void*, const similitude_drag_block*, similitude_status*);

namespace {
const similitude_drag_functions k_hollow{sizeof(similitude_drag_functions), 0, nullptr, defined_nowhere};
constexpr similitude_descriptor hollow() {
  similitude_descriptor model = zoo::sound_model("undefined_symbol");
  model.functions = &k_hollow;
  return model;
}
}  // namespace

ZOO_TAG(zoo::sound_tag())
ZOO_ENTRY(hollow())
