#include "creature.h"

ZOO_TAG(zoo::sound_tag())
ZOO_ENTRY(zoo::sound_model("sound"))
