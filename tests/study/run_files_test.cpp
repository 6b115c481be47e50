#include "study/run_files.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <fstream>

#include "scene/messages.h"
#include "output/csv_table.h"
#include "study/metrics.h"
#include "folder.h"

using namespace similitude;

namespace {

class RunFiles : public similitude::test::StudyFolder {
 protected:
  std::string refusal_of_data(const std::string& text) {
    write("data.csv", text);
    return refusal_by([&] { read_measured(folder / "data.csv"); });
  }
};

}  // namespace

TEST_F(RunFiles, TableKeepsQuotedCommasAndEmptyFields) {
  write("t.csv", "name,\"a, b\"\r\n\"he said \"\"no\"\"\",\r\nx,2.5\r\n");
  const CsvTable table(folder / "t.csv");
  EXPECT_EQ(table.texts("name")[0], "he said \"no\"");
  EXPECT_TRUE(std::isnan(table.numbers("a, b")[0]));
  EXPECT_EQ(table.numbers("a, b")[1], 2.5);
}

TEST_F(RunFiles, MeasuredDataGiveProfilesAndSingleNumbers) {
  write("data.csv",
        "sampler,x,z,mean,standard error\nvertical_velocity [m/s],0.01,0.05,0.3,0.02\npressure_drop,,,250,10\n");
  const Observations data = read_measured(folder / "data.csv");
  const Profile* profile = data.profile("vertical_velocity [m/s]");
  ASSERT_NE(profile, nullptr);
  EXPECT_TRUE(profile->measured);
  EXPECT_EQ(profile->bins[0].standard_error, 0.02);
  EXPECT_NEAR(data.given.at("pressure_drop").half_width(), 19.6, 0.01);  // 1.96 standard errors
}

TEST_F(RunFiles, MeasuredDataWithWrongColumns) {
  EXPECT_EQ(refusal_of_data("x,velocity\n0.1,2\n"),
            "data.csv: measured data need the columns sampler, x, z, mean and, if known, standard error, but these are "
            "x, velocity.\n"
            "  Name them in the first row. x and z in metres; sampler as in profiles.csv of a run, e.g. "
            "vertical_velocity [m/s].");
}

TEST_F(RunFiles, MeasuredDataOfSomethingUnknown) {
  EXPECT_EQ(refusal_of_data("sampler,x,z,mean\nvertical_velocty [m/s],0.1,0.1,2\n"),
            "data.csv:2: there is nothing called \"vertical_velocty [m/s]\" to compare with.\n  Did you mean "
            "\"vertical_velocity [m/s]\"?\n"
            "  Known: vertical_velocity [m/s], gas_fraction [1], pressure_drop, pressure_drop_fluctuation, bed_height, "
            "bed_height_fluctuation, "
            "dominant_frequency, last_pressure_drop, last_kinetic_energy.");
}

TEST_F(RunFiles, MeasuredDataThatAreNoNumber) {
  EXPECT_EQ(refusal_of_data("sampler,x,z,mean\nbed_height,,,tall\n"),
            "data.csv:2: \"tall\" in column mean is no number.");
  EXPECT_EQ(refusal_of_data("sampler,x,z,mean\nbed_height,,2\n"),
            "data.csv:2: this row has 3 fields, but there are 4 columns.");
  EXPECT_EQ(refusal_of_data("sampler,x,z,mean\nvertical_velocity [m/s],,0.1,2\n"),
            "data.csv:2: a point of a profile needs x and z.\n  Both in metres.");
}

TEST_F(RunFiles, MetricsAreTakenAfterStartUp) {
  std::string rows = "time [s],pressure_drop [Pa],momentum_residual [1]\n";
  for (int k = 0; k < 100; ++k)
    rows += std::to_string(0.01 * k) + "," + (k < 50 ? "1000" : k % 2 == 0 ? "201" : "199") + ",-1e-13\n";
  write("monitors.csv", rows);
  const Observations seen = read_observations(folder, 0.5);
  const MetricResult drop = measure(*find_metric("pressure_drop"), seen, nullptr);
  EXPECT_NEAR(drop.value.value, 200, 1e-9);
  EXPECT_EQ(drop.error.gap, "there is no reference to compare with");
  EXPECT_NEAR(measure(*find_metric("pressure_drop_fluctuation"), seen, nullptr).value.value, 1, 0.02);
  // Residuals are judged over the whole run, by magnitude, and need no reference.
  EXPECT_EQ(measure(*find_metric("momentum_residual"), seen, nullptr).error.value, 1e-13);
  EXPECT_EQ(measure(*find_metric("bed_height"), seen, &seen).error.gap, "this run has no bed_height [m]");
}

TEST_F(RunFiles, RelativeErrorAddsBothIntervals) {
  Observations seen, reference;
  seen.given["bed_height"] = exactly(0.11);
  seen.given["bed_height"].low = 0.107, seen.given["bed_height"].high = 0.113;
  reference.given["bed_height"] = exactly(0.1);
  reference.given["bed_height"].low = 0.096, reference.given["bed_height"].high = 0.104;
  const Estimate error = measure(*find_metric("bed_height"), seen, &reference).error;
  EXPECT_NEAR(error.value, 0.1, 1e-12);
  EXPECT_NEAR(error.high, 0.15, 1e-12);  // hypot(0.003, 0.004) / 0.1
  EXPECT_NEAR(error.low, 0.05, 1e-12);
}
