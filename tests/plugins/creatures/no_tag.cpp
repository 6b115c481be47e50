#include "creature.h"

ZOO_ENTRY(zoo::sound_model("no_tag"))
