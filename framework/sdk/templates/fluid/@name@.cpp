#include "@name@.h"

SIMILITUDE_FLUID_SOLVER(@Type@, "@id@", "1.0.0", "A uniform gas that nothing changes")
