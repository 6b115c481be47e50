#include "creature.h"

constexpr similitude_tag spoilt() {
  similitude_tag tag = zoo::sound_tag();
  tag.abi_minor = 99;
  return tag;
}
ZOO_TAG(spoilt())
ZOO_ENTRY(zoo::sound_model("newer_minor"))
