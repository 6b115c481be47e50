#include "output/csv.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>

#include "output/number.h"
#include "output/whole_file.h"
#include "scratch.h"

using namespace similitude;
using namespace similitude::test;
using testing::ElementsAre;

TEST(Csv, WritesNumbersThatReadBackAsTheSameDouble) {
  EXPECT_EQ(csv_number(0.1), "0.1");
  EXPECT_EQ(csv_number(1.0 / 3), "0.3333333333333333");
  for (const double value : {0.1 + 0.2, -1e-300, 1.7976931348623157e308, 2.0 / 3 * 1e-5})
    EXPECT_EQ(std::stod(csv_number(value)), value);
}

TEST(Csv, LeavesAFieldEmptyWhereAValueDoesNotExist) {
  EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_field("velocity [m/s]"), "velocity [m/s]");
  EXPECT_EQ(csv_field("a, \"b\""), "\"a, \"\"b\"\"\"");
}

TEST(Csv, CanBeReadWhileItGrows) {
  const ScratchFolder folder;
  CsvWriter csv(folder / "t.csv", {"time [s]", "p [Pa]"});
  EXPECT_THAT(lines_of(folder / "t.csv"), ElementsAre("time [s],p [Pa]"));
  csv.row({0, std::numeric_limits<double>::quiet_NaN()});
  csv.row({0.5, -3});
  EXPECT_THAT(lines_of(folder / "t.csv"), ElementsAre("time [s],p [Pa]", "0,", "0.5,-3"));
}

TEST(Csv, BeginsWithAnEmptyFieldWhereTheFirstValueDoesNotExist) {
  const ScratchFolder folder;
  CsvWriter csv(folder / "t.csv", {"a", "b"});
  csv.row({std::numeric_limits<double>::quiet_NaN(), 1});
  EXPECT_THAT(lines_of(folder / "t.csv"), ElementsAre("a,b", ",1"));
}

TEST(Csv, RefusesARowOfAnotherWidth) {
  const ScratchFolder folder;
  CsvWriter csv(folder / "t.csv", {"a", "b"});
  EXPECT_THROW(csv.row({1}), std::logic_error);
}

TEST(Csv, SaysThatTheDiskIsFull) {
  EXPECT_EQ(message_of<OutputError>([] { CsvWriter("/dev/full", {"a"}); }),
            "/dev/full: cannot be written: the disk is full.\n"
            "  Free space there or give another folder with -o. What was written before is whole.");
}

TEST(Csv, CutsOffARowThatFitsOnlyInPart) {
  const ScratchFolder folder;
  CsvWriter csv(folder / "t.csv", {"a", "b"});
  csv.row({1, 2});
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {12, before.rlim_max};  // header and row are 8 bytes
  ::setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(csv.row({0.123456, 0.123456}), OutputError);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text_of(folder / "t.csv"), "a,b\n1,2\n");
}

TEST(ReadableNumber, KeepsTheDigitsThatMatter) {
  EXPECT_EQ(readable(0.1), "0.1");
  EXPECT_EQ(readable(12345678.0, 3), "1.23e+07");
  EXPECT_EQ(readable(2.0 / 3), "0.6667");
}
