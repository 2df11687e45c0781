#include "supple/io/text/quantity.hpp"

#include <gmock/gmock.h>

#include "supple/core/error.hpp"

namespace supple {
namespace {

using testing::HasSubstr;

std::string error_of(std::string_view text, std::string_view unit) {
  try {
    parse_quantity(text, unit);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(Quantity, PrefixesAreExactPowersOfTen) {
  EXPECT_EQ(parse_quantity("500 um", "m"), 500e-6);
  EXPECT_EQ(parse_quantity("500um", "m"), 500e-6);
  EXPECT_EQ(parse_quantity("500 µm", "m"), 500e-6);
  EXPECT_EQ(parse_quantity("0.5 mm", "m"), 0.5e-3);
  EXPECT_EQ(parse_quantity(" 8 kPa ", "Pa"), 8000);
  EXPECT_EQ(parse_quantity("0.1 us", "s"), 1e-7);
  EXPECT_EQ(parse_quantity("1.5e+2 nm", "m"), 150e-9);
  EXPECT_EQ(parse_quantity("2 MPa", "Pa"), 2e6);
  EXPECT_EQ(parse_quantity("3 mPa", "Pa"), 3e-3);
}

TEST(Quantity, ProductsAndPowers) {
  EXPECT_EQ(parse_quantity("1000 kg/m^3", "kg/m^3"), 1000);
  EXPECT_EQ(parse_quantity("1000 kg/m³", "kg/m^3"), 1000);
  EXPECT_EQ(parse_quantity("1000 kg m^-3", "kg/m^3"), 1000);
  EXPECT_EQ(parse_quantity("1.05 g/cm^3", "kg/m^3"), 1050);
  EXPECT_EQ(parse_quantity("8 kN/m^2", "Pa"), 8000);
  EXPECT_EQ(parse_quantity("4 kHz", "1/s"), 4000);
}

TEST(Quantity, UnitsAsDeclaredAndPercent) {
  EXPECT_EQ(parse_quantity("0.3 d0", "d0"), 0.3);
  EXPECT_EQ(parse_quantity("20 %", ""), 0.2);
  EXPECT_EQ(parse_quantity("15 deg", "degree"), 15);
}

TEST(Quantity, ErrorsSayWhatIsWrong) {
  EXPECT_THAT(error_of("wide", "m"), HasSubstr("\"wide\" is not a number"));
  EXPECT_THAT(error_of("nan m", "m"), HasSubstr("not a number"));
  EXPECT_THAT(error_of("5 kg", "m"), HasSubstr("wrong dimension, 'kg' is no multiple of m"));
  EXPECT_THAT(error_of("5 um/s", "m"), HasSubstr("wrong dimension"));
  EXPECT_THAT(error_of("5 furlong", "m"), HasSubstr("unknown unit 'furlong'"));
  EXPECT_THAT(error_of("1e999 m", "m"), HasSubstr("not a number"));
  EXPECT_THAT(error_of("0.1 m", ""), HasSubstr("a unit where none is expected"));
}

TEST(Quantity, QuotedNumbersAreAnsweredWithTheNumber) {
  EXPECT_THAT(error_of("0.2", ""), HasSubstr("\"0.2\" is text, not a number; write 0.2, without quotes"));
  EXPECT_THAT(error_of("0,2", ""), HasSubstr("write 0.2, without quotes"));
  EXPECT_THAT(error_of("5", "m"), HasSubstr("write 5, in m, without quotes"));
  EXPECT_THAT(error_of(".5 mm", "m"), testing::StrEq("no error"));
  EXPECT_THAT(error_of("0,5 mm", "m"), HasSubstr("write \"0.5 mm\""));
}

TEST(Quantity, UnknownUnitsAreAnsweredWithUnitsOfTheRightDimension) {
  EXPECT_THAT(error_of("8 kpa", "Pa"), HasSubstr("unknown unit 'kpa'; did you mean \"8 kPa\"?"));
  EXPECT_THAT(error_of("8 KPa", "Pa"), HasSubstr("did you mean \"8 kPa\"?"));
  EXPECT_THAT(error_of("8 mpa", "Pa"), HasSubstr("did you mean \"8 mPa\" or \"8 MPa\"?"));
  EXPECT_THAT(error_of("8 Pascal", "Pa"), HasSubstr("did you mean \"8 Pa\"?"));
  EXPECT_THAT(error_of("1000 kg/m3", "kg/m^3"), HasSubstr("did you mean \"1000 kg/m^3\"?"));
  EXPECT_THAT(error_of("1000 Kg/M3", "kg/m^3"), HasSubstr("did you mean \"1000 kg/m^3\"?"));
  EXPECT_THAT(error_of("500 µM", "m"), HasSubstr("did you mean \"500 µm\"?"));
  EXPECT_THAT(error_of("5 hz", "1/s"), HasSubstr("did you mean \"5 Hz\"?"));
  EXPECT_THAT(error_of("5 furlong", "m"), HasSubstr("write a number in m, or \"500 um\""));
}

}  // namespace
}  // namespace supple
