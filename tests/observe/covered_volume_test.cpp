/// How much of a cell bodies cover in 3D: closed forms, Monte Carlo, and errors that are what they say.
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/geometry/disc_overlap.hpp"
#include "supple/observe/packing_fraction.hpp"
#include "tests/support/surfaces.hpp"

namespace supple {
namespace {

using namespace testing;
using std::numbers::pi;

System<3> empty_cell(double length) {
  System<3> system;
  system.box.length = {length, length, length};
  return system;
}

double ball(double r) { return 4 * pi / 3 * r * r * r; }

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(CoveredVolume, OfSpheresIsExact) {
  for (const Outline outline : {Outline::rough, Outline::smooth}) {
    System<3> system = empty_cell(4);
    system.box.strain = 0.3;
    add_sphere_body(system, {0.1, 3.9, 0.2}, 1);  // across all periods
    PackingFraction f = packing_fraction(system, outline);
    EXPECT_NEAR(f.total * 64, ball(1), 1e-13);
    EXPECT_EQ(f.error, 0);
    add_sphere_body(system, {0.1 - 4 * 0.3, 3.9 - 4, 1.4}, 0.7);  // meets an image
    f = packing_fraction(system, outline);
    // Two caps, of heights h = (1 - x) and (0.7 - (1.2 - x)), x the distance of their plane.
    const double x = (1.2 * 1.2 + 1 - 0.49) / 2.4, h = 1 - x, k = 0.7 - 1.2 + x;
    const double lens = pi * h * h * (3 - h) / 3 + pi * k * k * (2.1 - k) / 3;
    EXPECT_NEAR(f.total * 64, ball(1) + ball(0.7) - lens, 1e-13);
    EXPECT_NEAR(f.volume[0], ball(1) - lens / 2, 1e-13);
    EXPECT_NEAR(f.volume[1], ball(0.7) - lens / 2, 1e-13);
    EXPECT_EQ(f.error, 0);
    EXPECT_EQ(f.volume_error[1], 0);
  }
  System<3> nested = empty_cell(9);
  add_sphere_body(nested, {4, 4, 4}, 2);
  add_sphere_body(nested, {4, 4.5, 4}, 1);
  EXPECT_NEAR(packing_fraction(nested, Outline::rough).total * 729, ball(2), 1e-12);
}

/// A simple cubic lattice of one sphere, larger than its cell: it overlaps 6 images, three with a common
/// point from r = 1/sqrt(2) on.
TEST(CoveredVolume, OfASphereThatMeetsItsImages) {
  System<3> system = empty_cell(1);
  const double r = 0.6, cap = 0.5 * sphere_overlap(r, r, 1);
  add_sphere_body(system, {0.2, 0.9, 0.4}, r);
  const PackingFraction f = packing_fraction(system, Outline::rough);
  EXPECT_NEAR(f.total, ball(r) - 6 * cap, 1e-14);
  EXPECT_EQ(f.error, 0);
  system.state.radius[0] = 0.8;
  const PackingFraction more = packing_fraction(system, Outline::rough);
  const MonteCarloFraction mc = monte_carlo_fraction(system, Outline::rough, 200000, 1);
  EXPECT_GT(more.error, 0);
  EXPECT_LT(more.error, 3e-4);
  EXPECT_NEAR(more.total, mc.value, 3 * std::hypot(mc.error, more.error));
  EXPECT_NEAR(more.volume[0], more.total, 1e-14);
  system.state.radius[0] = 0.87;  // sqrt(3)/2 = 0.866: everything is covered
  EXPECT_NEAR(packing_fraction(system, Outline::rough).total, 1, 1e-3);
}

TEST(CoveredVolume, OfThreeSpheresWithACommonPointIsShared) {
  System<3> system = empty_cell(10);
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * pi * k / 3;
    add_sphere_body(system, {5 + 0.5 * std::cos(angle), 5 + 0.5 * std::sin(angle), 5}, 1);
  }
  const PackingFraction f = packing_fraction(system, Outline::smooth);
  EXPECT_NEAR(sum(f.volume), f.total * 1000, 1e-12);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(f.volume[k], f.volume[(k + 1) % 3], 4 * std::hypot(f.volume_error[k], f.volume_error[2 - k]));
    EXPECT_GT(f.volume_error[k], 0);
    EXPECT_LT(f.volume_error[k], 1e-3);
  }
  const MonteCarloFraction mc = monte_carlo_fraction(system, Outline::rough, 1000000, 1);
  EXPECT_NEAR(f.total, mc.value, 3 * mc.error);
}

TEST(CoveredVolume, OfASmoothBoxIsExact) {
  System<3> system = empty_cell(9);
  system.box.periodic = {true, false, true};
  const double r = 0.3, exact = 6 + 22 * r + pi * 6 * r * r + ball(r);
  RandomStream draw(3, Purpose::test);
  add_mesh(system, turned(box_mesh({1, 2, 3}), draw), r, {8.5, -1, 8});  // beyond the wall, which counts
  const PackingFraction f = packing_fraction(system, Outline::smooth);
  EXPECT_NEAR(f.total * 729, exact, 1e-12);
  EXPECT_EQ(f.error, 0);
}

