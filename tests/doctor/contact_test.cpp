// Contact laws with one illness each, and the line of the report that tells it.

#include "patient.h"

namespace similitude::doctor {
namespace {

const std::string k_damping = "Take the damping from the restitution and the pair's effective mass: similitude::damping_ratio() in restitution.h.";
const std::string k_duration = "contact_time is the duration of a head-on impact; leave it out, and the SDK plays one.";
const std::string k_stable =
    "In a packed bed a linear spring-dashpot's limit is (sqrt(1 + 4 zeta^2) - 2 zeta)/w0: similitude::stable_step_in_a_bed() in restitution.h.";

TEST(DoctorOnContactLaws, FindsWhatIsWrong) {
  const Examination examination = examine(library("contact_laws"));
  EXPECT_EQ(failed_checks(examination, "contact model spring"), std::vector<std::string>{});
  const Illness illnesses[] = {
      {"contact model biased", "Newton's third law",
       "the partners feel (-0.0008714, -0.001201, 0.00132) N and (0.0008715, 0.001201, -0.00132) N, which do not cancel.",
       "Swap i and j: normal and velocity change sign, radii and spins change places, and the force must change sign."},
      {"contact model loves_the_x_axis", "turned space",
       "in turned space the force is (0.001853, -0.003227, 0.002748), and must be (0.001828, -0.003184, 0.002711).",
       "Build force and memory from vectors as wholes: no axis of space is special to a contact.", {"restitution"}},
      {"contact model pulls", "pushes apart",
       "two spheres at rest that overlap by a twentieth of a diameter feel -0.025 N along the normal.",
       "The normal points from j to i: the force on i is along +normal where it pushes the partners apart."},
      {"contact model drives", "no energy gained", "an impact at 0.5 m/s and 0 degrees of two spheres ends with 1.185 times its energy.",
       "Damping must act against the motion, in the normal and in the tangential direction, and friction against the slip.",
       {"largest stable step"}},
      {"contact model half_damped", "restitution", "a head-on impact at 0.5 m/s with a restitution of 0.5 rebounds with 0.7115.", k_damping},
      {"contact model wrong_parity", "parity of its memory",
       "spring_x is declared even, and is -5.29061e-07 where the swapped contact has 5.29061e-07.",
       "Odd: vectors of i relative to j, which change sign when the partners swap. Even: everything else."},
      {"contact model hurried", "contact time", "it tells 5.145e-05 s for an impact at 0.05 m/s, which lasts 7.347e-05 s.", k_duration},
      {"contact model reckless", "largest stable step",
       "at 0.95 of the step it calls stable, 5.22e-05 s, a pressed contact swings ever wider: 23.4 times after 3 steps.", k_stable},
      {"contact model afraid_of_walls", "finite", "the force is not finite at an overlap of 0 m and a velocity of (0, 0, 0) m/s, on a wall.",
       "Keep zero overlap, zero velocity and infinite radii (a flat wall) out of denominators and roots."},
      {"contact model throws_when_asked_for_time", "set-up functions",
       "contact_time is nan s for an effective mass of 2.72e-07 kg, a radius of 0.00025 m and a speed of 10 m/s.",
       "It is a duration: above zero, or infinite where partners never part.", {"contact time"}},
  };
  for (const Illness& illness : illnesses) expect_illness(examination, illness);
}

}  // namespace
}  // namespace similitude::doctor
