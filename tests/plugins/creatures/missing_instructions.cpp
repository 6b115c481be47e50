#include "creature.h"

constexpr similitude_tag spoilt() {
  similitude_tag tag = zoo::sound_tag();
  for (int k = 0; k < 9; ++k) tag.instruction_set[k] = "x86-64-v9"[k];  // no processor has it
  return tag;
}
ZOO_TAG(spoilt())
ZOO_ENTRY(zoo::sound_model("missing_instructions"))
