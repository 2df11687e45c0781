#include "supple/solve/block_factorisation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <limits>

#include "supple/build/surfaces.hpp"
#include "supple/core/error.hpp"
#include "supple/force/shape_terms.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/objectives.hpp"

namespace supple {
namespace {

using testing::dense;

/// A symmetric matrix with about four elements a row and eigenvalues of both signs; `first_empty` rows and
/// columns of zeros.
SparseMatrix random_matrix(int n, int seed, int first_empty = 0) {
  RandomStream stream(seed, Purpose::test);
  testing::Triplets list;
  for (int k = 0; k < 2 * n; ++k) {
    const int i = first_empty + static_cast<int>(stream.below(n - first_empty));
    const int j = first_empty + static_cast<int>(stream.below(n - first_empty));
    testing::add_entry(list, i, j, stream.uniform(-1, 1));
  }
  SparseMatrix lower;
  testing::build(list, n, lower);
  return lower;
}

double least_eigenvalue(const SparseMatrix& lower) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense(lower)).eigenvalues()[0];
}

/// What holds for blocks of any size.
template <class Size>
struct FactorisationOf : ::testing::Test {
  BlockFactorisation<Size::value> blocks;
};
using Sizes = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(FactorisationOf, Sizes, );

std::vector<double> waves(int n) {
  std::vector<double> b(n);
  for (int i = 0; i < n; ++i) b[i] = std::sin(3.0 * i);
  return b;
}

void expect_solves(Factorisation& factorisation, const SparseMatrix& lower, double shift) {
  const int n = lower.size;
  std::vector<double> b = waves(n);
  const Eigen::VectorXd right = Eigen::Map<Eigen::VectorXd>(b.data(), n);
  factorisation.solve(b);
  const Eigen::VectorXd solution = Eigen::Map<Eigen::VectorXd>(b.data(), n);
  EXPECT_LT((dense(lower) * solution + shift * solution - right).norm(), 1e-11);
}

TYPED_TEST(FactorisationOf, SolvesWhateverThePatternBecomes) {
  auto& factorisation = this->blocks;
  for (int seed = 1; seed < 6; ++seed) {
    const SparseMatrix lower = random_matrix(60, seed, 3 * seed);
    const double shift = 0.5 - least_eigenvalue(lower);
    factorisation.set(lower);
    ASSERT_TRUE(factorisation.factorise(shift));
    expect_solves(factorisation, lower, shift);
    ASSERT_TRUE(factorisation.factorise(2 * shift));
    expect_solves(factorisation, lower, 2 * shift);
  }
  for (const int n : {20, 21, 22, 1, 2, 4, 0}) {  // parts of a block are left over
    const SparseMatrix smaller = random_matrix(n, n);
    factorisation.set(smaller);
    ASSERT_TRUE(factorisation.factorise(9));
    expect_solves(factorisation, smaller, 9);
  }
}

/// No shift makes the rows that fill the last block up negative ones.
TYPED_TEST(FactorisationOf, FindsNegativeCurvatureWhereTheLastBlockIsNotFull) {
  auto& factorisation = this->blocks;
  for (const int n : {41, 43}) {
    const SparseMatrix lower = random_matrix(n, 7);
    const double least = least_eigenvalue(lower);
    factorisation.set(lower);
    EXPECT_TRUE(factorisation.factorise(-least + 1e-6));
    EXPECT_FALSE(factorisation.factorise(-least - 1e-6));
    EXPECT_NEAR(factorisation.negative_curvature(), -1e-6, 1e-7);
    EXPECT_FALSE(factorisation.factorise(-20));
    EXPECT_GE(factorisation.negative_curvature(), least - 20);
    EXPECT_LT(factorisation.negative_curvature(), -10);
  }

  SparseMatrix five;
  sum_entries(1, {{0, 0, 5.0}}, five);
  factorisation.set(five);
  for (const double shift : {0.0, -1.0}) EXPECT_TRUE(factorisation.factorise(shift)) << shift;
  EXPECT_FALSE(factorisation.factorise(-6));
  EXPECT_EQ(factorisation.negative_curvature(), -1);
}

