#include <similitude/contact_law.h>
#include <similitude/hertz.h>

namespace {
using HertzThornton = similitude::HertzLaw<false>;   // partners never attract each other
}

SIMILITUDE_CONTACT_LAW(HertzThornton, "hertz_thornton", "1.0.0", "Hertz spring-dashpot that never attracts, with Mindlin friction",
                       "Similitude authors", "Thornton, Cummins & Cleary (2013), Powder Technol. 233, 30")