/// Spheres about the corners of a box, of which an eighth lies in it.
TEST(CoveredVolume, OfARoughBox) {
  System<3> system = empty_cell(9);
  add_mesh(system, box_mesh({1, 2, 3}), 0.4, {8.5, 7, 1});
  const PackingFraction f = packing_fraction(system, Outline::rough);
  const double exact = 6 + 7 * ball(0.4);
  EXPECT_NEAR(f.volume[0], exact, 4 * f.volume_error[0]);
  EXPECT_LT(f.volume_error[0], 3e-4 * exact);
  EXPECT_NEAR(f.volume_error[0], f.error * 729, 1e-15);
}

/// Squared deviations in standard errors, of the total from Monte Carlo.
struct Deviations {
  double value = 0, scaled = 0;
  int cases = 0;

  void add(const PackingFraction& f, const MonteCarloFraction& mc) {
    const double error = std::hypot(f.error, mc.error);
    value += std::pow((f.total - mc.value) / error, 2);
    scaled += std::pow((1.005 * f.total - mc.value) / error, 2);
    ++cases;
  }
  void expect_agreement() const {
    const double limit = cases + 4 * std::sqrt(2.0 * cases);
    EXPECT_LT(value, limit);
    EXPECT_GT(scaled, limit) << "an error of 0.5 % would not be noticed";
  }
};

TEST(CoveredVolume, AgreesWithMonteCarlo) {
  Deviations deviations;
  for (int k = 0; k < 6; ++k) {
    System<3> system = random_surfaces(k == 5 ? 3 : 6 + 2 * k, k == 5 ? 2.3 : 6, 10 + k);
    system.box.strain = 0.3 * k;
    system.box.periodic = {k != 2 && k != 3, k != 3 && k != 4, k != 1 && k != 3};
    for (const Outline outline : {Outline::rough, Outline::smooth}) {
      const PackingFraction f = packing_fraction(system, outline);
      EXPECT_LT(f.error, 3e-4 * f.total);
      EXPECT_NEAR(sum(f.volume), f.total * system.box.volume(), 1e-12);
      deviations.add(f, monte_carlo_fraction(system, outline, 150000, k));
    }
  }
  deviations.expect_agreement();
}

TEST(CoveredVolume, OfOneRoughSphereOfTrianglesAgreesWithMonteCarlo) {
  Deviations deviations;
  for (const int vertices : {12, 42}) {
    System<3> system = empty_cell(1.7);
    const TriangleMesh mesh = geodesic_icosahedron(vertices, 1);
    add_mesh(system, mesh, 0.5 * mean_edge(mesh), {1.6, 0.3, 1});
    deviations.add(packing_fraction(system, Outline::rough),
                   monte_carlo_fraction(system, Outline::rough, 400000, 7));
  }
  deviations.expect_agreement();
}

/// The errors of totals of many seeds are as large as they say. An error of 8 shifts and several bodies is
/// known to some percent.
TEST(CoveredVolume, HasTheErrorsThatItSays) {
  System<3> system = random_surfaces(8, 4, 3, 0.2);
  PackingFraction best = packing_fraction(system, Outline::rough, {.relative_error = 2e-5, .seed = 1000});
  double squares = 0, of_bodies = 0;
  constexpr int runs = 60;
  for (int seed = 0; seed < runs; ++seed) {
    const PackingFraction f = packing_fraction(
        system, Outline::rough, {.relative_error = 1e-3, .seed = static_cast<std::uint64_t>(seed)});
    squares += std::pow((f.total - best.total) / f.error, 2) / runs;
    for (int b = 0; b < 8; ++b)
      of_bodies += std::pow((f.volume[b] - best.volume[b]) / f.volume_error[b], 2) / (8 * runs);
  }
  EXPECT_NEAR(squares, 1, 4 * std::sqrt(2.0 / runs));
  EXPECT_GT(of_bodies, 0.7);  // Student's distribution of 7 degrees of freedom and more: 7/5 at most
  EXPECT_LT(of_bodies, 2);
}

TEST(CoveredVolume, DoesNotDependOnThreads) {
  const System<3> system = random_surfaces(6, 4, 1);
  const PackingFraction one = packing_fraction(system, Outline::smooth);
  const double sampled = monte_carlo_fraction(system, Outline::smooth, 100001, 4).value;
  for (const int threads : {2, 3}) {
    const WithThreads with(threads);
    const PackingFraction more = packing_fraction(system, Outline::smooth);
    EXPECT_EQ(more.volume, one.volume);
    EXPECT_EQ(more.error, one.error);
    EXPECT_EQ(monte_carlo_fraction(system, Outline::smooth, 100001, 4).value, sampled);
  }
  EXPECT_NE(packing_fraction(system, Outline::smooth, {.seed = 2}).total, one.total);
}

TEST(CoveredVolume, RefusesBodiesWithoutVolume) {
  System<3> system = empty_cell(9);
  add_mesh(system, geodesic_icosahedron(12), 0.3);
  EXPECT_THROW(packing_fraction(system, Outline::rough, {.relative_error = 0}), Error);
  EXPECT_THROW(packing_fraction(system, Outline::rough, {.most_lines = 0}), Error);
  System<3> broken = system;
  for (auto& face : broken.topology.facet) std::swap(face[0], face[1]);
  EXPECT_THROW(packing_fraction(broken, Outline::rough), Error);
  broken = system;
  broken.state.radius[3] = 0.2;
  EXPECT_THROW(packing_fraction(broken, Outline::smooth), Error);
  EXPECT_NO_THROW(packing_fraction(broken, Outline::rough));
  broken.state.position[2][1] = NAN;
  EXPECT_THROW(packing_fraction(broken, Outline::rough), Error);
}

}  // namespace
}  // namespace supple
