#include "supple/force/polygon_shape.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "supple/core/random.hpp"
#include "supple/force/shape_terms.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

Evaluation<2> evaluate(const TermSet<2>& terms, const System<2>& system, Detail detail = Detail::energies) {
  Evaluation<2> out;
  out.force.resize(system.state.size());
  terms.evaluate(system, detail, out);
  return out;
}

TermSet<2> fast_terms() {
  TermSet<2> terms;
  terms.add(std::make_shared<PolygonShape>());
  return terms;
}

void expect_same(const Evaluation<2>& a, const Evaluation<2>& b) {
  EXPECT_NEAR(a.energy.terms, b.energy.terms, 1e-13 * std::abs(b.energy.terms));
  double scale = 0;
  for (const Vec2& f : b.force) scale = std::max(scale, norm(f));
  ASSERT_GT(scale, 0);
  for (std::size_t i = 0; i < a.force.size(); ++i)
    EXPECT_LT(norm(a.force[i] - b.force[i]), 1e-12 * scale) << "site " << i;
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(a.virial[c][d], b.virial[c][d], 1e-11 * scale) << c << d;
}

TEST(PolygonShape, EqualsTheTermsItStandsFor) {
  System<2> system = testing::random_polygons({.bodies = 40});  // several groups of rings
  add_disc_body(system, {1, 1}, 0.5);
  expect_same(evaluate(fast_terms(), system), evaluate(shape_terms(system), system));
  for (ShapeStiffness& k : system.shape.stiffness) k.hinge = 0;  // floppy: no angles
  expect_same(evaluate(fast_terms(), system), evaluate(shape_terms(system), system));
}

/// Rings of all sizes round those of the loops, with sharp and reflex corners, a small one last, far from the
/// origin.
TEST(PolygonShape, EqualsTheTermsForRingsOfAnySize) {
  System<2> system;
  system.box.length = {20, 20};
  RandomStream draw(5, Purpose::test);
  for (const int n : {3, 7, 8, 9, 15, 16, 17, 22, 23, 24, 25, 6, 5, 4, 3}) {
    add_polygon(system, {100.0 * n, -50.0}, 1.5, n, 0.1, 1, {.bending = 0.3, .tension = 0.1});
    for (std::size_t i = system.state.position.size() - n; i < system.state.position.size(); ++i)
      system.state.position[i] += Vec2{draw.uniform(-0.2, 0.2), draw.uniform(-0.2, 0.2)};
  }
  expect_same(evaluate(fast_terms(), system), evaluate(shape_terms(system), system));
}

/// Second derivatives by any two sites, all parts multiplied out.
std::map<std::pair<int, int>, Mat2> multiplied_out(const HessianBlocks<2>& blocks,
                                                   const OuterProducts<2>& products = {}) {
  std::map<std::pair<int, int>, Mat2> all;
  for (const HessianBlock<2>& b : blocks) all[{b.a, b.b}] += b.h;
  for (const OuterProduct<2>& p : products)
    for (std::size_t i = 0; i < p.slope.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        all[{p.first + static_cast<int>(i), p.first + static_cast<int>(j)}].add_outer(p.factor, p.slope[i],
                                                                                      p.slope[j]);
  return all;
}

/// In n numbers a ring: with n^2, a million vertices in bodies of 900 would need 80 GB.
TEST(PolygonShape, SecondDerivativesAreTheSameAsBandsAndOuterProducts) {
  for (const double bending : {0.0, 0.3}) {
    System<2> system;
    system.box.length = {50, 50};
    RandomStream draw(5, Purpose::test);
    std::size_t blocks_in_all = 0, slopes = 0;
    for (const int n : {3, 4, 5, 6, 40}) {
      add_polygon(system, {5.0 * n, 0}, 1.5, n, 0.1, 1, {.bending = bending, .tension = 0.1});
      blocks_in_all += static_cast<std::size_t>(n < 5 ? n * (n + 1) / 2 : 3 * n);
      slopes += static_cast<std::size_t>(n < 5 ? 0 : n);
    }
    for (Vec2& x : system.state.position) x += Vec2{draw.uniform(-0.05, 0.05), draw.uniform(-0.05, 0.05)};
    HessianBlocks<2> whole, blocks;
    OuterProducts<2> products;
    fast_terms().add_hessian(system, whole);
    fast_terms().add_joining_hessian(system, blocks);
    EXPECT_TRUE(blocks.empty());
    for (int b = 0; b < 5; ++b) fast_terms().add_body_hessian(system, b, blocks, products);
    EXPECT_EQ(blocks.size(), blocks_in_all);
    for (const OuterProduct<2>& p : products) slopes -= p.slope.size();
    EXPECT_EQ(slopes, 0u);
    const auto split = multiplied_out(blocks, products);
    for (const auto& [sites, h] : multiplied_out(whole)) {
      const auto at = split.find(sites);
      ASSERT_NE(at, split.end());
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d) EXPECT_NEAR(at->second[c][d], h[c][d], 1e-12);
    }
  }
}

TEST(PolygonShape, HasTheSameForcesWithAndWithoutEnergies) {
  const System<2> system = testing::random_polygons();
  EXPECT_EQ(evaluate(fast_terms(), system, Detail::forces).force, evaluate(fast_terms(), system).force);
}

