#include "supple/geometry/disc_overlap.hpp"

#include <gtest/gtest.h>

namespace {

using std::numbers::pi;
using supple::overlap_share;

TEST(DiscOverlap, EqualDiscsShareTheLens) {
  // Discs through each other's centres: a lens of 2 pi/3 - sqrt(3)/2.
  EXPECT_NEAR(overlap_share(1, 1, 1), pi / 3 - std::sqrt(3.0) / 4, 1e-15);
  EXPECT_EQ(overlap_share(1, 1, 2), 0);
  EXPECT_EQ(overlap_share(1, 1, 2.5), 0);
}

TEST(DiscOverlap, UnequalDiscs) {
  // Circles of sqrt(2) and 1 that cross at right angles to the line of centres through the smaller one's
  // centre: the smaller loses the half disc beyond it, the larger a segment of 90 degrees.
  EXPECT_NEAR(overlap_share(1, std::sqrt(2.0), 1), pi / 2, 1e-14);
  EXPECT_NEAR(overlap_share(std::sqrt(2.0), 1, 1), pi / 2 - 1, 1e-14);
  // Just overlapping, by the leading term (4/3) d sqrt(2 R d) with the depth d of each segment, d ~
  // overlap/radius.
  const double h = 1e-6, small = 0.5, large = 2;
  const double depth = h * large / (small + large);
  EXPECT_NEAR(
      overlap_share(small, large, small + large - h) / (4.0 / 3 * depth * std::sqrt(2 * small * depth)), 1,
      1e-5);
}

TEST(DiscOverlap, OneDiscInsideTheOther) {
  EXPECT_NEAR(overlap_share(0.5, 2, 1), pi / 4, 1e-15);
  EXPECT_EQ(overlap_share(2, 0.5, 1), 0);
  EXPECT_NEAR(overlap_share(0.5, 2, 0), pi / 4, 1e-15);
  EXPECT_NEAR(overlap_share(1, 1, 0), pi / 2, 1e-15);
}

TEST(DiscOverlap, FallsByTheChordAsDiscsPart) {
  // d(overlap)/d(distance) = -chord.
  const double a = 0.7, b = 1.1, distance = 1.3, h = 1e-5;
  const auto overlap = [=](double d) { return overlap_share(a, b, d) + overlap_share(b, a, d); };
  const double along = 0.5 * (distance + (a * a - b * b) / distance);
  EXPECT_NEAR((overlap(distance + h) - overlap(distance - h)) / (2 * h),
              -2 * std::sqrt(a * a - along * along), 1e-9);
}

}  // namespace
