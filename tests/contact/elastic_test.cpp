/// Elastic laws: the force is minus the slope of the energy, continuous, and what the formulas say.
#include "supple/contact/laws/elastic.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "supple/contact/laws/list.hpp"

namespace supple {
namespace {

constexpr double k = 3, d0 = 2;

struct Law {
  std::string name;
  std::function<double(double)> force, energy;
  double low, high;                ///< distances over which it acts, as shares of d0
  std::vector<double> kinks = {};  ///< where the slope of the force jumps, as shares of d0
  double ends = 1;                 ///< where force and energy vanish, as a share of d0
  double least = 0;                ///< energy
  std::function<double(double)> stiffness = {};
};

template <class L>
Law law(const std::string& name, const L& l, double low, double high, std::vector<double> kinks = {}) {
  Law all{name,
          [l](double d) { return l.force(d, d0, k); },
          [l](double d) { return l.energy(d, d0, k); },
          low,
          high,
          kinks,
          range_of(l)};
  if (all.ends > 1) all.least = l.energy(d0, d0, k);  // the bottom of its well
  if constexpr (requires { l.stiffness(d0, d0, k); })
    all.stiffness = [l](double d) { return l.stiffness(d, d0, k); };
  return all;
}

/// Every repulsion in Repulsion, and every tension.
std::vector<Law> every_law() {
  const Tabulated formula(
      [](double d, double r, double stiffness, double) { return stiffness * (r - d) * (r - d) / r; }, 1,
      "k (d0 - d)^2 / d0");
  static_assert(std::variant_size_v<Repulsion> == 6, "add the new law to this list");
  return {law("divergent, c = 1", Divergent(1), 1e-4, 1, {1 / 1001.0}),
          law("divergent, c = 0.4", Divergent(0.4), 1e-4, 1, {0.0004}),
          law("linear", Linear(), 1e-4, 1),
          law("divergent, c = 0", Divergent(0), 1e-4, 1),
          law("adhesive", Adhesive(0.3), 1e-4, 1.3, {1.15}),
          law("hertz", Hertz(), 1e-4, 1),
          law("plateau", Plateau(1, 0.3, 0.8, 0.1), 1e-3, 1, {0.3, 0.8}),
          law("linear plateau", Plateau(0, 0.4, 0.7, 0.3), 1e-3, 1, {0.4, 0.7}),
          law("formula", formula, 1e-3, 1),
          law("linear tension", Tensile(Tensile::Kind::linear), 1, 3),
          law("exponential tension", Tensile(Tensile::Kind::exponential), 1, 3),
          law("saturating tension", Tensile(Tensile::Kind::saturating), 1, 3)};
}

bool near_a_kink(const Law& l, double x, double width) {
  for (const double kink : l.kinks)
    if (std::abs(x - kink) < width) return true;
  return false;
}

TEST(ElasticLaw, ForceIsMinusTheSlopeOfTheEnergy) {
  for (const Law& l : every_law())
    for (int i = 1; i < 400; ++i) {
      const double d = d0 * l.low * std::pow(l.high / l.low, i / 400.0), h = 1e-4 * d;
      if (near_a_kink(l, d / d0, 3e-4 * d / d0)) continue;
      // Of fourth order: the steep laws curve much over h.
      const double slope =
          (8 * (l.energy(d + h) - l.energy(d - h)) - (l.energy(d + 2 * h) - l.energy(d - 2 * h))) / (12 * h);
      // Energies cancel to rounding in the difference.
      const double tolerance = 1e-7 * std::abs(slope) + 1e-15 * std::abs(l.energy(d)) / h + 1e-10 * k * d0;
      EXPECT_NEAR(l.force(d), -slope, tolerance) << l.name << " at d/d0 = " << d / d0;
    }
}

TEST(ElasticLaw, StiffnessIsMinusTheSlopeOfTheForce) {
  int laws = 0;
  for (const Law& l : every_law()) {
    if (!l.stiffness) continue;
    ++laws;
    for (int i = 1; i < 400; ++i) {
      const double d = d0 * l.low * std::pow(l.high / l.low, i / 400.0), h = 1e-5 * d;
      if (near_a_kink(l, d / d0, 3e-5 * d / d0)) continue;
      const double slope = (l.force(d + h) - l.force(d - h)) / (2 * h);
      // A law by points is a spline: its slope has the error of its cubics.
      EXPECT_NEAR(l.stiffness(d), -slope,
                  1e-5 * std::abs(slope) + 1e-14 * std::abs(l.force(d)) / h + 1e-8 * k)
          << l.name << " at d/d0 = " << d / d0;
    }
  }
  EXPECT_EQ(laws, 9);
}

TEST(ElasticLaw, ForceAndEnergyVanishWhereTheyEnd) {
  for (const Law& l : every_law()) {
    EXPECT_NEAR(l.force(d0 * l.ends), 0, 1e-13) << l.name;
    EXPECT_NEAR(l.energy(d0 * l.ends), 0, 1e-13) << l.name;
    EXPECT_NEAR(l.force(d0), 0, 1e-13) << l.name;
  }
}

TEST(ElasticLaw, ForceIsContinuousAndPushesTowardsContact) {
  for (const Law& l : every_law()) {
    std::vector<double> places = l.kinks;
    for (int i = 1; i < 400; ++i) places.push_back(l.low + (l.high - l.low) * i / 400.0);
    for (const double x : places) {
      const double below = l.force(d0 * x * (1 - 1e-9)), above = l.force(d0 * x * (1 + 1e-9));
      EXPECT_NEAR(below, above, 1e-7 * (std::abs(above) + k * d0)) << l.name << " at d/d0 = " << x;
      EXPECT_EQ(above >= 0, x < 1) << l.name << " at d/d0 = " << x;
      EXPECT_GE(l.energy(d0 * x), l.least) << l.name << " at d/d0 = " << x;
    }
  }
}

TEST(ElasticLaw, DivergentIsLinearToDivergentAndCapped) {
  // S1-5a and S1-5b at d = d0/2; S1-6 at the centre.
  EXPECT_DOUBLE_EQ(Divergent(0).force(1, 2, k), k);
  EXPECT_DOUBLE_EQ(Divergent(1).force(1, 2, k), 2 * k);
  EXPECT_DOUBLE_EQ(Divergent(0.25).force(1, 2, k), 1.25 * k);
  EXPECT_DOUBLE_EQ(Divergent(1).force(0, 2, k), 1000 * k * 2);
  EXPECT_DOUBLE_EQ(Divergent(1).force(2 / 1001.1, 2, k), 1000 * k * 2);
  EXPECT_LT(Divergent(1).force(2 / 1000.5, 2, k), 1000 * k * 2);
  EXPECT_DOUBLE_EQ(Divergent(0).force(0, 2, k), k * 2);
}

TEST(ElasticLaw, HertzIsThatOfTheDocumentation) {
  // S1-13: 1.09 E R^(-1/2) delta^1.5 with E = 8 kPa (k = pi E/8), R = 10 um, delta = 2 um.
  const double stiffness = 3.141592653589793 / 8 * 8000, radius = 10e-6, delta = 2e-6;
  EXPECT_NEAR(Hertz().force(2 * radius - delta, 2 * radius, stiffness) /
                  (8000 / std::sqrt(radius) * std::pow(delta, 1.5)),
              1.0921, 1e-4);
}

TEST(ElasticLaw, PlateauMapsTheDistance) {
  const Plateau plateau(1, 0.3, 0.8, 0.1);
  EXPECT_DOUBLE_EQ(plateau.force(0.9 * d0, d0, k), Divergent(1).force(0.9 * d0, d0, k));
  EXPECT_NEAR(plateau.force(0.5 * d0, d0, k), Divergent(1).force(0.77 * d0, d0, k), 1e-12);
  EXPECT_NEAR(plateau.force(0.15 * d0, d0, k), Divergent(1).force(0.375 * d0, d0, k), 1e-12);
}

TEST(ElasticLaw, TensionsStartWithTheSameStiffness) {
  for (const auto kind : {Tensile::Kind::linear, Tensile::Kind::exponential, Tensile::Kind::saturating})
    EXPECT_NEAR(Tensile(kind).force(d0 + 1e-7, d0, k) / -1e-7, k, 1e-5 * k);
  const double stretched = 1.4 * d0, linear = Tensile().force(stretched, d0, k);
  EXPECT_DOUBLE_EQ(linear, -0.4 * k * d0);
  EXPECT_LT(Tensile(Tensile::Kind::exponential).force(stretched, d0, k), linear);
  EXPECT_NEAR(Tensile(Tensile::Kind::saturating).force(stretched, d0, k),
              -0.2 * k * d0 * (1 - std::exp(-2.0)), 1e-14);
}

}  // namespace
}  // namespace supple
