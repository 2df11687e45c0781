#include <gtest/gtest.h>

#include <limits>

#include "supple/io/text/number_text.hpp"

namespace supple {
namespace {

TEST(NumberText, ShortestFormReadsBack) {
  std::string text;
  for (const double x : {0.1, 150.0, -0.0, 1e-6, 3141592653.5897927}) {
    append_shortest(text, x);
    text += ' ';
  }
  append_integer(text, -12);
  EXPECT_EQ(text, "0.1 150 -0 1e-06 3141592653.5897927 -12");
}

/// Expected texts were written by Python 3.11's str().
TEST(NumberText, FloatsAsInPython) {
  EXPECT_EQ(python_float(0.1), "0.1");
  EXPECT_EQ(python_float(150), "150.0");
  EXPECT_EQ(python_float(-0.0), "-0.0");
  EXPECT_EQ(python_float(0.0001), "0.0001");
  EXPECT_EQ(python_float(0.00001), "1e-05");
  EXPECT_EQ(python_float(1.6653345369377348e-16), "1.6653345369377348e-16");
  EXPECT_EQ(python_float(-3448.876803778479e-10), "-3.448876803778479e-07");
  EXPECT_EQ(python_float(1e15), "1000000000000000.0");
  EXPECT_EQ(python_float(1e16), "1e+16");
  EXPECT_EQ(python_float(9007199254740993.0), "9007199254740992.0");
  EXPECT_EQ(python_float(123456789012345680.0), "1.2345678901234568e+17");
  EXPECT_EQ(python_float(5e-324), "5e-324");
  EXPECT_EQ(python_float(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
  EXPECT_EQ(python_float(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(python_float(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(NumberText, WholeNumbersAsPythonsInts) {
  EXPECT_EQ(python_number(150), "150");
  EXPECT_EQ(python_number(0.5), "0.5");
  EXPECT_EQ(python_number(-0.0), "0");
}

}  // namespace
}  // namespace supple
