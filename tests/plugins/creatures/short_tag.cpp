#include "creature.h"

__attribute__((section(SIMILITUDE_TAG_SECTION), used)) static const char tag_of_a_dwarf[24] = SIMILITUDE_TAG_MAGIC;
ZOO_ENTRY(zoo::sound_model("short_tag"))
