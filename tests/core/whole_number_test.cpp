#include "supple/core/whole_number.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace supple {
namespace {

TEST(WholeNumber, IsTheNearest) {
  EXPECT_EQ(whole_number(2.4999, "n", ""), 2);
  EXPECT_EQ(whole_number(-2.5, "n", ""), -3);
  EXPECT_EQ(whole_number(9e14, "n", ""), 900000000000000);
  EXPECT_EQ(whole_number<int>(2147483647.0, "n", ""), 2147483647);
}

TEST(WholeNumber, BeyondIntegersIsAnInputErrorThatNamesIt) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {inf, -inf, nan, 1e300, 1.1e15}) EXPECT_THROW(whole_number(x, "n", ""), Error) << x;
  for (const double x : {2147483648.0, -1e10}) EXPECT_THROW(whole_number<int>(x, "n", ""), Error) << x;
  EXPECT_THROW(whole_number(1001, "n", "", 1000), Error);
  try {
    whole_number(1e300, "steps of the heap", "lower slump.settle_time");
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_STREQ(e.what(), "steps of the heap would be 1e+300 (it can be 1e+15); lower slump.settle_time");
  }
}

}  // namespace
}  // namespace supple
