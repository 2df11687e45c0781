#include "supple/core/nearest_name.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

TEST(NearestName, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("friction", "friction"), 0);
  EXPECT_EQ(edit_distance("Friction", "friction"), 0);
  EXPECT_EQ(edit_distance("fricton", "friction"), 1);
  EXPECT_EQ(edit_distance("fricttion", "friction"), 1);
  EXPECT_EQ(edit_distance("frixtion", "friction"), 1);
  EXPECT_EQ(edit_distance("frcition", "friction"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(NearestName, NothingIsSuggestedForAnotherWord) {
  const std::vector<std::string> names{"friction", "density", "slip"};
  EXPECT_EQ(nearest_name("densty", names), "density");
  EXPECT_EQ(nearest_name("lsip", names), "slip");
  EXPECT_EQ(nearest_name("temperature", names), std::nullopt);
}

}  // namespace
}  // namespace supple
