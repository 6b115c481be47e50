#include <similitude/contact_law.h>
#include <similitude/hertz.h>

namespace {
using HertzMindlin = similitude::HertzLaw<true>;   // the dashpot may pull before the partners part
}

SIMILITUDE_CONTACT_LAW(HertzMindlin, "hertz_mindlin", "1.0.0", "Hertz spring-dashpot with Mindlin friction", "Similitude authors",
                       "Tsuji, Tanaka & Ishida (1992), Powder Technol. 71, 239")
