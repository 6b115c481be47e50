// Effects with one illness each, and the line of the report that tells it.

#include "patient.h"

namespace similitude::doctor {
namespace {

TEST(DoctorOnEffects, FindsWhatIsWrong) {
  const Examination examination = examine(library("effects"));
  EXPECT_EQ(failed_checks(examination, "effect model wind"), std::vector<std::string>{}) << examination_text(examination);
  const Illness illnesses[] = {
      {"effect model eavesdrops", "declared is all",
       "in the particle pass what it adds to force[0] hangs on columns that it does not declare.",
       "What an effect reads beyond the usual stands in needs: similitude_effect_needs::reads, or reads() with the SDK."},
      {"effect model hidden_mass", "declared is all", "in the particle pass it adds to added_mass, which it does not declare.",
       "What an effect adds beyond a force stands in needs: similitude_effect_needs::adds, or adds() with the SDK."},
      {"effect model one_sided", "Newton's third law", "the force on the partners of a contact does not cancel.",
       "Swap i and j: normal and velocity change sign, radii, spins and values change places, and what is added must change sign."},
      {"effect model blows_along_x", "turned space", "in the particle pass the force does not turn with space.",
       "Build it from vectors as wholes: no axis of space is special."},
      {"effect model judges_backwards", "verdict", "it calls rho_f/rho_p = 0.00117788 against 0.1 needed.",
       "Needed is what lies above the threshold, or below it where needed_below is 1."},
      {"effect model judges_without_a_reason", "verdict", "it judges without saying by which group, or by whose threshold.",
       "Fill group and source: a user must be able to check the verdict."},
      {"effect model overwrites", "adds to what is there", "in the particle pass it overwrites force[0] instead of adding to it.",
       "Other effects add to the same columns: b->force[0][row] += ..."},
  };
  for (const Illness& illness : illnesses) expect_illness(examination, illness);
}

}  // namespace
}  // namespace similitude::doctor
