#include "particles/most.h"

#include <array>
#include <cstdio>
#include <string>

#include "scene/messages.h"

namespace similitude {
namespace {

[[noreturn]] void refuse(double count, const char* what, double most, const std::string& fix) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "these are %.3g %s, more than the %.3g that can be simulated.", count, what, most);
  throw InputError(text.data(), fix);
}

}  // namespace

void refuse_more_rows(std::size_t rows) {
  if (rows < k_most_rows) return;
  refuse(static_cast<double>(rows), "particles", static_cast<double>(k_most_rows),
         "Are the units right? Use a scaling law with fewer particles (`similitude scale`), e.g. parcel.");
}

void refuse_more_candidates(std::size_t candidates) {
  if (candidates <= k_most_candidates) return;
  refuse(static_cast<double>(candidates), "pairs of particles that may touch", static_cast<double>(k_most_candidates),
         "Use a scaling law with fewer particles (`similitude scale`), e.g. parcel, or a contact law or an effect of shorter reach.");
}

void refuse_more_places(double places) {
  if (places <= k_most_places) return;
  refuse(places, "places for contact lists", k_most_places,
         "Are the units right? Use a smaller domain for so small particles, or a scaling law with larger ones (`similitude scale`), e.g. parcel.");
}

}  // namespace similitude
