#include "supple/model/discs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "supple/core/error.hpp"

namespace supple {
namespace {

constexpr double pi = std::numbers::pi;

Box<2> cell(double width, double height) {
  Box<2> box;
  box.length = {width, height};
  return box;
}

double packing_fraction(const System<2>& system) {
  double area = 0;
  for (const double r : system.state.radius) area += pi * r * r;
  return area / system.box.volume();
}

TEST(Discs, ExactlyHalfAreLargeAndAnOddDiscIsLarge) {
  for (const int n : {1, 2, 7, 44, 45, 150}) {
    const DiscSpec spec{n, 1.5, 1.4, 1000};
    const System<2> system = random_discs(cell(500, 400), spec, 3);
    const auto& radius = system.state.radius;
    const double large = *std::max_element(radius.begin(), radius.end());
    EXPECT_EQ(std::count(radius.begin(), radius.end(), large), (n + 1) / 2) << n;
    EXPECT_EQ(std::count(radius.begin(), radius.end(), large / 1.4), n / 2) << n;
    EXPECT_NEAR(packing_fraction(system), 1.5, 1e-14) << n;
  }
}

TEST(Discs, LargeRadiusOfAnEvenNumberIsThePublishedOne) {  // S1-14
  const double expected = 500 * std::sqrt(1.5 / (150 * pi * (0.5 + 0.5 / (1.4 * 1.4))));
  const auto radius = bimodal_radii({150, 1.5, 1.4, 1}, 500 * 500, 1);
  EXPECT_NEAR(*std::max_element(radius.begin(), radius.end()), expected, 1e-13 * expected);
}

TEST(Discs, MassAndInertiaAreThoseOfACylinder) {
  const System<2> system = listed_discs(cell(10, 10), {{1, 2}}, {2}, 3);
  EXPECT_DOUBLE_EQ(system.state.mass[0], 3 * pi * 4);
  EXPECT_DOUBLE_EQ(system.state.inertia[0], 3 * pi * 4 * 4 / 2);
  EXPECT_EQ(system.state.velocity[0], (Vec2{0, 0}));
}

TEST(Discs, PositionsDoNotDependOnNumberOrSizes) {
  const System<2> few = random_discs(cell(500, 500), {20, 1.5, 1.4, 1000}, 7);
  const System<2> many = random_discs(cell(500, 500), {81, 0.9, 2.0, 50}, 7);
  const System<2> other_seed = random_discs(cell(500, 500), {20, 1.5, 1.4, 1000}, 8);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(few.state.position[i], many.state.position[i]);
    EXPECT_FALSE(few.state.position[i] == other_seed.state.position[i]);
    const bool large_of_few =
        few.state.radius[i] > 1.2 * *std::min_element(few.state.radius.begin(), few.state.radius.end());
    const bool large_of_many =
        many.state.radius[i] > 1.2 * *std::min_element(many.state.radius.begin(), many.state.radius.end());
    EXPECT_EQ(large_of_few, large_of_many);
  }
}

TEST(Discs, PositionsAreUniformAndSizesUncorrelatedWithIndex) {
  const int n = 20000;
  const System<2> system = random_discs(cell(2, 5), {n, 1, 1.4, 1}, 11);
  double mean_x = 0, mean_y = 0, square_y = 0;
  int large_first = 0;
  for (int i = 0; i < n; ++i) {
    const Vec2 x = system.state.position[i];
    ASSERT_TRUE(x[0] >= 0 && x[0] < 2 && x[1] >= 0 && x[1] < 5);
    mean_x += x[0] / 2 / n;
    mean_y += x[1] / 5 / n;
    square_y += x[1] * x[1] / 25 / n;
    if (i % 2 == 0 && system.state.radius[i] > system.state.radius[i + 1]) ++large_first;
  }
  const double sigma = std::sqrt(1.0 / 12 / n);
  EXPECT_NEAR(mean_x, 0.5, 5 * sigma);
  EXPECT_NEAR(mean_y, 0.5, 5 * sigma);
  EXPECT_NEAR(square_y, 1.0 / 3, 5 * sigma);
  EXPECT_NEAR(large_first / (n / 2.0), 0.5, 5 * std::sqrt(0.5 / n));
}

TEST(Discs, HexagonalLatticeHasSixNeighboursAtTheSpacing) {
  const System<2> system = hexagonal_discs(4, 4, 2.0, 1.0, 1.0);
  for (int i = 0; i < system.state.size(); ++i) {
    int neighbours = 0;
    for (int j = 0; j < system.state.size(); ++j) {
      const double d = norm(system.box.displacement(system.state.position[i], system.state.position[j]));
      if (i != j && d < 2.0 + 1e-9) ++neighbours;
      if (i != j) {
        EXPECT_GT(d, 2.0 - 1e-9);
      }
    }
    EXPECT_EQ(neighbours, 6) << i;
  }
  EXPECT_THROW(hexagonal_discs(4, 3, 2, 1, 1), Error);
}

TEST(Discs, BadNumbersAreInputErrors) {
  const Box<2> box = cell(1, 1);
  const auto message = [&](const DiscSpec& spec) -> std::string {
    try {
      random_discs(box, spec, 1);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message({0, 1.5, 1.4, 1}), "number of discs = 0 (out of range); give at least 1");
  EXPECT_NE(message({5, -1, 1.4, 1}).find("packing fraction = -1"), std::string::npos);
  EXPECT_NE(message({5, 1, 0.5, 1}).find("size ratio = 0.5"), std::string::npos);
  EXPECT_NE(message({5, 1, 1.4, 0}).find("density = 0"), std::string::npos);
  EXPECT_THROW(listed_discs(box, {{0, 0}}, {1, 1}, 1), Error);
}

}  // namespace
}  // namespace supple
