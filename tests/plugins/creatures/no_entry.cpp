#include "creature.h"

ZOO_TAG(zoo::sound_tag())
