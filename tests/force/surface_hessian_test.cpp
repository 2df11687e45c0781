/// Second derivatives of SurfaceShape.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "supple/force/shape_terms.hpp"
#include "supple/force/surface_shape.hpp"
#include "tests/support/random_surfaces.hpp"
#include "tests/support/surface_reference.hpp"

namespace supple {
namespace {

using Matrix = Eigen::MatrixXd;

Matrix dense(const HessianBlocks<3>& blocks, int sites, const OuterProducts<3>& products = {}) {
  Matrix h = Matrix::Zero(3 * sites, 3 * sites);
  for (const HessianBlock<3>& block : blocks)
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) {
        h(3 * block.a + c, 3 * block.b + d) += block.h[c][d];
        if (block.a != block.b) h(3 * block.b + d, 3 * block.a + c) += block.h[c][d];
      }
  for (const OuterProduct<3>& p : products) {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(3 * sites);
    for (std::size_t i = 0; i < p.slope.size(); ++i)
      for (int d = 0; d < 3; ++d) slope[3 * (p.first + static_cast<int>(i)) + d] = p.slope[i][d];
    h += p.factor * slope * slope.transpose();
  }
  return h;
}

Matrix exact(const System<3>& system) {
  HessianBlocks<3> blocks;
  SurfaceShape().add_hessian(system, blocks);
  return dense(blocks, system.state.size());
}

Eigen::VectorXd forces(const System<3>& system) {
  Evaluation<3> out;
  out.force.resize(system.state.size());
  SurfaceShape().evaluate(system, Detail::forces, out);
  Eigen::VectorXd all(3 * system.state.size());
  for (int k = 0; k < all.size(); ++k) all[k] = out.force[k / 3][k % 3];
  return all;
}

double largest(const Matrix& m) { return m.cwiseAbs().maxCoeff(); }

const ShapeSpec kinds[] = {{.area = 1, .length = 1, .bending = 0.1, .tension = 0.05},
                           {.area = 1, .length = 1, .bending = 0, .tension = 0.05},
                           {.area = 1, .length = 0, .bending = 0, .tension = 0},
                           {.area = 0, .length = 1, .bending = 0, .tension = 0},
                           {.area = 0, .length = 0, .bending = 1, .tension = 0},
                           {.area = 0, .length = 0, .bending = 0, .tension = 1}};

TEST(SurfaceHessian, EqualsThatOfTheTerms) {
  for (const ShapeSpec& shape : kinds) {
    System<3> system = testing::random_surfaces({.vertices = {12, 42}, .shape = shape, .jitter = 0.08});
    add_sphere_body(system, {1, 1, 9}, 0.5);
    HessianBlocks<3> slow;
    shape_terms(system).add_hessian(system, slow);
    const Matrix a = exact(system), b = dense(slow, system.state.size());
    ASSERT_GT(largest(b), 0);
    EXPECT_LT(largest(a - b), 1e-11 * largest(b));
  }
}

TEST(SurfaceHessian, IsTheSlopeOfTheForces) {
  for (const ShapeSpec& shape : kinds) {
    System<3> system = testing::random_surfaces({.vertices = {12, 42}, .shape = shape, .jitter = 0.08});
    const Matrix h = exact(system);
    const double step = 1e-5;
    Matrix differences(h.rows(), h.cols());
    for (int k = 0; k < h.cols(); ++k) {
      double& x = system.state.position[k / 3][k % 3];
      const double x0 = x;
      x = x0 + step;
      const Eigen::VectorXd above = forces(system);
      x = x0 - step;
      differences.col(k) = (forces(system) - above) / (2 * step);
      x = x0;
    }
    EXPECT_LT(largest(h - differences), 1e-7 * largest(h));
  }
}

/// In blocks of pairs of one hinge and n numbers a body: with all pairs a body of 642 vertices would have
/// 206 403 blocks.
TEST(SurfaceHessian, IsTheSameAsBlocksOfHingesAndOuterProducts) {
  for (const ShapeSpec& shape : kinds) {
    System<3> system = testing::random_surfaces({.vertices = {12, 42, 12, 12}, .shape = shape});
    add_sphere_body(system, {1, 1, 9}, 0.5);
    system.shape.stiffness[3] = {};  // rigid
    HessianBlocks<3> blocks;
    OuterProducts<3> products;
    SurfaceShape().add_joining_hessian(system, blocks);
    EXPECT_TRUE(blocks.empty());
    for (int b = 0; b < 5; ++b) SurfaceShape().add_body_hessian(system, b, blocks, products);
    const std::size_t edges = 30 + 120 + 30;
    EXPECT_EQ(blocks.size(), 66 + edges * (shape.bending > 0 ? 2 : 1));
    EXPECT_EQ(products.size(), shape.area > 0 ? 3u : 0u);
    for (const HessianBlock<3>& block : blocks) EXPECT_GE(block.a, block.b);
    const Matrix whole = exact(system);
    EXPECT_LT(largest(whole - dense(blocks, system.state.size(), products)), 1e-14 * largest(whole));
  }
}

/// What the sparse Hessian leaves out is k_v (dv/dx)(dv/dx)^T, and nothing where a surface needs its volume
/// to keep its shape.
TEST(SurfaceHessian, IsSparseWithoutTheSlopeOfTheVolume) {
  for (const auto& [shape, leaves_out] : {std::pair{kinds[0], true},
                                          {kinds[1], false},
                                          {ShapeSpec{.area = 50, .length = 1, .bending = 0.1}, false}}) {
    const System<3> system = testing::random_surfaces({.vertices = {42}, .shape = shape});
    HessianBlocks<3> sparse, blocks;
    OuterProducts<3> products;
    SurfaceShape().add_sparse_hessian(system, sparse);
    EXPECT_EQ(sparse.size(), leaves_out ? 42u + 2 * 120 : 42u * 43 / 2);
    SurfaceShape().add_body_hessian(system, 0, blocks, products);
    ASSERT_EQ(products.size(), 1u);
    if (!leaves_out) products.clear();
    const Matrix left_out = exact(system) - dense(sparse, 42);
    const Matrix expected = leaves_out ? dense({}, 42, products) : Matrix::Zero(126, 126);
    EXPECT_LT(largest(left_out - expected), 1e-13 * largest(exact(system)));
  }
}

/// Zero modes: rigid motions, and all shapes that keep every area and the volume of a floppy particle
/// [deformable.md, section 10: N + 3 of N vertices].
TEST(SurfaceHessian, HasTheEigenvaluesOfTheReferences) {
  for (const auto& [name, zero_modes] :
       {std::pair{"single_shell_42", 6}, {"single_droplet_42", 6}, {"single_floppy_42", 45}}) {
    const testing::SurfaceReference reference = testing::read_surfaces(name);
    const Eigen::VectorXd found =
        Eigen::SelfAdjointEigenSolver<Matrix>(exact(reference.system), Eigen::EigenvaluesOnly).eigenvalues();
    const auto expected = reference.expected()["eigenvalues"].get<std::vector<double>>();
    ASSERT_EQ(static_cast<std::size_t>(found.size()), expected.size());
    const double most = expected.back();
    int zeros = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(found[static_cast<int>(k)], expected[k], 1e-7 * most) << name << ": " << k;
      zeros += std::abs(found[static_cast<int>(k)]) < 1e-9 * most;
    }
    EXPECT_EQ(zeros, zero_modes) << name;
  }
}

}  // namespace
}  // namespace supple
