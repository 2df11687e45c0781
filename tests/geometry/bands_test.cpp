#include "supple/geometry/bands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace supple {
namespace {

std::vector<Interval> random_intervals(int count, double longest, std::mt19937& engine) {
  std::uniform_real_distribution<double> at(-3, 5), length(0, longest);
  std::vector<Interval> out;
  for (int k = 0; k < count; ++k) {
    const double low = at(engine);
    out.push_back({low, low + length(engine)});
  }
  return out;
}

TEST(Bands, HoldEveryIntervalAtAPointAndEachThatMeetsOneOnce) {
  std::mt19937 engine(3);
  for (const int count : {1, 2, 40, 300})
    for (const double longest : {0.0, 0.1, 2.0, 20.0}) {
      const std::vector<Interval> all = random_intervals(count, longest, engine);
      const Bands bands(all);
      for (double x = -4; x < 7; x += 0.37) {
        const auto found = bands.at(x);
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        for (int k = 0; k < count; ++k)
          if (all[k].low <= x && x <= all[k].high) {
            EXPECT_TRUE(std::binary_search(found.begin(), found.end(), k));
          }
        std::vector<int> meeting(count);
        bands.for_each_meeting(x, x + 0.8, all, [&](int k) { ++meeting[k]; });
        for (int k = 0; k < count; ++k) {
          EXPECT_LE(meeting[k], 1);
          if (all[k].low <= x + 0.8 && x <= all[k].high) {
            EXPECT_EQ(meeting[k], 1);
          }
        }
      }
    }
}

TEST(Bands, ListsStayShort) {  // or a ring of 20000 vertices costs 4e8 looks
  std::vector<Interval> all;
  for (int k = 0; k < 20000; ++k) all.push_back({1e-4 * k, 1e-4 * (k + 2)});
  const Bands bands(all);
  std::size_t longest = 0;
  for (double x = -1; x < 4; x += 1e-3) longest = std::max(longest, bands.at(x).size());
  EXPECT_LE(longest, 6u);
}

TEST(Bands, OfNothingAreEmpty) { EXPECT_TRUE(Bands({}).at(0).empty()); }

}  // namespace
}  // namespace supple
