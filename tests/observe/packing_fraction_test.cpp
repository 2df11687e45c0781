#include "supple/observe/packing_fraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "supple/core/error.hpp"
#include "supple/geometry/disc_overlap.hpp"
#include "supple/geometry/polygon.hpp"
#include "tests/support/shapes.hpp"

namespace supple {
namespace {

using std::numbers::pi;
using namespace testing;

double exact_area(const System<2>& system, Outline outline) {
  return packing_fraction(system, outline).total * system.box.volume();
}

double area_alone(const Ring& ring, double radius, Outline outline) {
  System<2> system = empty_cell(20, 30);
  add_outline(system, ring, radius);
  const double exact = exact_area(system, outline);
  const RoughSum sum = rough_sum(system);
  if (outline == Outline::rough && sum.doubts == 0) {
    EXPECT_NEAR(sum.total * 600, exact, 1e-11);
  }
  return exact;
}

double turn_at(const Ring& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vec2 in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
  return std::atan2(cross(in, out), dot(in, out));
}

double perimeter(const Ring& ring) {
  double p = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) p += norm(ring[(i + 1) % ring.size()] - ring[i]);
  return p;
}

void expect_shares_add_up(const System<2>& system, const std::vector<double>& area, double total) {
  EXPECT_EQ(area.size(), system.topology.begin.size() - 1);
  EXPECT_NEAR(std::accumulate(area.begin(), area.end(), 0.0) / system.box.volume(), total, 1e-14);
}

TEST(PackingFraction, RegularPolygons) {
  for (const int n : {3, 4, 5, 10, 40})
    for (const double ratio : {0.3, 0.5, 0.501, 0.8, 1.0, 1.5, 4.0}) {  // edge/diameter
      const Ring ring = regular_polygon(n, 2, {7, 9}, 0.3);
      const double edge = 4 * std::sin(pi / n), r = edge / (2 * ratio), a = 2 * n * std::sin(2 * pi / n);
      EXPECT_NEAR(area_alone(ring, r, Outline::smooth), a + n * edge * r + pi * r * r, 1e-11)
          << n << ' ' << ratio;
      const double lens =
          ratio < 1 ? 2 * r * r * std::acos(ratio) - edge * r * std::sqrt(1 - ratio * ratio) : 0;
      const double rough = a + n * (pi / 2 + pi / n) * r * r - n * lens / 2;
      EXPECT_NEAR(area_alone(ring, r, Outline::rough), rough, 1e-11) << n << ' ' << ratio;
      System<2> system = empty_cell(20, 20);
      add_outline(system, ring, r);
      EXPECT_EQ(rough_sum(system).doubts, 0);
    }
}

TEST(PackingFraction, SumOfAConvexRingIsExactOrInDoubt) {
  int exact = 0, doubtful = 0, wrong = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream draw(seed, Purpose::test);
    std::vector<double> angle(3 + draw.below(8));
    for (double& a : angle) a = draw.uniform(0, 2 * pi);
    std::sort(angle.begin(), angle.end());
    Ring ring;
    for (const double a : angle) ring.push_back({12 + 2 * std::cos(a), 12 + std::sin(a)});  // of an ellipse
    for (const double r : {0.05, 0.3, 1.0, 3.0}) {
      System<2> system = empty_cell(24, 24);
      add_outline(system, ring, r);
      const RoughSum sum = rough_sum(system);
      const double error = std::abs(sum.total * 576 - exact_area(system, Outline::rough));
      if (sum.doubts == 0) {
        EXPECT_LT(error, 1e-11) << seed << ' ' << r;
      }
      (sum.doubts ? doubtful : exact) += 1;
      wrong += error > 1e-11;
    }
  }
  EXPECT_GT(exact, 100);
  EXPECT_GT(wrong, doubtful / 3);  // doubts are not idle
}