TEST(PolygonShape, UniformRestAnglesDropOut) {
  System<2> system = testing::random_polygons();
  const Evaluation<2> before = evaluate(fast_terms(), system);
  for (int b = 0; b < 9; ++b)
    for (int h = system.topology.hinge_begin[b]; h < system.topology.hinge_begin[b + 1]; ++h)
      system.shape.rest_hinge[h] = 0;
  const Evaluation<2> after = evaluate(fast_terms(), system);
  for (std::size_t i = 0; i < before.force.size(); ++i)
    EXPECT_LT(norm(before.force[i] - after.force[i]), 1e-13);
  EXPECT_GT(std::abs(before.energy.terms - after.energy.terms), 1);
}

TEST(PolygonShape, IsAtRestInItsPreferredShape) {
  System<2> system;
  system.box.length = {10, 10};
  add_polygon(system, {5, 5}, 2, 11, 0.3, 1, {.bending = 0.2});
  const Evaluation<2> out = evaluate(fast_terms(), system);
  EXPECT_LT(out.energy.terms, 1e-28);
  for (const Vec2& f : out.force) EXPECT_LT(norm(f), 1e-13);
}

/// A droplet is under the pressure gamma dp/da: Laplace's law for a regular polygon, p^2 = 4 N tan(pi/N) a.
TEST(PolygonShape, DropletObeysLaplace) {
  System<2> system;
  system.box.length = {10, 10};
  const int n = 16;
  const double gamma = 0.3, k_a = 40;
  add_polygon(system, {5, 5}, 2, n, 0, 1, {k_a, 0, 0, gamma, StiffnessKind::absolute});
  // Area at which k_a (a0 - a) = gamma dp/da.
  double a = 2;
  for (int k = 0; k < 200; ++k) a = 2 - gamma / k_a * std::sqrt(n * std::tan(M_PI / n) / a);
  for (Vec2& x : system.state.position) x = Vec2{5, 5} + std::sqrt(a / 2) * (x - Vec2{5, 5});
  for (const Vec2& f : evaluate(fast_terms(), system).force) EXPECT_LT(norm(f), 1e-13);
}

std::vector<double> dense(const HessianBlocks<2>& blocks, int n) {
  std::vector<double> h(static_cast<std::size_t>(4) * n * n);
  for (const HessianBlock<2>& block : blocks)
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) {
        const int row = 2 * block.a + c, column = 2 * block.b + d;
        h[static_cast<std::size_t>(row) * 2 * n + column] += block.h[c][d];
        if (block.a != block.b) h[static_cast<std::size_t>(column) * 2 * n + row] += block.h[c][d];
      }
  return h;
}

TEST(PolygonShape, HasTheHessianOfTheTermsItStandsFor) {
  System<2> system = testing::random_polygons({.bodies = 4});
  add_disc_body(system, {1, 1}, 0.5);
  HessianBlocks<2> fast, slow;
  PolygonShape().add_hessian(system, fast);
  shape_terms(system).add_hessian(system, slow);
  const std::vector<double> a = dense(fast, system.state.size()), b = dense(slow, system.state.size());
  double largest = 0;
  for (double x : b) largest = std::max(largest, std::abs(x));
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-13 * largest) << k;
}

/// What the sparse Hessian leaves out is k_a (da/dx)(da/dx)^T, and nothing where a ring needs its area to
/// keep its shape.
TEST(PolygonShape, HasASparseHessianWithoutTheSlopeOfTheArea) {
  for (const double bending : {0.02, 0.0}) {
    System<2> system;
    system.box.length = {20, 20};
    const int n = 9;
    add_polygon(system, {5, 5}, 2, n, 0.3, 1, {.bending = bending});
    for (int i = 0; i < n; ++i)
      system.state.position[i] += Vec2{0.05 * std::sin(3.0 * i), 0.05 * std::cos(5.0 * i)};
    HessianBlocks<2> exact, sparse;
    PolygonShape().add_hessian(system, exact);
    PolygonShape().add_sparse_hessian(system, sparse);
    EXPECT_EQ(sparse.size(), bending > 0 ? 3 * n : n * (n + 1) / 2);
    const std::vector<double> a = dense(exact, n), b = dense(sparse, n);
    std::vector<double> slope;
    for (int i = 0; i < n; ++i) {
      const Vec2 across = system.state.position[(i + 1) % n] - system.state.position[(i + n - 1) % n];
      slope.insert(slope.end(), {0.5 * across[1], -0.5 * across[0]});
    }
    const double k = bending > 0 ? system.shape.stiffness[0].volume : 0;
    for (int i = 0; i < 2 * n; ++i)
      for (int j = 0; j < 2 * n; ++j)
        EXPECT_NEAR(a[2 * n * i + j] - b[2 * n * i + j], k * slope[i] * slope[j], 1e-12);
  }
}

TEST(PolygonShape, GivesTheSameBitsForOneAndTwoThreads) {
  const System<2> system = testing::random_polygons({.bodies = 1600});
  const Evaluation<2> one = evaluate(fast_terms(), system);
  thread_count() = 2;
  const Evaluation<2> two = evaluate(fast_terms(), system);
  thread_count() = 1;
  EXPECT_EQ(one.force, two.force);
  EXPECT_EQ(one.energy.terms, two.energy.terms);
  EXPECT_EQ(one.virial[0][1], two.virial[0][1]);
}

}  // namespace
}  // namespace supple
