#include "@name@.h"

SIMILITUDE_EFFECT(@Type@, "@id@", "1.0.0", "Drag of rough spheres beside the drag law's")
