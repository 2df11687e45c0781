#include "supple/contact/neighbor_list.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/support/suspension.hpp"

namespace supple {
namespace {

using Pairs = std::set<std::pair<int, int>>;

template <int Dim>
Pairs touching_by_brute_force(const System<Dim>& s) {
  Pairs found;
  for (int i = 0; i < s.state.size(); ++i)
    for (int j = i + 1; j < s.state.size(); ++j)
      if (norm(s.box.displacement(s.state.position[i], s.state.position[j])) <
          s.state.radius[i] + s.state.radius[j])
        found.insert({i, j});
  return found;
}

template <int Dim>
Pairs touching_in_table(const System<Dim>& s) {
  Pairs found;
  for (int row = 0; row < s.pairs.size(); ++row) {
    const int i = s.pairs.first[row], j = s.pairs.second[row];
    if (norm(s.box.displacement(s.state.position[i], s.state.position[j])) <
        s.state.radius[i] + s.state.radius[j])
      found.insert({i, j});
  }
  return found;
}

TEST(NeighborList, FindsEveryTouchingPairAtAnyStrain) {
  for (int n : {3, 20, 400})
    for (double strain : {0.0, 0.2, 0.5, 0.77, -1.3, 2.4}) {
      System<2> s = testing::random_suspension(n, n == 3 ? 0.2 : 1.2, strain);
      NeighborList<2> list;
      EXPECT_TRUE(list.update(s));
      EXPECT_EQ(touching_in_table(s), touching_by_brute_force(s)) << n << " discs, strain " << strain;
    }
}

TEST(NeighborList, FindsEveryTouchingPairInThreeDimensions) {
  for (double strain : {0.0, 0.6}) {
    System<3> s;
    s.box.length = {9, 8, 7};
    s.box.strain = strain;
    s.state.resize(500);
    for (int i = 0; i < 500; ++i) {
      RandomStream draw(3, Purpose::test, static_cast<std::uint64_t>(i));
      s.state.position[i] = {draw.uniform(0, 9), draw.uniform(0, 8), draw.uniform(0, 7)};
      s.state.radius[i] = 0.5;
    }
    NeighborList<3> list;
    list.update(s);
    EXPECT_GT(touching_by_brute_force(s).size(), 500u);
    EXPECT_EQ(touching_in_table(s), touching_by_brute_force(s));
  }
}

/// Pairs closer than the sum of their radii, over all images.
Pairs touching_over_all_images(const System<2>& s) {
  Pairs found;
  for (int i = 0; i < s.state.size(); ++i)
    for (int j = i + 1; j < s.state.size(); ++j) {
      const double reach = s.state.radius[i] + s.state.radius[j];
      const Vec2 r = s.state.position[j] - s.state.position[i];
      const double height = s.box.length[1], width = s.box.length[0];
      for (double up = std::ceil((-r[1] - reach) / height); up <= (-r[1] + reach) / height; ++up) {
        const double x = r[0] + up * s.box.strain * height;
        for (double along = std::ceil((-x - reach) / width); along <= (-x + reach) / width; ++along)
          if (norm(Vec2{x + along * width, r[1] + up * height}) < reach) found.insert({i, j});
      }
    }
  return found;
}

/// One size or sizes 1 to 100; cells of any shape; positions anywhere.
TEST(NeighborList, FindsEveryTouchingPairOfAnySizesInCellsOfAnyShape) {
  for (const Vec2& length : {Vec2{50, 40}, Vec2{6, 400}, Vec2{400, 6}})
    for (const double ratio : {1.0, 3.0, 100.0})
      for (const double strain : {0.0, 0.7, -3.2, 1e4}) {
        System<2> s;
        s.box.length = length;
        s.box.strain = strain;
        s.state.resize(400);
        const double large = 0.24 * std::min(length[0], length[1]);
        for (int i = 0; i < 400; ++i) {
          RandomStream draw(6, Purpose::test, static_cast<std::uint64_t>(i));
          s.state.position[i] = {draw.uniform(-2, 3) * length[0], draw.uniform(-2, 3) * length[1]};
          s.state.radius[i] = i % 100 == 0 ? large : std::max(large / ratio, 0.05) * draw.uniform(0.5, 1);
        }
        NeighborList<2> list;
        list.update(s);
        const Pairs right = touching_over_all_images(s);
        EXPECT_EQ(touching_in_table(s), right)
            << length[0] << " x " << length[1] << ", " << ratio << ", " << strain;
        EXPECT_FALSE(right.empty());
      }
}

/// Coordinates are no size of a grid: absurd ones find nobody, and corrupt nothing.
TEST(NeighborList, SitesThatAreAbsurdlyFarAwayMeetNobody) {
  for (const bool periodic : {false, true})
    for (const double far :
         {1e200, -1e200, 1e18, 3e9, std::numeric_limits<double>::infinity(), std::nan("")}) {
      System<2> s = testing::random_suspension(100, 0.8);
      s.box.periodic = {periodic, periodic};
      s.state.position[7] = {far, 3};
      s.state.position[8] = {3, far};
      s.state.position[9] = {far, far};
      NeighborList<2> list;
      list.update(s);
      int rows = 0;
      for (int row = 0; row < s.pairs.size(); ++row)
        for (const int i : {7, 8, 9}) rows += s.pairs.first[row] == i || s.pairs.second[row] == i;
      if (!periodic) {
        EXPECT_EQ(rows, 0) << far;
      }
      EXPECT_GT(s.pairs.size(), 100);
    }
}

TEST(NeighborList, StaysCompleteWhileDiscsMoveAndTheBoxShears) {
  System<2> s = testing::random_suspension(300, 1.2);
  NeighborList<2> list;
  const int steps = 400;
  for (int step = 0; step < steps; ++step) {
    for (int i = 0; i < s.state.size(); ++i) {
      s.state.position[i] += 0.004 * (s.state.velocity[i] + s.box.flow_velocity(s.state.position[i]));
      s.box.wrap(s.state.position[i], s.state.velocity[i]);
    }
    s.box.strain += 0.004 * s.box.strain_rate;
    list.update(s);
    ASSERT_EQ(touching_in_table(s), touching_by_brute_force(s)) << "step " << step;
  }
  EXPECT_LT(list.builds(), steps / 4);
}

TEST(NeighborList, KeepsLinksAndHistoryAcrossBuilds) {
  System<2> s = testing::random_suspension(100, 1.0);
  NeighborList<2> list;
  list.update(s);
  set_pair_state(s.pairs, 100, 0, 1, ContactState::permanent);  // far apart: no geometric pair
  const int row = s.pairs.find(0, 1);
  ASSERT_GE(row, 0);
  s.pairs.history[row] = 0.125;
  for (int r = 0; r < s.pairs.size(); ++r)
    if (r != row) s.pairs.history[r] = 1000.0 * s.pairs.first[r] + s.pairs.second[r];
  list.invalidate();
  list.update(s);
  ASSERT_GE(s.pairs.find(0, 1), 0);
  EXPECT_EQ(s.pairs.state[s.pairs.find(0, 1)], ContactState::permanent);
  EXPECT_EQ(s.pairs.history[s.pairs.find(0, 1)], 0.125);
  for (int r = 0; r < s.pairs.size(); ++r) {
    if (r == s.pairs.find(0, 1)) continue;
    EXPECT_EQ(s.pairs.history[r], 1000.0 * s.pairs.first[r] + s.pairs.second[r]);
  }
}

}  // namespace
}  // namespace supple
