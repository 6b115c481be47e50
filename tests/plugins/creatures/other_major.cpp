#include "creature.h"

constexpr similitude_tag spoilt() {
  similitude_tag tag = zoo::sound_tag();
  tag.abi_major = 7;
  return tag;
}
ZOO_TAG(spoilt())
ZOO_ENTRY(zoo::sound_model("other_major"))
