#include "supple/experiment/random_centres.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace supple {
namespace {

struct Placed {
  std::vector<double> radius;
  Box<2> box;
  std::vector<Vec2> centre;
  long asked = 0;  ///< whether to stop: once an evaluation
};

/// `narrow` discs of radius 1 and four of `ratio` in a square cell, half of it covered.
Placed place(int narrow, double ratio, bool periodic, std::int64_t seed = 7) {
  Placed p;
  p.radius.assign(static_cast<std::size_t>(narrow), 1.0);
  p.radius.insert(p.radius.end(), 4, ratio);
  double area = 0;
  for (const double r : p.radius) area += std::numbers::pi * r * r;
  const double side = std::sqrt(2 * area);
  p.box.length = {side, side};
  p.box.periodic = {periodic, periodic};
  p.centre = random_centres(p.radius, p.box, seed, [&] { return ++p.asked, false; });
  return p;
}

/// The least distance of two discs over the sum of their radii.
double least_gap(const Placed& p) {
  double least = 1e300;
  for (std::size_t i = 0; i < p.radius.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least =
          std::min(least, norm(p.box.displacement(p.centre[i], p.centre[j])) / (p.radius[i] + p.radius[j]));
  return least;
}

TEST(RandomCentres, AreApartWhateverTheSizes) {
  for (const bool periodic : {true, false})
    for (const double ratio : {1.0, 10.0, 13.0, 100.0})
      EXPECT_GE(least_gap(place(200, ratio, periodic)), 1) << ratio << " " << periodic;
}

/// Those drawn in a disc a hundred times as wide had to leave it in steps of their own size: 20 000
/// evaluations were not enough, and they stayed in each other.
TEST(RandomCentres, OfVeryDifferentSizesFindRoomInTime) {
  for (const bool periodic : {true, false})
    for (const std::int64_t seed : {1, 2, 3}) {
      const Placed p = place(1000, 100, periodic, seed);
      EXPECT_GE(least_gap(p), 1) << periodic << " " << seed;
      EXPECT_LT(p.asked, 12000) << periodic << " " << seed;
    }
}

}  // namespace
}  // namespace supple
