#include "supple/contact/neighbor_list.hpp"

#include <gtest/gtest.h>

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
      if (norm(s.box.displacement(s.state.position[i], s.state.position[j])) < s.state.radius[i] + s.state.radius[j])
        found.insert({i, j});
  return found;
}

template <int Dim>
Pairs touching_in_table(const System<Dim>& s) {
  Pairs found;
  for (int row = 0; row < s.pairs.size(); ++row) {
    const int i = s.pairs.first[row], j = s.pairs.second[row];
    if (norm(s.box.displacement(s.state.position[i], s.state.position[j])) < s.state.radius[i] + s.state.radius[j])
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
