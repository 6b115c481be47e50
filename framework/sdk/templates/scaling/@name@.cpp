#include "@name@.h"

SIMILITUDE_SCALING_LAW(@Type@, "@id@", "1.0.0", "Grains for n^3 particles each")
