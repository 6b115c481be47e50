// Drag laws with one illness each, and the line of the report that tells it.

#include "patient.h"

namespace similitude::doctor {
namespace {

const std::string k_denominators =
    "Write the law as Stokes' drag times a factor, 3 pi mu d f(Re, eps), and keep Re = 0 and eps = 1 out of denominators.";
const std::string k_rows = "Rows run from 0 to block->rows - 1, which is a multiple of 8. The loops of the SDK's headers keep to that.";
const std::string k_boundary =
    "No exception may cross the boundary: catch it in the plugin and fill the status, or use the SDK's macros, which do both.";
const std::string k_own_tables = "Give the parameters defaults, or typical ranges, that go together in an ordinary bed.";

TEST(DoctorOnDragLaws, FindsWhatIsWrongWithALawOfTheSdk) {
  const Examination examination = examine(library("drag_laws"));
  EXPECT_EQ(failed_checks(examination, ""), std::vector<std::string>{});
  EXPECT_EQ(failed_checks(examination, "drag model healthy"), std::vector<std::string>{});
  const Illness illnesses[] = {
      {"drag model not_a_number_when_fast", "finite and positive", "K is nan kg/s at gas fraction 0.2, Re 999.", k_denominators},
      {"drag model accelerates", "finite and positive", "K is -1.68704e-07 kg/s at gas fraction 0.2, Re 0.",
       "Drag brakes: K multiplies u - v and is above zero wherever something moves or has neighbours."},
      {"drag model returns_beta", "limits", "K of a single sphere at rest is 1.91e+09 times Stokes' drag, 3 pi mu d.",
       "Return K [kg/s] of one particle, (beta/phi) V_p in terms of the usual beta [kg/(m^3 s)].", {"similar beds"}},
      {"drag model steps_at_the_empty_gas", "limits",
       "K steps from 3.37407e-07 to 1.68704e-07 kg/s where the gas becomes empty, at Re 0.",
       "Let the law of the dense bed tend to that of a single sphere at gas fraction 1."},
      {"drag model weaker_when_faster", "grows with the slip",
       "the drag force falls from 1.23256e-09 to 1.23224e-09 N while the gas gets faster, at gas fraction 0.35, Re 1.02343.",
       "Look at where two correlations meet: the join must not step down."},
      {"drag model hides_a_millimetre", "similar beds",
       "in an exactly similar bed a quarter of the size K is 0.625 of what it must be, at gas fraction 0.42, Re 30.",
       "Somewhere a number with a unit stands in the formula: make it a parameter that says how it scales."},
      {"drag model complains", "stays in its columns", "it reports an error: gas fractions below 0.3 are too dense for me.",
       "A model takes whatever lies within its declared ranges, in an ordinary bed.", {"finite and positive"}},
      {"drag model ends_the_program", "grows with the slip", "it ends the whole program: exit(7).",
       "Say what is wrong in the status instead; C++ authors throw."},
      {"drag model refuses_itself", "made", "it refuses the values that its own table suggests: nothing pleases me.\n  Give up.",
       k_own_tables},
      {"drag model odd_unit", "units", "the unit \"furlong\" of the parameter length is unknown.",
       "Write SI units as in a case file: \"N/m\", \"kg/(m^2 s)\"; \"1\" for a pure number."},
  };
  for (const Illness& illness : illnesses) expect_illness(examination, illness);
  EXPECT_EQ(outcome(examination, "drag model accelerates", "limits").seen, "\"finite and positive\" failed");
  EXPECT_EQ(outcome(examination, "drag model accelerates", "limits").verdict, Verdict::skipped);
  EXPECT_EQ(outcome(examination, "drag model complains", "finite and positive").seen, "as in \"stays in its columns\"");
}

// Asked of the one line alone: on a busy machine the others may take as long.
TEST(DoctorOnDragLaws, EndsACheckThatDoesNotEnd) {
  constexpr double limit = 3;   // [s]
  const Outcome told = outcome(examine(library("drag_never_ends"), limit), "drag model never_ends", "grows with the slip");
  EXPECT_EQ(told.seen, "it does not come to an end: stopped after 3 s.");
  EXPECT_EQ(told.advice, "Look for a loop whose end depends on what it computes.");
}

TEST(DoctorOnDragLaws, FindsWhatIsWrongWithALawAgainstTheBareBoundary) {
  const Examination examination = examine(library("drag_tables"));
  const std::vector<std::string> first_two = {"finite and positive"};
  const Illness illnesses[] = {
      {"drag model writes_beyond", "stays in its columns", "it writes beyond the end of the column exchange of 8 rows, at row 8.", k_rows},
      {"drag model reads_before", "stays in its columns", "it reads before the start of the column gas_fraction of 8 rows, at row -1.",
       k_rows},
      {"drag model writes_into_its_input", "stays in its columns", "it writes into the column slip_speed, which it is given to read.",
       "Write only to the columns that abi.h calls out."},
      {"drag model leaves_rows_out", "block split",
       "K is 1.6870352548400002e-07 kg/s in one block and nan in another, at gas fraction 0.35, Re 0.001.",
       "A row's answer may depend on that row alone, not on its place or its neighbours."},
      {"drag model uses_what_it_did_not_ask_for", "stays in its columns", "it crashes: it touches memory that is not its own.",
       "Run the check under a debugger: gdb --args similitude plugins doctor FILE, with set follow-fork-mode child.", first_two},
      {"drag model looks_at_its_neighbour", "block split",
       "K is 2.6149046450020004e-07 kg/s in one block and 2.0244423058080003e-07 in another, at gas fraction 0.55, Re 0.001.",
       "A row's answer may depend on that row alone, not on its place or its neighbours."},
      {"drag model lets_an_exception_out", "stays in its columns", "an exception leaves it: ouch", k_boundary, first_two},
      {"drag model gives_up", "stays in its columns", "it gives up: abort() was called.",
       "Look for a failed assertion, or an exception that leaves a function declared noexcept.", first_two},
      {"drag model throws_in_create", "made", "an exception leaves it: no bed is good enough", k_boundary},
      {"drag model refuses_without_a_word", "parameter ranges", "it refuses without a word with factor = 1.",
       "Fill status->text, and narrow the declared range to what the model takes."},
  };
  for (const Illness& illness : illnesses) expect_illness(examination, illness);
  // How many answers differ is the scheduler's.
  EXPECT_EQ(failed_checks(examination, "drag model keeps_notes"), std::vector<std::string>{"threads"});
  EXPECT_THAT(outcome(examination, "drag model keeps_notes", "threads").seen,
              testing::MatchesRegex("[0-9]+ of 235200 answers differ when 4 threads ask at once."));
}

}  // namespace
}  // namespace similitude::doctor