/// A chain of sites fills in nothing: one block below each pivot but the last. Of that block L needs Size^3
/// multiplications, the next pivot as many, each triangle of a solution Size^2.
TYPED_TEST(FactorisationOf, CountsTheMultiplicationsOfAChain) {
  constexpr int sites = 30, size = TypeParam::value;
  std::vector<MatrixEntry> entries;
  for (int k = 0; k < size * sites; ++k) {
    entries.emplace_back(k, k, 4.0);
    if (k % size) entries.emplace_back(k, k - 1, 0.5);
    if (k >= size) entries.emplace_back(k, k - size, -1.0);
  }
  SparseMatrix lower;
  sum_entries(size * sites, entries, lower);
  auto& factorisation = this->blocks;
  factorisation.set(lower);
  ASSERT_TRUE(factorisation.factorise(0));
  EXPECT_EQ(factorisation.factorise_work(), 2 * size * size * size * (sites - 1));
  EXPECT_EQ(factorisation.solve_work(), 2 * size * size * (sites - 1));
  EXPECT_EQ(factorisation.largest_diagonal(), 4);
  expect_solves(factorisation, lower, 0);
}

TYPED_TEST(FactorisationOf, FindsNegativeCurvature) {
  auto& factorisation = this->blocks;
  for (int seed = 1; seed < 6; ++seed) {
    const SparseMatrix lower = random_matrix(60, seed);
    const double least = least_eigenvalue(lower);
    factorisation.set(lower);
    EXPECT_TRUE(factorisation.factorise(-least + 1e-6));
    EXPECT_FALSE(factorisation.factorise(-least - 1e-6));
    EXPECT_NEAR(factorisation.negative_curvature(), -1e-6, 1e-7);
    EXPECT_FALSE(factorisation.factorise(0.01));  // off zero: some diagonal elements are missing
    EXPECT_LT(factorisation.negative_curvature(), 0);
    EXPECT_GE(factorisation.negative_curvature(), least + 0.01);
  }
}

TYPED_TEST(FactorisationOf, EmptyRowsNeedAShift) {
  auto& factorisation = this->blocks;
  SparseMatrix lower;
  sum_entries(5, {{2, 2, 1.0}}, lower);
  factorisation.set(lower);
  EXPECT_FALSE(factorisation.factorise(0));
  EXPECT_EQ(factorisation.negative_curvature(), 0);
  ASSERT_TRUE(factorisation.factorise(1e-11));
  std::vector<double> b = {0, 1e-11, 1, 0, 0};
  factorisation.solve(b);
  EXPECT_NEAR(b[1], 1, 1e-12);
  EXPECT_NEAR(b[2], 1, 1e-10);
}

TYPED_TEST(FactorisationOf, ARightSideThatIsNotFiniteLeavesNothingBehind) {
  auto& factorisation = this->blocks;
  for (const int n : {22, 23}) {
    const SparseMatrix lower = random_matrix(n, n);
    factorisation.set(lower);
    ASSERT_TRUE(factorisation.factorise(9));
    std::vector<double> b(n, std::numeric_limits<double>::infinity());
    factorisation.solve(b);
    expect_solves(factorisation, lower, 9);
  }
}

/// Largest difference from the solution by scalars of Eigen, relative to the largest number of it.
double difference_from_scalars(Factorisation& factorisation, const SparseMatrix& lower, double shift) {
  const Eigen::SparseMatrix<double> full = dense(lower).sparseView();
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> scalars;
  scalars.setShift(shift);
  scalars.compute(full);
  std::vector<double> b = waves(lower.size);
  const Eigen::VectorXd right = Eigen::Map<Eigen::VectorXd>(b.data(), lower.size);
  const Eigen::VectorXd expected = scalars.solve(right);
  factorisation.solve(b);
  return (expected - Eigen::Map<Eigen::VectorXd>(b.data(), lower.size)).cwiseAbs().maxCoeff() /
         expected.cwiseAbs().maxCoeff();
}

