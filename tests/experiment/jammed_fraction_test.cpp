/// Packing fractions of jammed packings by formula against Monte Carlo, over all families.
#include <gtest/gtest.h>

#include <cmath>

#include "supple/experiment/jam.hpp"
#include "supple/observe/packing_fraction.hpp"

namespace supple {
namespace {

struct Kind {
  const char *family, *contact;
  double shape_parameter = 0, diameter_ratio = 1;
};

constexpr Kind kinds[]{{"shell", "rough"},       {"shell", "smooth"},
                       {"floppy", "rough", 1.1}, {"floppy", "smooth", 1.2},
                       {"droplet", "rough"},     {"droplet", "smooth"},
                       {"disc", "rough"},        {"rough_disc", "rough"},
                       {"shell", "rough", 0, 2}, {"rough_disc", "rough", 0, 0.5}};

Packing<2> jammed(const Kind& kind, int seed) {
  Case c;
  c.general.experiment = "jamming";
  c.general.seed = seed;
  c.bodies.family = kind.family;
  c.bodies.count = 9;
  c.bodies.vertices = 9;
  c.bodies.shape_parameter = kind.shape_parameter;
  c.bodies.diameter_ratio = kind.diameter_ratio;
  c.contact.kind = kind.contact;
  c.contact.unsound =
      "mark";  // fractions of particles whose vertices have passed each other are looked at too
  c.jamming.packing_fraction = 0.4;
  c.jamming.step = 0.01;
  c.jamming.pressure = 1e-3;
  c.jamming.window = 0.1;
  c.minimise.force_tolerance = 1e-3;
  resolve_family(c);
  Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
  jam(packing, jam_spec(c));
  return packing;
}

/// Probability that a chi-squared of 2 m degrees of freedom is larger: the regularised gamma function Q(m,
/// x/2), for an integer m a finite sum.
double survival(double chi_squared, int m) {
  double term = std::exp(-0.5 * chi_squared), sum = 0;
  for (int k = 0; k < m; ++k) {
    sum += term;
    term *= 0.5 * chi_squared / (k + 1);
  }
  return sum;
}

TEST(JammedFraction, SurvivalIsThatOfTables) {
  EXPECT_NEAR(survival(31.410, 10), 0.05, 1e-5);
  EXPECT_NEAR(survival(45.315, 10), 0.001, 1e-6);
}

#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr std::int64_t points = 1'000'000;
#else
constexpr std::int64_t points = 5'000'000;  // 1e8 in all
#endif

TEST(JammedFraction, AgreesWithMonteCarloOver20Packings) {
  double right = 0, too_large = 0, too_small = 0;
  int packings = 0, sums = 0;
  for (const Kind& kind : kinds)
    for (const int seed : {1, 2}) {
      const Packing<2> p = jammed(kind, seed);
      const double exact = packing_fraction(p.system, p.outline).total;
      const MonteCarloFraction mc =
          monte_carlo_fraction(p.system, p.outline, points, static_cast<std::uint64_t>(++packings));
      const auto square = [&](double fraction) { return std::pow((fraction - mc.value) / mc.error, 2); };
      right += square(exact);
      too_large += square(1.001 * exact);
      too_small += square(0.999 * exact);
      EXPECT_GT(exact, 0.5);
      EXPECT_LT(exact, 1);
      if (p.outline != Outline::rough) continue;
      const RoughSum sum = rough_sum(p.system);
      if (sum.doubts > 0) continue;
      ++sums;
      EXPECT_NEAR(sum.total, exact, 1e-10);
    }
  ASSERT_EQ(packings, 20);
  EXPECT_GT(sums, 3);  // the published sum (9.18-9.22) holds in some of them
  EXPECT_GT(survival(right, 10), 0.001) << "chi-squared " << right;
  EXPECT_LT(survival(right, 10), 0.999) << "chi-squared " << right;
  EXPECT_LT(survival(too_large, 10), 1e-6);
  EXPECT_LT(survival(too_small, 10), 1e-6);
}

}  // namespace
}  // namespace supple
