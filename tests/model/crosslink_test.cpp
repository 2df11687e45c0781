#include "supple/model/crosslink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "tests/support/scaffold.hpp"

namespace supple {
namespace {

using testing::lattice, testing::link_everything;

int count_links(const System<2>& system, LinkKind kind = LinkKind::all) {
  return static_cast<int>(link_rows(system, kind).size());
}

CrosslinkSpec bulk() {
  CrosslinkSpec spec;
  spec.cut_lines = 0;
  return spec;
}

double tallest(const CrosslinkReport& report) {
  return *std::max_element(report.height.begin(), report.height.end());
}

TEST(Crosslink, BulkScaffoldLinksEveryTouchingPairWithoutHistory) {
  System<2> system = lattice(6, 6);
  std::fill(system.pairs.history.begin(), system.pairs.history.end(), 0.3);
  const CrosslinkReport report = crosslink(system, bulk(), 1);
  EXPECT_EQ(report.links, 3 * 36);
  EXPECT_EQ(count_links(system), 3 * 36);
  EXPECT_EQ(report.tries, 1);
  for (const std::int32_t row : link_rows(system, LinkKind::all)) EXPECT_EQ(system.pairs.history[row], 0);
  EXPECT_EQ(std::set(report.particle.begin(), report.particle.end()).size(), 1u);
}

TEST(Crosslink, PhysicalLinksDoNotCrossTheBoundary) {
  System<2> system = lattice(6, 6);
  crosslink(system, bulk(), 1);
  const Vec2 half = system.box.centre();
  std::set<std::int32_t> expected;
  for (const std::int32_t row : link_rows(system, LinkKind::all)) {
    const Vec2 raw =
        system.state.position[system.pairs.second[row]] - system.state.position[system.pairs.first[row]];
    if (std::abs(raw[0]) < half[0] && std::abs(raw[1]) < half[1]) expected.insert(row);
  }
  const auto physical = link_rows(system, LinkKind::physical);
  EXPECT_EQ(std::set(physical.begin(), physical.end()), expected);
  EXPECT_LT(expected.size(), 3u * 36);
}

TEST(Crosslink, ParticlesAreTheComponentsOfPhysicalLinks) {
  Box<2> box;
  box.length = {10, 10};
  // A column of three, a pair across the x boundary, one alone.
  System<2> system =
      listed_discs(box, {{5, 5}, {9.6, 2}, {5, 6.5}, {0.4, 2}, {5, 8}, {2, 5}}, std::vector(6, 0.8), 1);
  testing::fill_all_pairs(system);
  link_everything(system);
  EXPECT_EQ(connected_particles(system), (std::vector<std::int32_t>{0, 1, 0, 2, 0, 3}));
  EXPECT_EQ(connected_particles(system, LinkKind::all), (std::vector<std::int32_t>{0, 1, 0, 1, 0, 2}));
  const auto height = particle_heights(system.state, connected_particles(system));
  EXPECT_NEAR(height[0], 3 + 1.6, 1e-12);
  EXPECT_NEAR(height[3], 1.6, 1e-12);
}

TEST(Crosslink, CutTopBottomLeavesNoLinkAcrossThePlates) {
  System<2> system = lattice(6, 6);
  CrosslinkSpec spec = bulk();
  spec.cut_top_bottom = true;
  crosslink(system, spec, 1);
  for (const TouchingPair& pair : touching_pairs(system)) {
    const double y = system.state.position[pair.first][1] + pair.separation[1];
    const bool across_a_plate = y <= 0 || y >= system.box.length[1];
    EXPECT_EQ(system.pairs.state[pair.row] == ContactState::permanent, !across_a_plate);
  }
}

TEST(Crosslink, NoParticleSpansTheHeightAndRecutsAreFresh) {
  int most_tries = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const CutKind kind : {CutKind::voronoi, CutKind::lines}) {
      System<2> system = lattice();
      CrosslinkSpec spec;
      spec.cut = kind;
      spec.cut_lines = kind == CutKind::voronoi ? 5 : 8;
      spec.avoid_horizontal = 0.26;
      const CrosslinkReport report = crosslink(system, spec, seed);
      EXPECT_LE(tallest(report), 0.9 * system.box.length[1]);
      EXPECT_GT(std::set(report.particle.begin(), report.particle.end()).size(), 1u);
      most_tries = std::max(most_tries, report.tries);
    }
  }
  EXPECT_GT(most_tries, 1);  // otherwise this test shows nothing
}

