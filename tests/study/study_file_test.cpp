#include "study/study_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "scene/messages.h"
#include "study/case_matrix.h"
#include "folder.h"

using namespace similitude;
using ::testing::ElementsAre;

namespace {

class StudyFileTest : public similitude::test::StudyFolder {
 protected:
  StudyFileTest() { write("case.yaml", "similitude: 1\n"); }

  StudyFile read(const std::string& text) {
    write("study.yaml", text);
    return read_study(folder / "study.yaml");
  }
  std::string refusal(const std::string& text) {
    return refusal_by([&] { read(text); });
  }
};

const std::string k_head = "similitude_study: 1\nbase: case.yaml\n";
const std::string k_tail = "reference: a\nmetrics: [bed_height]\n";

}  // namespace

TEST_F(StudyFileTest, AxesMakeEveryCombinationTheLastFastest) {
  const StudyFile study = read(
      k_head + "axes:\n  models.scaling: [exact, {id: link, n: 1.5}]\n  scene.domain.cell: [5 mm, 2.5 mm]\n" + k_tail);
  std::vector<std::string> names;
  for (const NamedCase& one : cases_of(study)) names.push_back(one.name);
  EXPECT_THAT(names, ElementsAre("exact-cell_5mm", "exact-cell_2.5mm", "link_n_1.5-cell_5mm", "link_n_1.5-cell_2.5mm"));
  const NamedCase last = cases_of(study).back();
  ASSERT_EQ(last.settings.size(), 2U);
  EXPECT_EQ(last.settings[0].assignment(), "models.scaling={id: link, n: 1.5}");
  EXPECT_EQ(last.settings[1].assignment(), "scene.domain.cell=2.5 mm");
}

TEST_F(StudyFileTest, NamesOfEmptyListsAndWordsCarryTheirKey) {
  const StudyFile study = read(k_head + "axes: {models.effects: [[], auto]}\n" + k_tail);
  EXPECT_EQ(cases_of(study)[0].name, "effects_none");
  EXPECT_EQ(cases_of(study)[1].name, "effects_auto");
}

TEST_F(StudyFileTest, NamedCasesKeepTheirNames) {
  const StudyFile study = read(k_head + "cases:\n  - {name: a}\n  - {name: b, set: {time.dt: 1 us}}\n" + k_tail);
  ASSERT_EQ(cases_of(study).size(), 2U);
  EXPECT_EQ(cases_of(study)[1].settings[0].written_at, "cases.1.set.time.dt");
}

TEST_F(StudyFileTest, UnknownKeyNamesTheNearest) {
  EXPECT_EQ(refusal(k_head + "axis: {}\n"),
            "study.yaml:3:1: axis: there is no such key.\n  Did you mean \"axes\"?\n  Keys of a study: "
            "similitude_study, title, base, set, axes, "
            "cases, reference, metrics, from, smoothing, repeats, short, leg, threads.");
}

TEST_F(StudyFileTest, CaseFileIsToldFromAStudy) {
  EXPECT_EQ(refusal("similitude: 1\n"),
            "study.yaml:1:1: similitude_study: this key is missing: it says for which version of the format a study is "
            "written.\n"
            "  This looks like a case file: similitude run runs it.");
}

TEST_F(StudyFileTest, UnknownMetricNamesTheNearest) {
  EXPECT_EQ(refusal(k_head + "cases: [{name: a}]\nreference: a\nmetrics: [bed_heigth]\n"),
            "study.yaml:5:11: metrics.0: there is no metric \"bed_heigth\".\n  Did you mean \"bed_height\"?\n  "
            "Metrics: velocity_profile, "
            "velocity_profile_maximum, gas_fraction_profile, gas_fraction_profile_maximum, pressure_drop, "
            "pressure_drop_fluctuation, bed_height, "
            "bed_height_fluctuation, dominant_frequency, last_pressure_drop, last_kinetic_energy, momentum_residual, energy_residual, gas_balance_residual.");
}

TEST_F(StudyFileTest, MissingBaseIsNamed) {
  EXPECT_EQ(
      refusal("similitude_study: 1\nbase: nowhere.yaml\n" + k_tail),
      "study.yaml:2:7: base: there is no case file nowhere.yaml.\n  A relative path starts at the study's folder.");
}

TEST_F(StudyFileTest, NeitherAxesNorCases) {
  EXPECT_EQ(refusal(k_head + k_tail),
            "study.yaml:1:1: there are no cases: neither axes nor cases is given.\n  Add for example axes: "
            "{models.drag: [gidaspow, di_felice]}.");
}

TEST_F(StudyFileTest, BothAxesAndCases) {
  EXPECT_EQ(
      refusal(k_head + "axes: {time.dt: [1 us]}\ncases: [{name: a}]\n" + k_tail),
      "study.yaml:4:8: cases: axes and cases are both given.\n  Keep one of the two; a case may set several values.");
}

TEST_F(StudyFileTest, AxisWithoutAList) {
  EXPECT_EQ(refusal(k_head + "axes: {models.drag: gidaspow}\n" + k_tail),
            "study.yaml:3:21: axes.models.drag: a list of values is needed, but this is \"gidaspow\".\n"
            "  Write for example axes: {models.drag: [gidaspow, di_felice]}.");
}

TEST_F(StudyFileTest, TwoCasesOfOneName) {
  EXPECT_EQ(refusal(k_head + "cases: [{name: a}, {name: a}]\n" + k_tail),
            "study.yaml:3:27: cases.1.name: a is the name of two cases.\n  Rename one of them.");
}

TEST_F(StudyFileTest, NameThatIsNoFolder) {
  EXPECT_EQ(refusal(k_head + "cases: [{name: ../a}]\n" + k_tail),
            "study.yaml:3:16: cases.0.name: \"../a\" cannot be the name of a folder of results.\n"
            "  Use letters, digits and . _ + -, and no dot in front.");
}

TEST_F(StudyFileTest, ReferenceThatSaysNothing) {
  EXPECT_EQ(refusal(k_head + "cases: [{name: a}]\nreference: [a]\nmetrics: [bed_height]\n"),
            "study.yaml:4:12: reference: a list says nothing to compare with.\n"
            "  Write the name of a case, {run: folder of a finished run} or {data: file of measured data}.");
}
