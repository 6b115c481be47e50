#include "@name@.h"

SIMILITUDE_CONTACT_LAW(@Type@, "@id@", "1.0.0", "Normal spring-dashpot")