TEST(PackingFraction, PartsOfTheSum) {
  System<2> system = empty_cell(10, 10);
  add_outline(system, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, 0.5);
  const RoughSum sum = rough_sum(system);
  EXPECT_NEAR(sum.polygons, 0.04, 1e-15);
  EXPECT_NEAR(sum.vertices, 0.01 * pi, 1e-15);
  EXPECT_NEAR(sum.sectors, 0.0025 * pi, 1e-15);
  EXPECT_EQ(sum.pairs, 0);
  EXPECT_NEAR(sum.total, 0.04 + 0.0075 * pi, 1e-15);
}

TEST(PackingFraction, SquareWithCornerDiscs) {
  // Up to the disc that passes through the next corner, edges and circles meet in every special way.
  const Ring square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_NEAR(area_alone(square, 0, Outline::rough), 4, 1e-13);
  EXPECT_NEAR(area_alone(square, 0, Outline::smooth), 4, 1e-13);
  for (const double r : {0.1, 0.5, 1.0})
    EXPECT_NEAR(area_alone(square, r, Outline::rough), 4 + 3 * pi * r * r, 1e-12);
  const double half_lens = 4 * pi / 3 - std::sqrt(3.0);  // circles through each other's centres
  EXPECT_NEAR(area_alone(square, 2, Outline::rough), 4 + 12 * pi - 4 * half_lens, 1e-11);
  // Vertices in the middle of edges change nothing but the discs.
  const Ring more = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  EXPECT_NEAR(area_alone(more, 0.25, Outline::rough), 4 + 5 * pi / 16, 1e-12);
  EXPECT_NEAR(area_alone(more, 0.25, Outline::smooth), 4 + 2 + pi / 16, 1e-12);
}

TEST(PackingFraction, NotConvex) {
  const Ring ring = star(5, 2, 0.8, {3, 3}, 0.1);
  const double r = 0.15;  // small enough for the notches
  double rough = polygon_area(ring), smooth = polygon_area(ring) + r * perimeter(ring);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double turn = turn_at(ring, i);
    rough += 0.5 * r * r * (pi + turn);
    smooth += turn > 0 ? 0.5 * r * r * turn : -r * r * std::tan(-turn / 2);  // strips meet in a kite
  }
  EXPECT_NEAR(area_alone(ring, r, Outline::rough), rough, 1e-12);
  EXPECT_NEAR(area_alone(ring, r, Outline::smooth), smooth, 1e-12);
  System<2> system = empty_cell(9, 9);
  add_outline(system, ring, r);
  EXPECT_EQ(rough_sum(system).doubts, 0);
  // Discs so large that they fill the notches: the sum is wrong and says so.
  system.state.radius.assign(10, 1.6);
  EXPECT_GT(rough_sum(system).doubts, 0);
  EXPECT_GT(std::abs(rough_sum(system).total - packing_fraction(system, Outline::rough).total), 1e-3);
}

TEST(PackingFraction, TwoDiscs) {
  for (const double small : {1.0, 0.6}) {
    // Across both periods; the copies are cells apart.
    System<2> system = empty_cell(5, 7);
    add_outline(system, {{0.1, 7.05}}, 1);
    add_outline(system, {{-0.9 + 15, 0.05 - 14}}, small);
    const double loss = overlap_share(1, small, 1), loss_of_small = overlap_share(small, 1, 1);
    const double both = pi + pi * small * small - loss - loss_of_small;
    for (const Outline outline : {Outline::rough, Outline::smooth})
      EXPECT_NEAR(exact_area(system, outline), both, 1e-12);
    const RoughSum sum = rough_sum(system);
    EXPECT_NEAR(sum.total * 35, both, 1e-12);
    EXPECT_NEAR(sum.area[0], pi - loss, 1e-12);
    EXPECT_NEAR(sum.area[1], pi * small * small - loss_of_small, 1e-12);
    const std::vector<double> area = packing_fraction(system, Outline::rough).volume;
    EXPECT_NEAR(area[0], pi - 0.5 * (loss + loss_of_small), 1e-12);
    EXPECT_NEAR(area[1], pi * small * small - 0.5 * (loss + loss_of_small), 1e-12);
  }
}

