#include "patient.h"
