#include <gtest/gtest.h>

#include <cmath>

#include "loader/number_text.h"
#include "scene/units.h"

namespace similitude {
namespace {

// Bits are compared: the literal on the right is the correctly rounded SI value.
TEST(Units, ReadWhatPeopleWrite) {
  EXPECT_EQ(parse_quantity("5 mm", "m"), 0.005);
  EXPECT_EQ(parse_quantity("1.79e-5 Pa s", "Pa s"), 1.79e-5);
  EXPECT_EQ(parse_quantity("1.79e-5 Pa*s", "Pa s"), 1.79e-5);
  EXPECT_EQ(parse_quantity("1.79e-5 kg/(m s)", "Pa s"), 1.79e-5);
  EXPECT_EQ(parse_quantity("1.79e-5 kg/m/s", "Pa s"), 1.79e-5);
  EXPECT_EQ(parse_quantity("0.0179 mPa s", "Pa s"), 1.79e-5);
  EXPECT_EQ(parse_quantity("13.2 m/s", "m/s"), 13.2);
  EXPECT_EQ(parse_quantity("1040 kg/m^3", "kg/m^3"), 1040.0);
  EXPECT_EQ(parse_quantity("1040 kg m^-3", "kg/m^3"), 1040.0);
  EXPECT_EQ(parse_quantity("1040 kg/m³", "kg/m^3"), 1040.0);
  EXPECT_EQ(parse_quantity("1.04 g/cm^3", "kg/m^3"), 1040.0);
  EXPECT_EQ(parse_quantity("10 1/s", "1/s"), 10.0);
  EXPECT_EQ(parse_quantity("10 Hz", "1/s"), 10.0);
  EXPECT_EQ(parse_quantity("500 N/m", "N/m"), 500.0);
  EXPECT_EQ(parse_quantity("500 kg/s^2", "N/m"), 500.0);
  EXPECT_EQ(parse_quantity("2 GPa", "Pa"), 2e9);
  EXPECT_EQ(parse_quantity("1.5 bar", "Pa"), 1.5e5);
  EXPECT_EQ(parse_quantity("80 µm", "m"), 80e-6);
  EXPECT_EQ(parse_quantity("80 um", "m"), 80e-6);
  EXPECT_EQ(parse_quantity("80um", "m"), 80e-6);
  EXPECT_EQ(parse_quantity("2 min", "s"), 120.0);
  EXPECT_EQ(parse_quantity("-9.81 m/s^2", "m/s^2"), -9.81);
  EXPECT_EQ(parse_quantity("+.5", "1"), 0.5);
  EXPECT_EQ(parse_quantity("20 %", "1"), 0.2);
  EXPECT_EQ(parse_quantity("0 Pa", "Pa"), 0.0);
  EXPECT_EQ(parse_quantity("300 K", "K"), 300.0);
  EXPECT_EQ(parse_quantity("1.007 kJ/(kg K)", "J/(kg K)"), 1007.0);
  EXPECT_EQ(parse_quantity("26.3 mW/(m K)", "W/(m K)"), 0.0263);
}

// A scaled run repeats the real one's bits only if the same length is the same double however it is written.
TEST(Units, PrefixesMakeNoDifferenceToTheBits) {
  for (int i = 1; i < 2000; ++i) {
    const std::string digits = std::to_string(i);
    const double metres = parse_quantity("0.00" + std::string(4 - digits.size(), '0') + digits + " m", "m");
    EXPECT_EQ(parse_quantity(digits + " um", "m"), metres);
    EXPECT_EQ(parse_quantity(digits + "e-3 mm", "m"), metres);
    EXPECT_EQ(parse_quantity(digits + "e-4 cm", "m"), metres);
  }
}

TEST(Units, DegreesAreRadians) { EXPECT_DOUBLE_EQ(parse_quantity("180 deg", "1"), std::acos(-1.0)); }

TEST(Units, RefuseWhatIsNoUnit) {
  for (const char* text :
       {"", "mmm", "m^", "m^0", "m3", "kg/m s", "/", "(m", "m)", "m//s", "kilogram", "10", "m^99", "k"})
    EXPECT_FALSE(parse_unit(text)) << text;
}

void expect_error(const char* text, const char* unit, const std::string& what, const std::string& fix) {
  try {
    parse_quantity(text, unit);
    ADD_FAILURE() << text << " was taken";
  } catch (const QuantityError& error) {
    EXPECT_EQ(error.what, what);
    EXPECT_EQ(error.fix, fix);
  }
}

TEST(Units, ErrorsNameTheDimensionAndAnExample) {
  expect_error("5", "mm", "5 has no unit; a length is needed.", "Write for example 5 mm.");
  expect_error("5 s", "mm", "5 s is a time; a length is needed.", "Write for example 5 mm.");
  expect_error("1.8e-5 Pa", "Pa s", "1.8e-5 Pa is a pressure; a dynamic viscosity is needed.",
               "Write for example 1.8e-5 Pa s.");
  expect_error("0.3 mm", "1", "0.3 mm is a length; a pure number is needed.",
               "Write it without a unit, for example 0.3.");
  expect_error("5 mmm", "mm", "\"mmm\" is not a unit.", "Here a length is needed, for example 5 mm.");
  expect_error("5 kg/m s", "Pa s", "\"kg/m s\" can be read in two ways.", "Use brackets, for example kg/(m s).");
  expect_error("20 C", "K", "\"C\" is not a unit.", "Write 293.15 K.");
  expect_error("-40 °C", "K", "\"°C\" is not a unit.", "Write 233.15 K.");
  expect_error("five mm", "mm", "\"five mm\" is not a number with a unit; a length is needed.",
               "Write for example 1 mm.");
  expect_error("nan", "1", "\"nan\" is not a number.", "Write for example 1.");
  expect_error("1e400 m", "m", "1e400 m is beyond the range of numbers.", "");
  expect_error("3 kg m^4", "m", "3 kg m^4 is a quantity in kg m^4; a length is needed.", "Write for example 3 m.");
}

TEST(Units, MessagesShowSixDigits) {
  EXPECT_EQ(format_quantity(0.0675, "mm"), "67.5 mm");
  EXPECT_EQ(format_quantity(0.07, "mm"), "70 mm");
  EXPECT_EQ(format_quantity(0.15, "mm"), "150 mm");
  EXPECT_EQ(format_quantity(1.79e-5, "Pa s"), "1.79e-05 Pa s");
  EXPECT_EQ(format_quantity(2e9, "GPa"), "2 GPa");
  EXPECT_EQ(format_quantity(0.74, "1"), "0.74");
  EXPECT_EQ(format_quantity(1e5, "N/m"), "100000 N/m");
}

TEST(Units, TwoDigitsTakeNoExponentBelowAMillion) {
  EXPECT_EQ(two_digits(171), "170");
  EXPECT_EQ(two_digits(99.6), "100");
  EXPECT_EQ(two_digits(-32100), "-32000");
  EXPECT_EQ(two_digits(3.21), "3.2");
  EXPECT_EQ(two_digits(0.0123), "0.012");
  EXPECT_EQ(two_digits(3.2e7), "3.2e+07");
}

TEST(Units, ExactNumbersReadBackAsTheSameBits) {
  for (const double value : {0.1, 1.0 / 3, 1.79e-5, 6.02214076e23, 5e-324, 0.07 * 3})
    EXPECT_EQ(parse_quantity(exact_number(value) + " m", "m"), value);
}

}  // namespace
}  // namespace similitude
