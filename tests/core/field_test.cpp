#include "supple/core/field.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

TEST(Field, DescribesRangesInWords) {
  EXPECT_EQ(describe(positive), "above 0");
  EXPECT_EQ(describe(not_negative), "at least 0");
  EXPECT_EQ(describe(fraction), "from 0 to 1");
  EXPECT_EQ(describe({0, 5, true, false}), "above 0, at most 5");
  EXPECT_EQ(describe({0, 1, true, true}), "above 0, below 1");
  EXPECT_EQ(describe({0, 1, false, true}), "from 0, below 1");
  EXPECT_EQ(describe(any_value), "");
}

TEST(Field, NoRangeHoldsNotANumberOrInfinity) {
  EXPECT_FALSE(any_value.contains(NAN));
  EXPECT_FALSE(any_value.contains(INFINITY));
  EXPECT_TRUE(any_value.contains(-1e300));
}

}  // namespace
}  // namespace supple
