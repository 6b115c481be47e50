#include "creature.h"

constexpr similitude_tag spoilt() {
  similitude_tag tag = zoo::sound_tag();
  tag.magic[0] = 'X';
  return tag;
}
ZOO_TAG(spoilt())
ZOO_ENTRY(zoo::sound_model("wrong_magic"))