TEST(Crosslink, ImpossibleHeightIsAClearError) {
  System<2> system = lattice();
  CrosslinkSpec spec;
  spec.cut = CutKind::lines;
  spec.cut_lines = 1;
  spec.avoid_horizontal = 1.0;
  spec.max_tries = 7;
  try {
    crosslink(system, spec, 1);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_STREQ(
        error.what(),
        "7 cuts each left a particle taller than 0.9 of the cell (cut_lines = 1 makes particles too large); "
        "raise cut_lines or max_cut_tries, or set avoid_height_spanning_particles = false");
  }
  spec.avoid_height_spanning = false;
  EXPECT_EQ(crosslink(system, spec, 1).tries, 1);
}

TEST(Crosslink, RemovalReachesItsFractionAndKeepsParticlesConnected) {
  CrosslinkSpec spec;
  System<2> whole = lattice();
  const CrosslinkReport unremoved = crosslink(whole, spec, 5);
  const int links = count_links(whole, LinkKind::physical);
  const int particles = static_cast<int>(unremoved.height.size());
  const int essential = whole.state.size() - particles;  // links of a spanning forest

  for (const double fraction : {0.1, 0.35, 0.5}) {
    System<2> system = lattice();
    spec.remove_link_fraction = fraction;
    const CrosslinkReport report = crosslink(system, spec, 5);
    EXPECT_EQ(report.removed, std::llround(fraction * links));
    EXPECT_EQ(count_links(system, LinkKind::physical), links - report.removed);
    EXPECT_NEAR(report.removed_fraction, fraction, 0.51 / links);
    EXPECT_EQ(report.particle, unremoved.particle);
  }
  System<2> system = lattice();
  spec.remove_link_fraction = 1;
  const CrosslinkReport report = crosslink(system, spec, 5);
  EXPECT_EQ(count_links(system, LinkKind::physical), essential);
  EXPECT_EQ(report.removed, links - essential);
  EXPECT_LT(report.removed_fraction, 1);
  EXPECT_EQ(report.particle, unremoved.particle);
}

TEST(Crosslink, RemovedLinksAreThoseOfRemovingOneByOne) {
  System<2> at_once = lattice(6, 6), one_by_one = lattice(6, 6);
  link_everything(at_once);
  link_everything(one_by_one);
  const auto before = link_rows(at_once, LinkKind::physical);
  remove_links(at_once, 0.5, 3);
  // The order is that of each link's own draw; a link goes if its discs stay connected without it.
  std::vector<std::pair<double, std::int32_t>> order;
  for (const std::int32_t row : before)
    order.emplace_back(RandomStream(3, Purpose::link_removal,
                                    stream_index(one_by_one.pairs.first[row], one_by_one.pairs.second[row]))
                           .uniform(),
                       row);
  std::sort(order.begin(), order.end());
  const int wanted = static_cast<int>(std::llround(0.5 * static_cast<double>(before.size())));
  int removed = 0;
  for (const auto& [draw, row] : order) {
    if (removed == wanted) break;
    cut(one_by_one.pairs, row);
    const auto particle = connected_particles(one_by_one);
    if (particle[one_by_one.pairs.first[row]] != particle[one_by_one.pairs.second[row]])
      link(one_by_one.pairs, row);
    else ++removed;
  }
  EXPECT_EQ(link_rows(at_once, LinkKind::physical), link_rows(one_by_one, LinkKind::physical));
}