TEST(PackingFraction, ImagesOfAShearedCell) {
  // A disc of diameter 1.2 in a cell of 1 x 2 overlaps its own images; the one above is displaced by the
  // strain.
  System<2> system = empty_cell(1, 1.1);
  add_outline(system, {{0.3, 0.4}}, 0.6);
  system.box.strain = 0.25;
  const auto lens = [](double d) { return 2 * overlap_share(0.6, 0.6, d); };
  const double shift = 0.25 * 1.1;
  const double free = pi * 0.36 - lens(1) - lens(std::hypot(1.1, shift)) - lens(std::hypot(1.1, 1 - shift));
  EXPECT_NEAR(rough_sum(system).total * 1.1, free, 1e-13);
  const double covered = exact_area(system, Outline::rough);
  const MonteCarloFraction mc = monte_carlo_fraction(system, Outline::rough, 1000000, 1);
  EXPECT_NEAR(covered / 1.1, mc.value, 4 * mc.error);
  // A whole cell of strain is none; without periods the disc is alone.
  system.box.strain += 1 / 1.1;
  EXPECT_NEAR(exact_area(system, Outline::rough), covered, 1e-13);
  system.box.periodic = {false, false};
  EXPECT_NEAR(exact_area(system, Outline::rough), pi * 0.36, 1e-13);
}

TEST(PackingFraction, BodiesThatFillTheCell) {
  // Flush squares, and their offsets that touch: outlines lie on each other.
  for (const double r : {0.0, 0.1}) {
    System<2> system = empty_cell(3, 2);
    for (int b = 0; b < 6; ++b) {
      const Vec2 x{0.7 + b % 3, 0.3 + b / 3};
      add_outline(system, {x + Vec2{r, r}, x + Vec2{1 - r, r}, x + Vec2{1 - r, 1 - r}, x + Vec2{r, 1 - r}},
                  r);
    }
    const PackingFraction fraction = packing_fraction(system, Outline::smooth);
    EXPECT_NEAR(fraction.total, 1 - (4 - pi) * r * r, 1e-11);
    for (const double area : fraction.volume) EXPECT_NEAR(area, 1 - (4 - pi) * r * r, 1e-11);
    EXPECT_NEAR(packing_fraction(system, Outline::rough).total, (1 - 2 * r) * (1 - 2 * r) + 3 * pi * r * r,
                1e-11);
  }
}

