#include "bouncy.h"

SIMILITUDE_CONTACT_LAW(Bouncy, "org.example.bouncy", "1.0.0", "Normal spring-dashpot")
