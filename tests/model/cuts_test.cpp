#include "supple/model/cuts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "supple/core/random.hpp"
#include "tests/support/scaffold.hpp"

namespace supple {
namespace {

using testing::lattice, testing::link_everything;

TEST(Cuts, NearestDistanceIsTheLeastOverAllImages) {
  RandomStream draw(1, Purpose::test);
  for (int trial = 0; trial < 400; ++trial) {
    Box<2> box;
    box.length = {draw.uniform(1, 8), draw.uniform(1, 4)};
    box.strain = draw.uniform(-3, 3);
    const Vec2 a{draw.uniform() * box.length[0], draw.uniform() * box.length[1]};
    const Vec2 b{draw.uniform() * box.length[0], draw.uniform() * box.length[1]};
    double expected = std::numeric_limits<double>::infinity();
    for (int up = -20; up <= 20; ++up)
      for (int right = -60; right <= 60; ++right)
        expected = std::min(
            expected,
            norm(b - a + Vec2{right * box.length[0] + up * box.strain * box.length[1], up * box.length[1]}));
    EXPECT_NEAR(nearest_distance(box, a, b), expected, 1e-12);
  }
}

TEST(Cuts, VoronoiCutsExactlyTheLinksBetweenNearestPoints) {
  System<2> system = lattice();
  system.box.strain =
      0.37;  // the lattice no longer fits across the boundary, the distances must still be right
  link_everything(system);
  const auto before = link_rows(system, LinkKind::all);
  const auto points = random_particle_seeds(system.box, 6, 4, 0);
  const auto cell = voronoi_cells(system, points, 0, 4, 0);
  for (int i = 0; i < system.state.size(); ++i)
    for (const Vec2& point : points)
      EXPECT_LE(nearest_distance(system.box, system.state.position[i], points[cell[i]]),
                nearest_distance(system.box, system.state.position[i], point));
  cut_between_cells(system.pairs, touching_pairs(system), cell);
  for (const std::int32_t row : before) {
    const bool same = cell[system.pairs.first[row]] == cell[system.pairs.second[row]];
    EXPECT_EQ(system.pairs.state[row], same ? ContactState::permanent : ContactState::slip);
  }
  EXPECT_LT(link_rows(system, LinkKind::all).size(), before.size());
}

TEST(Cuts, FuzzinessMovesDiscsNearAnEdgeOnly) {
  const System<2> system = lattice(20, 22);
  const auto points = random_particle_seeds(system.box, 5, 9, 0);
  const auto sharp = voronoi_cells(system, points, 0, 9, 0), fuzzy = voronoi_cells(system, points, 1.5, 9, 0);
  int moved = 0;
  for (int i = 0; i < system.state.size(); ++i) {
    const auto distance = [&](int p) {
      return nearest_distance(system.box, system.state.position[i], points[p]);
    };
    moved += sharp[i] != fuzzy[i];
    EXPECT_LT(distance(fuzzy[i]) - distance(sharp[i]), 1.5);
  }
  EXPECT_GT(moved, 5);
}

TEST(Cuts, LinesCutTheLinksTheyCrossAndAvoidTheHorizontal) {
  const double avoid = 15 * std::numbers::pi / 180;
  Box<2> box;
  box.length = {3, 2};
  double flattest = 10, steepest = 0;
  for (int line = 0; line < 5000; ++line) {
    const CutLine cut = random_cut_line(box, avoid, 2, 0, line);
    const double to_horizontal = std::acos(std::min(1.0, std::abs(cut.normal[1])));
    EXPECT_NEAR(norm(cut.normal), 1, 1e-14);
    flattest = std::min(flattest, to_horizontal);
    steepest = std::max(steepest, to_horizontal);
  }
  EXPECT_GE(flattest, avoid - 1e-9);
  EXPECT_LT(flattest, avoid + 0.01);
  EXPECT_GT(steepest, std::numbers::pi / 2 - 0.01);

  System<2> system = lattice(6, 6);
  link_everything(system);
  cut_along_line(system, touching_pairs(system), {{2.5, 0}, {1, 0}});
  for (const TouchingPair& pair : touching_pairs(system)) {
    const double x = system.state.position[pair.first][0];
    const bool crossed = (x - 2.5) * (x + pair.separation[0] - 2.5) <= 0;
    EXPECT_EQ(system.pairs.state[pair.row], crossed ? ContactState::slip : ContactState::permanent);
  }
}

TEST(Cuts, DrawsDoNotDependOnTheNumberOfDiscsOrPoints) {
  const System<2> small = lattice(6, 6);
  System<2> large = small;
  for (int i = 0; i < 10; ++i) add_disc(large.state, {0.1 * i, 0.1}, 0.5, 1);
  const auto points = random_particle_seeds(small.box, 5, 3, 1),
             more = random_particle_seeds(small.box, 9, 3, 1);
  EXPECT_TRUE(std::equal(points.begin(), points.end(), more.begin()));
  EXPECT_FALSE(points[0] == random_particle_seeds(small.box, 5, 3, 2)[0]);
  const auto cells = voronoi_cells(small, points, 2, 3, 1),
             cells_of_more = voronoi_cells(large, points, 2, 3, 1);
  EXPECT_TRUE(std::equal(cells.begin(), cells.end(), cells_of_more.begin()));
}

TEST(Cuts, VoronoiParticlesHaveTheirShareOfTheDiscsOnAverage) {
  const int repeats = 400, points = 6;
  const System<2> system = lattice(10, 12);
  double mean_square = 0, mean = 0;
  for (int seed = 0; seed < repeats; ++seed) {
    const auto cell = voronoi_cells(system, random_particle_seeds(system.box, points, seed, 0), 0, seed, 0);
    const double share =
        static_cast<double>(std::count(cell.begin(), cell.end(), 0)) / system.state.size() * points;
    mean += share / repeats;
    mean_square += share * share / repeats;
  }
  const double deviation = std::sqrt(mean_square - mean * mean);
  EXPECT_NEAR(mean, 1, 5 * deviation / std::sqrt(repeats));
  EXPECT_NEAR(deviation, 0.53,
              0.2);  // areas of a Poisson-Voronoi tessellation; less in a small periodic cell
}

}  // namespace
}  // namespace supple
