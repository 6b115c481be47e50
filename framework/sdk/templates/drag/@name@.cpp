#include "@name@.h"

SIMILITUDE_DRAG_LAW(@Type@, "@id@", "1.0.0", "Single-sphere drag times a power of the gas fraction")
