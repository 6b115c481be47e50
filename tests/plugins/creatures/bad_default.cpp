#include "creature.h"

namespace {
constexpr similitude_parameter too_large() {
  similitude_parameter parameter = zoo::k_factor;
  parameter.default_value = 5;
  return parameter;
}
constexpr similitude_parameter k_too_large = too_large();
constexpr similitude_descriptor spoilt() {
  similitude_descriptor model = zoo::sound_model("bad_default");
  model.parameters = &k_too_large;
  return model;
}
}  // namespace

ZOO_TAG(zoo::sound_tag())
ZOO_ENTRY(spoilt())
