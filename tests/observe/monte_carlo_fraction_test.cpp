#include <gtest/gtest.h>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/geometry/inside.hpp"
#include "supple/geometry/polygon.hpp"
#include "supple/observe/packing_fraction.hpp"
#include "tests/support/shapes.hpp"

namespace supple {
namespace {

using namespace testing;

/// Sum of squared deviations, in standard errors, of fractions from Monte Carlo; `scale` multiplies the
/// fractions.
struct ChiSquared {
  double value = 0, scaled = 0;
  int cases = 0;

  void add(double fraction, const MonteCarloFraction& mc) {
    const auto square = [](double z) { return z * z; };
    value += square((fraction - mc.value) / mc.error);
    scaled += square((1.001 * fraction - mc.value) / mc.error);
    ++cases;
  }
  /// Four standard deviations of chi-squared; fails also if a fraction wrong by 0.1 % were not noticed.
  void expect_agreement() const {
    const double limit = cases + 4 * std::sqrt(2.0 * cases);
    EXPECT_LT(value, limit);
    EXPECT_GT(scaled, limit);
  }
};

TEST(MonteCarloFraction, AgreesWithTheExactFractionOfAnyShapes) {
  ChiSquared chi;
  for (int k = 0; k < 6; ++k) {
    System<2> system = random_shapes(k == 5 ? 3 : 14 + 4 * k, 10 + k);
    system.box.strain = 0.3 * k;
    system.box.periodic = {k != 2 && k != 3, k != 3 && k != 4};
    if (k == 5) system.box.length = {1.7, 1.9};  // bodies overlap their own images
    for (const Outline outline : {Outline::rough, Outline::smooth})
      chi.add(packing_fraction(system, outline).total, monte_carlo_fraction(system, outline, 1500000, k));
  }
  chi.expect_agreement();
}

/// Regular polygons on a triangular lattice, turned at random, of two sizes of sites, vertices overlapping a
/// little.
System<2> touching_polygons(int columns, int rows, int vertices, double overlap, std::uint64_t seed) {
  const double height = std::sqrt(0.75);
  System<2> system = empty_cell(columns, rows * height);
  for (int b = 0; b < columns * rows; ++b) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(b));
    const int row = b / columns;
    const double radius = b % 2 ? 0.09 : 0.07;
    const Vec2 centre{b % columns + 0.5 * (row % 2), row * height};
    add_outline(system, regular_polygon(vertices, 0.5 * (1 + overlap) - radius, centre, draw.uniform(0, 7)),
                radius);
  }
  return system;
}

TEST(MonteCarloFraction, AgreesWithThePublishedSumOfSlightOverlaps) {
  ChiSquared chi;
  for (const int vertices : {5, 8, 11, 14}) {
    const System<2> system = touching_polygons(6, 6, vertices, 0.02, vertices);
    const RoughSum sum = rough_sum(system);
    const PackingFraction exact = packing_fraction(system, Outline::rough);
    EXPECT_EQ(sum.doubts, 0);
    EXPECT_NEAR(sum.total, exact.total, 1e-10);
    double alone = 0;
    for (const double area : sum.area) alone += area;
    EXPECT_NEAR(alone / system.box.volume(), sum.total, 1e-14);
    EXPECT_GT(sum.pairs, 1e-4);
    chi.add(sum.total, monte_carlo_fraction(system, Outline::rough, 3000000, 5));
  }
  chi.expect_agreement();
}

