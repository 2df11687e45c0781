#include "supple/contact/laws/tabulated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "supple/contact/laws/elastic.hpp"
#include "supple/core/error.hpp"

namespace supple {
namespace {

double capped(double d, double d0, double k, double c) { return Divergent(c).force(d, d0, k); }

TEST(Tabulated, FollowsTheLawWithinItsStatedErrorAndItsEnergyIsTheIntegral) {
  const Tabulated table(capped, 1, "law");
  const Divergent exact(1);
  EXPECT_LT(table.error_bound(), 1e-3);  // the cap is a kink
  for (double d = 0.004; d < 1.3; d += 0.00137) {
    const double f = exact.force(d, 1.3, 2.0);
    EXPECT_NEAR(table.force(d, 1.3, 2.0), f, 1.0001 * table.error_bound() * std::max(2.6, f)) << d;
    const double h = 1e-6;
    const double slope = (table.energy(d + h, 1.3, 2) - table.energy(d - h, 1.3, 2)) / (2 * h);
    EXPECT_NEAR(-slope, table.force(d, 1.3, 2), 1e-6 * (1 + f)) << d;
  }
}

TEST(Tabulated, SmoothLawsReachTheGoalOfTheTable) {
  const Tabulated hertz(
      [](double d, double d0, double k, double) { return k * std::pow(d0 - d, 2.5) / std::pow(d0, 1.5); }, 0,
      "law");
  EXPECT_LT(hertz.error_bound(), 1e-8);
  EXPECT_NEAR(hertz.force(0.7, 1, 10), 10 * std::pow(0.3, 2.5), 1e-7);
  EXPECT_NEAR(hertz.energy(0.7, 1, 10), 10 * std::pow(0.3, 3.5) / 3.5, 1e-7);
  EXPECT_EQ(hertz.energy(1, 1, 10), 0);
}

std::string problem_of(const RepulsionFunction& law) {
  try {
    Tabulated(law, 1, "law");
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "none";
}

TEST(Tabulated, RefusesLawsThatAreNotRepulsionLaws) {
  using testing::AssertionFailure;
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? testing::AssertionSuccess() : AssertionFailure() << text;
  };
  EXPECT_TRUE(contains(
      problem_of([](double d, double d0, double k, double) { return k * (d0 - d) * d0 * d0 / (d * d); }),
      "diverges"));
  EXPECT_TRUE(
      contains(problem_of([](double d, double d0, double k, double) { return k * (d - d0); }), "attracts"));
  EXPECT_TRUE(contains(problem_of([](double, double d0, double k, double) { return k * d0; }), "at contact"));
  EXPECT_TRUE(contains(problem_of([](double d, double d0, double k, double) {
                         return k * d0 * std::pow(d / d0 - 0.4, 1.5) * (1 - d / d0);
                       }),
                       "not finite"));
  EXPECT_TRUE(
      contains(problem_of([](double d, double d0, double, double) { return d0 - d; }), "proportional to k"));
  EXPECT_TRUE(
      contains(problem_of([](double d, double d0, double k, double) { return k * (d0 - d) * (d0 - d); }),
               "length of its own"));
}

}  // namespace
}  // namespace supple
