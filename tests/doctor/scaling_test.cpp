// Scaling laws with one illness each, and the line of the report that tells it.

#include "patient.h"

namespace similitude::doctor {
namespace {

TEST(DoctorOnScalingLaws, FindsWhatIsWrong) {
  const Examination examination = examine(library("scaling_laws"));
  EXPECT_EQ(failed_checks(examination, "scaling model small"), std::vector<std::string>{});
  const Illness illnesses[] = {
      {"scaling model negative", "ratios", "the ratio of gas_density is -90 with size = 100.",
       "Ratios are simulated over real, above zero; what a law does not touch stays 1."},
      {"scaling model never_the_same_bed", "identity", "with size = 1 the ratio of gas_viscosity is 1.5.",
       "A bed that is not scaled is the real bed: every ratio is 1."},
      {"scaling model wrong_clock", "audit",
       "time x velocity / length is 0.794328: the gas would cross the bed in another time than its clock says.",
       "Give time as length / velocity."},
      {"scaling model loses_volume", "audit",
       "the gas sees 0.794328 times the volume of particles that moves (parcel_weight drag_diameter^3 / diameter^3).",
       "A parcel of w particles has w times the volume of one: parcel_weight = (diameter / drag_diameter)^3."},
      {"scaling model fickle", "repeats itself",
       "asked twice for the same bed it gives energy_loss 1.0000000000000011 and 1.000000000000002.", "Keep nothing between calls."},
      {"scaling model has_no_bed", "ratios", "it reports an error: the bed is too shallow for me.",
       "A model takes whatever lies within its declared ranges, in an ordinary bed."},
  };
  for (const Illness& illness : illnesses) expect_illness(examination, illness);
}

}  // namespace
}  // namespace similitude::doctor