/// Points of the same streams that lie within any copy of a body, with no raster in between.
std::int64_t hits_one_by_one(const System<2>& system, Outline outline, std::int64_t points,
                             std::uint64_t seed) {
  std::int64_t hits = 0;
  const auto covered = [&](const Vec2& x) {
    for (int b = 0; b < system.topology.body_count(0); ++b) {
      const int first = system.topology.begin[b], n = system.topology.begin[b + 1] - first;
      for (double shift_x : {-1, 0, 1})
        for (double shift_y : {-1, 0, 1}) {
          Ring ring(system.state.position.begin() + first, system.state.position.begin() + first + n);
          for (Vec2& y : ring) y += Vec2{shift_x * system.box.length[0], shift_y * system.box.length[1]};
          if (n > 2 && is_inside(x, ring)) return true;
          for (int k = 0; k < n; ++k) {
            const Vec2 end = outline == Outline::smooth ? ring[(k + 1) % n] : ring[k];
            if (distance_to_segment(x, ring[k], end) < system.state.radius[first]) return true;
          }
        }
    }
    return false;
  };
  for (std::int64_t p = 0; p < points; p += 1024) {
    RandomStream draw(seed, Purpose::area_sample, static_cast<std::uint64_t>(p / 1024));
    for (std::int64_t k = p; k < std::min(points, p + 1024); ++k) {
      const double x = draw.uniform(0, system.box.length[0]);
      hits += covered({x, draw.uniform(0, system.box.length[1])});
    }
  }
  return hits;
}

TEST(MonteCarloFraction, CountsWhatItWouldWithoutTheRaster) {
  System<2> system = empty_cell(7, 6);
  add_outline(system, star(5, 2, 0.8, {1, 1}, 0.1), 0.17);
  add_outline(system, regular_polygon(7, 1, {5.9, 4}), 0.3);
  add_outline(system, {{3, 4.4}}, 0.6);
  for (const Outline outline : {Outline::rough, Outline::smooth})
    for (const std::int64_t points : {1, 700, 20000, 80000})
      EXPECT_NEAR(monte_carlo_fraction(system, outline, points, 9).value * static_cast<double>(points),
                  static_cast<double>(hits_one_by_one(system, outline, points, 9)), 1e-6);
}

TEST(MonteCarloFraction, HasTheErrorThatItSays) {
  System<2> system = empty_cell(2, 2);
  add_outline(system, {{0.3, 1.9}}, 0.7);
  const double fraction = std::numbers::pi * 0.49 / 4;
  double squares = 0;
  constexpr int runs = 200;
  for (int seed = 0; seed < runs; ++seed) {
    const MonteCarloFraction mc =
        monte_carlo_fraction(system, Outline::rough, 3000, static_cast<std::uint64_t>(seed));
    EXPECT_EQ(mc.points, 3000);
    EXPECT_NEAR(mc.error, std::sqrt(fraction * (1 - fraction) / 3000), 0.02 * mc.error);
    squares += (mc.value - fraction) * (mc.value - fraction) / (mc.error * mc.error);
  }
  EXPECT_NEAR(squares / runs, 1, 4 * std::sqrt(2.0 / runs));
}

TEST(MonteCarloFraction, DoesNotDependOnThreads) {
  const System<2> system = random_shapes(20, 1);
  const double one = monte_carlo_fraction(system, Outline::smooth, 3000001, 4).value;
  for (const int threads : {2, 3}) {
    thread_count() = threads;
    EXPECT_EQ(monte_carlo_fraction(system, Outline::smooth, 3000001, 4).value, one);
  }
  thread_count() = 1;
  EXPECT_NE(monte_carlo_fraction(system, Outline::smooth, 3000001, 5).value, one);
}

TEST(MonteCarloFraction, CountsWhatReachesBeyondAPlate) {
  System<2> system = empty_cell(2, 2);
  system.box.periodic = {true, false};
  add_outline(system, {{1.9, 0.0}}, 0.5);
  const MonteCarloFraction mc = monte_carlo_fraction(system, Outline::rough, 100000, 1);
  EXPECT_NEAR(mc.value, std::numbers::pi * 0.25 / 4, 4 * mc.error);
  EXPECT_THROW(monte_carlo_fraction(system, Outline::rough, 0, 1), Error);
}

}  // namespace
}  // namespace supple