TEST(PackingFraction, WhatManyCoverIsShared) {
  // A big square and three inside it, two of which overlap.
  System<2> system = empty_cell(10, 10);
  const auto square = [&](double x, double y, double side) {
    add_outline(system, {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, 0);
  };
  square(1, 1, 8);
  square(2, 2, 2);
  square(3, 2.5, 2);
  square(6, 6, 1);
  const PackingFraction fraction = packing_fraction(system, Outline::smooth);
  EXPECT_NEAR(fraction.total, 0.64, 1e-13);
  const double both = 1 * 1.5;
  EXPECT_NEAR(fraction.volume[1], (4 - both) / 2 + both / 3, 1e-12);
  EXPECT_NEAR(fraction.volume[2], (4 - both) / 2 + both / 3, 1e-12);
  EXPECT_NEAR(fraction.volume[3], 0.5, 1e-12);
  expect_shares_add_up(system, fraction.volume, fraction.total);
}

TEST(PackingFraction, DoubtsOfTheSum) {
  System<2> system = empty_cell(12, 12);
  const Ring square = {{3, 3}, {6, 3}, {6, 6}, {3, 6}};
  add_outline(system, square, 0.5);
  add_outline(system, {{7, 3}, {9, 3}, {9, 5}, {7, 5}}, 0.51);  // two discs overlap by 0.01
  EXPECT_EQ(rough_sum(system).doubts, 0);
  EXPECT_NEAR(rough_sum(system).total, packing_fraction(system, Outline::rough).total, 1e-14);
  System<2> claw = empty_cell(12, 12);  // whose tips overlap, but no edge meets another
  add_outline(claw, {{1, 1}, {4, 1}, {2.8, 4}, {2.8, 2}, {2.2, 2}, {2.2, 4}}, 0.29);
  EXPECT_EQ(rough_sum(claw).doubts, 0);
  claw.state.position[2][0] -= 0.1;
  EXPECT_EQ(rough_sum(claw).doubts, 2);
  System<2> on_edge = system;
  add_outline(on_edge, {{4.5, 6.4}}, 0.45);
  EXPECT_EQ(rough_sum(on_edge).doubts, 1);
  System<2> triple = system;
  add_outline(triple, {{6.5, 3.2}}, 0.3);
  EXPECT_EQ(rough_sum(triple).doubts, 3);
  System<2> crossed = system;
  add_outline(crossed, {{4, 1}, {5, 1}, {5, 8}, {4, 8}}, 0.1);
  EXPECT_EQ(rough_sum(crossed).doubts, 4);  // two edges of each
  for (const System<2>& s : {claw, on_edge, triple, crossed})
    EXPECT_GT(std::abs(rough_sum(s).total - packing_fraction(s, Outline::rough).total), 1e-6);
}

TEST(PackingFraction, DoesNotDependOnPlaceOrCopies) {
  System<2> system = random_shapes(14, 3);
  const PackingFraction before = packing_fraction(system, Outline::smooth);
  expect_shares_add_up(system, before.volume, before.total);
  for (int b = 0; b < 14; ++b)
    for (int i = system.topology.begin[b]; i < system.topology.begin[b + 1]; ++i)
      system.state.position[i] += Vec2{1.2345 + 6 * (b % 3), -0.777 - 5 * (b % 5)};
  const PackingFraction after = packing_fraction(system, Outline::smooth);
  for (int b = 0; b < 14; ++b) EXPECT_NEAR(after.volume[b], before.volume[b], 1e-11);
}

TEST(PackingFraction, RefusesBodiesThatWouldFillMemoryWithTheirCopies) {
  for (const double radius : {1e3, 1e9, 1e300}) {
    System<2> system = empty_cell(2, 3);
    add_outline(system, {{1, 1}}, radius);
    for (const double strain : {0.0, 0.4}) {
      system.box.strain = strain;
      EXPECT_THROW(packing_fraction(system, Outline::rough), Error) << radius;
    }
  }
}

TEST(PackingFraction, RefusesBodiesWithoutArea) {
  System<2> system = empty_cell(9, 9);
  add_outline(system, {{1, 1}, {1, 2}, {2, 1}}, 0.1);  // clockwise
  EXPECT_THROW(packing_fraction(system, Outline::rough), Error);
  EXPECT_THROW(rough_sum(system), Error);
  EXPECT_THROW(monte_carlo_fraction(system, Outline::rough, 1, 1), Error);
  system = empty_cell(9, 9);
  add_outline(system, {{1, 1}, {1, 2}}, 0.1);
  EXPECT_THROW(packing_fraction(system, Outline::rough), Error);
  system = empty_cell(9, 9);
  add_outline(system, {{1, 1}, {2, 1}, {1, 2}}, 0.1);
  system.state.radius[1] = 0.2;
  EXPECT_NO_THROW(packing_fraction(system, Outline::rough));
  EXPECT_THROW(packing_fraction(system, Outline::smooth), Error);
  system.state.position[1] = system.state.position[2];
  EXPECT_THROW(rough_sum(system), Error);
  system.state.position[0][1] = std::nan("");
  EXPECT_THROW(packing_fraction(system, Outline::rough), Error);
}

}  // namespace
}  // namespace supple
