// Beds beyond what 32-bit numbers tell apart are refused, not mixed up.
#include "particles/most.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "particles/bricks.h"
#include "particles/contact_lists.h"
#include "scene/messages.h"

namespace similitude {
namespace {

template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MostParticles, LeaveTheBitFreeThatMarksASurface) {
  EXPECT_EQ(k_most_rows, ContactLists::k_surface_key);
  EXPECT_EQ(refusal([] { refuse_more_rows(k_most_rows - 1); }), "");
  EXPECT_EQ(refusal([] { refuse_more_rows(3'000'000'000); }),
            "these are 3e+09 particles, more than the 2.15e+09 that can be simulated.\n"
            "  Are the units right? Use a scaling law with fewer particles (`similitude scale`), e.g. parcel.");
}

TEST(MostCandidates, AreThoseThatHaveANumber) {
  EXPECT_EQ(k_most_candidates, std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(refusal([] { refuse_more_candidates(k_most_candidates); }), "");
  EXPECT_EQ(refusal([] { refuse_more_candidates(5'000'000'000); }),
            "these are 5e+09 pairs of particles that may touch, more than the 4.29e+09 that can be simulated.\n"
            "  Use a scaling law with fewer particles (`similitude scale`), e.g. parcel, or a contact law or an effect of shorter reach.");
}

// A kilometre in cells of a millimetre: nothing is allocated for them.
TEST(MostPlaces, AreToldBeforeTheyAreLaidOut) {
  Bricks bricks;
  EXPECT_EQ(refusal([&] { bricks.lay_out({1e3, 1e3, 1e3}, {}, 1e-3); }),
            "these are 6.51e+14 places for contact lists, more than the 4.29e+09 that can be simulated.\n"
            "  Are the units right? Use a smaller domain for so small particles, or a scaling law with larger ones (`similitude scale`), e.g. "
            "parcel.");
}

}  // namespace
}  // namespace similitude