TYPED_TEST(FactorisationOf, AgreesWithScalarsOnPositiveMatrices) {
  for (int seed = 1; seed < 20; ++seed) {
    const SparseMatrix lower = random_matrix(150 + seed, seed);
    const double shift = 0.1 - least_eigenvalue(lower);
    this->blocks.set(lower);
    ASSERT_TRUE(this->blocks.factorise(shift));
    EXPECT_LT(difference_from_scalars(this->blocks, lower, shift), 1e-12) << seed;
  }
}

/// Second derivatives of deformable particles that are bent out of shape, with springs between them.
/// `volume` is their stiffness against changes of volume.
SparseMatrix hessian_of_particles(double volume) {
  System<3> system;
  RandomStream draw(5, Purpose::test);
  constexpr int particles = 3, vertices = 42;
  for (int p = 0; p < particles; ++p) {
    TriangleMesh mesh = geodesic_icosahedron(vertices);
    for (Vec3& x : mesh.vertex) x += Vec3{1.3 * p, 0, 0};
    add_surface(system, mesh, 1, {.area = volume, .length = 1, .bending = 0.1, .tension = 0.2});
  }
  for (Vec3& x : system.state.position)
    for (int d = 0; d < 3; ++d) x[d] += draw.uniform(-0.05, 0.05);
  HessianBlocks<3> blocks;
  shape_terms(system).add_hessian(system, blocks);
  std::vector<MatrixEntry> entries;
  const auto add = [&](int a, int b, const Mat<3>& h) {
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) {
        const int row = 3 * a + c, column = 3 * b + d;
        if (a != b || row >= column) testing::add_entry(entries, row, column, h[c][d]);
      }
  };
  for (const HessianBlock<3>& block : blocks) add(block.a, block.b, block.h);
  for (int k = 0; k < vertices; k += 5) {
    const Vec3 r = system.state.position[vertices + k] - system.state.position[k];
    Mat<3> h;
    h.add_outer(1 / dot(r, r), r, r);
    add(k, k, h);
    add(vertices + k, vertices + k, h);
    add(vertices + k, k, -1 * h);
  }
  SparseMatrix lower;
  sum_entries(3 * system.state.size(), entries, lower);
  return lower;
}

TYPED_TEST(FactorisationOf, AgreesWithScalarsOnHessiansOfDeformableParticles) {
  double work[2];
  for (const int volume : {0, 1}) {
    const SparseMatrix lower = hessian_of_particles(volume);
    const double least = least_eigenvalue(lower);
    ASSERT_LT(least, -1e-3);  // the third particle is free, and triangles are compressed
    auto& factorisation = this->blocks;
    factorisation.set(lower);
    EXPECT_FALSE(factorisation.factorise(0));
    EXPECT_LT(factorisation.negative_curvature(), 0);
    EXPECT_GE(factorisation.negative_curvature(), least);
    EXPECT_FALSE(factorisation.factorise(-least - 1e-7));
    EXPECT_NEAR(factorisation.negative_curvature(), -1e-7, 1e-9);
    const double shift = 0.05 - least;
    ASSERT_TRUE(factorisation.factorise(shift));
    EXPECT_LT(difference_from_scalars(factorisation, lower, shift), 1e-12);
    work[volume] = factorisation.factorise_work();
  }
  EXPECT_GT(work[1], 2 * work[0]);  // where it counts, the volume of a particle couples all of its sites
}

TEST(Factorisation, ComesInBlocksOfTwoAndThree) {
  for (const int size : {2, 3}) {
    SparseMatrix lower;
    sum_entries(7, {{6, 0, 1.0}}, lower);
    const auto factorisation = make_factorisation(size);
    factorisation->set(lower);
    EXPECT_EQ(factorisation->solve_work(), 2 * size * size);
  }
  EXPECT_THROW(make_factorisation(1), Error);
}

}  // namespace
}  // namespace supple