TEST(Crosslink, IsolatedDiscsAreJoinedToOneTouchingNeighbour) {
  Box<2> box;
  box.length = {10, 10};
  System<2> system =
      listed_discs(box, {{2, 5}, {3, 5}, {4, 5}, {8, 5}, {0.2, 9}, {9.6, 9}}, std::vector(6, 0.6), 1);
  testing::fill_all_pairs(system);
  const auto touching = touching_pairs(system);
  EXPECT_EQ(touching.size(), 3u);
  // 0 and 1 join, then 2 joins 1 (or 1 joins 2 and 0 joins 1); 3 touches nobody; 4 and 5 join across the
  // boundary.
  join_isolated_discs(system, touching, 1, 0);
  const auto state = [&](int i, int j) { return system.pairs.state[system.pairs.find(i, j)]; };
  EXPECT_EQ(state(0, 1), ContactState::permanent);
  EXPECT_EQ(state(1, 2), ContactState::permanent);
  EXPECT_EQ(state(4, 5), ContactState::permanent);
  EXPECT_EQ(count_links(system), 3);
  EXPECT_EQ(join_isolated_discs(system, touching, 1, 1), 0);
}

TEST(Crosslink, JoinedNeighbourIsUniform) {
  std::vector<int> chosen(7, 0);
  for (std::uint64_t seed = 0; seed < 6000; ++seed) {
    Box<2> box;
    box.length = {10, 10};
    System<2> system = listed_discs(box, {{5, 5}, {6, 5}, {4, 5}, {5, 6}}, std::vector(4, 0.6), 1);
    testing::fill_all_pairs(system);
    join_isolated_discs(system, touching_pairs(system), seed, 0);
    const auto first = RandomStream(seed, Purpose::isolated_join, 0).below(3);
    EXPECT_EQ(system.pairs.state[static_cast<std::size_t>(first)], ContactState::permanent);
    ++chosen[first];
  }
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(chosen[k], 2000, 5 * std::sqrt(2000.0 * 2 / 3));
}

TEST(Crosslink, EveryDiscOfADenseSystemHasALink) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    System<2> system = lattice();
    CrosslinkSpec spec;
    spec.cut_lines = 60;  // about three discs a particle: many are left alone
    spec.edge_fuzziness = 2;
    spec.join = seed % 2 ? IsolatedJoin::before_height_check : IsolatedJoin::last;
    const CrosslinkReport report = crosslink(system, spec, seed);
    EXPECT_GT(report.joined, 0);
    std::vector<int> links(system.state.size(), 0);
    for (const std::int32_t row : link_rows(system, LinkKind::all)) {
      ++links[system.pairs.first[row]];
      ++links[system.pairs.second[row]];
    }
    EXPECT_GT(*std::min_element(links.begin(), links.end()), 0);
  }
}

TEST(Crosslink, SameSeedSameParticlesOtherSeedOthers) {
  CrosslinkSpec spec;
  spec.edge_fuzziness = 1;
  spec.remove_link_fraction = 0.2;
  System<2> a = lattice(), b = lattice(), c = lattice();
  crosslink(a, spec, 1);
  crosslink(b, spec, 1);
  crosslink(c, spec, 2);
  EXPECT_EQ(a.pairs.state, b.pairs.state);
  EXPECT_NE(a.pairs.state, c.pairs.state);
  crosslink(b, spec, 1);  // earlier links are undone
  EXPECT_EQ(a.pairs.state, b.pairs.state);
}

TEST(Crosslink, BadNumbersAndMissingPairsAreInputErrors) {
  System<2> system = lattice(6, 6);
  CrosslinkSpec spec;
  spec.remove_link_fraction = 1.2;
  EXPECT_THROW(crosslink(system, spec, 1), Error);
  spec = {};
  spec.cut_lines = -1;
  EXPECT_THROW(crosslink(system, spec, 1), Error);
  spec = {};
  spec.avoid_horizontal = 2;
  EXPECT_THROW(crosslink(system, spec, 1), Error);
  system.pairs.clear();
  EXPECT_THROW(crosslink(system, CrosslinkSpec{}, 1), Error);
}

}  // namespace
}  // namespace supple
