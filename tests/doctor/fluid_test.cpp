// Gas solvers with one illness each, and the line of the report that tells it.

#include "patient.h"

namespace similitude::doctor {
namespace {

TEST(DoctorOnFluidSolvers, FindsWhatIsWrong) {
  const Examination examination = examine(library("fluid_solvers"));
  EXPECT_EQ(failed_checks(examination, "fluid model plug"), std::vector<std::string>{});
  const Illness illnesses[] = {
      {"fluid model leaks", "mass balance", "0.00049 kg/s enter and 0.000441 kg/s leave a bed at rest.",
       "div(eps u) = -d(eps)/dt in every cell, and the report counts what crosses the patches."},
      {"fluid model stirs", "quiescent stays quiescent",
       "closed but for its outlet, over a bed at rest, the gas moves at 4.9e-06 m/s after 20 steps.",
       "The pressure is the full one minus rho g.x, so gravity drives nothing: look for a force that is there without a cause."},
      {"fluid model explicit_drag", "stiff drag", "with a drag a million times stiffer than its step the gas reaches 114 m/s.",
       "Take the drag implicitly, in the momentum predictor and in the pressure equation: 1/(1 + beta dt/(eps rho))."},
      {"fluid model forgets", "restart", "5 steps after a restart the fields differ from those of a run without one.",
       "What a step leaves for the next beyond velocity and pressure belongs in save_state()."},
      {"fluid model writes_beyond", "stays in its columns", "it writes beyond the end of the column pressure of 384 rows, at row 384.",
       "Rows run from 0 to block->rows - 1, which is a multiple of 8. The loops of the SDK's headers keep to that."},
  };
  for (const Illness& illness : illnesses) expect_illness(examination, illness);
}

}  // namespace
}  // namespace similitude::doctor
