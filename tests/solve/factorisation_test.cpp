#include "supple/solve/factorisation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

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

void expect_solves(Factorisation& factorisation, const SparseMatrix& lower, double shift) {
  const int n = lower.size;
  std::vector<double> b(n);
  for (int i = 0; i < n; ++i) b[i] = std::sin(3.0 * i);
  const Eigen::VectorXd right = Eigen::Map<Eigen::VectorXd>(b.data(), n);
  factorisation.solve(b);
  const Eigen::VectorXd solution = Eigen::Map<Eigen::VectorXd>(b.data(), n);
  EXPECT_LT((dense(lower) * solution + shift * solution - right).norm(), 1e-11);
}

TEST(Factorisation, SolvesWhateverThePatternBecomes) {
  Factorisation factorisation;
  for (int seed = 1; seed < 6; ++seed) {
    const SparseMatrix lower = random_matrix(60, seed, 3 * seed);
    const double shift = 0.5 - least_eigenvalue(lower);
    factorisation.set(lower);
    ASSERT_TRUE(factorisation.factorise(shift));
    expect_solves(factorisation, lower, shift);
    ASSERT_TRUE(factorisation.factorise(2 * shift));
    expect_solves(factorisation, lower, 2 * shift);
  }
  for (const int n : {20, 21, 1}) {  // an odd number leaves half a block over
    const SparseMatrix smaller = random_matrix(n, n);
    factorisation.set(smaller);
    ASSERT_TRUE(factorisation.factorise(9));
    expect_solves(factorisation, smaller, 9);
  }
}

/// No shift makes the row that fills the last block up a negative one.
TEST(Factorisation, FindsNegativeCurvatureOfAnOddNumberOfRows) {
  Factorisation factorisation;
  const SparseMatrix lower = random_matrix(41, 7);
  const double least = least_eigenvalue(lower);
  factorisation.set(lower);
  EXPECT_TRUE(factorisation.factorise(-least + 1e-6));
  EXPECT_FALSE(factorisation.factorise(-least - 1e-6));
  EXPECT_NEAR(factorisation.negative_curvature(), -1e-6, 1e-7);
  EXPECT_FALSE(factorisation.factorise(-20));
  EXPECT_GE(factorisation.negative_curvature(), least - 20);
  EXPECT_LT(factorisation.negative_curvature(), -10);

  SparseMatrix five;
  sum_entries(1, {{0, 0, 5.0}}, five);
  factorisation.set(five);
  for (const double shift : {0.0, -1.0}) EXPECT_TRUE(factorisation.factorise(shift)) << shift;
  EXPECT_FALSE(factorisation.factorise(-6));
  EXPECT_EQ(factorisation.negative_curvature(), -1);
}

/// A chain of sites fills in nothing: one block below each pivot but the last. Of that block L needs 8
/// multiplications, the next pivot 8, each triangle of a solution 4.
TEST(Factorisation, CountsTheMultiplicationsOfAChain) {
  constexpr int sites = 30;
  std::vector<MatrixEntry> entries;
  for (int k = 0; k < 2 * sites; ++k) {
    entries.emplace_back(k, k, 4.0);
    if (k % 2) entries.emplace_back(k, k - 1, 0.5);
    if (k >= 2) entries.emplace_back(k, k - 2, -1.0);
  }
  SparseMatrix lower;
  sum_entries(2 * sites, entries, lower);
  Factorisation factorisation;
  factorisation.set(lower);
  ASSERT_TRUE(factorisation.factorise(0));
  EXPECT_EQ(factorisation.factorise_work(), 16 * (sites - 1));
  EXPECT_EQ(factorisation.solve_work(), 8 * (sites - 1));
  EXPECT_EQ(factorisation.largest_diagonal(), 4);
  expect_solves(factorisation, lower, 0);
}

TEST(Factorisation, FindsNegativeCurvature) {
  Factorisation factorisation;
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

TEST(Factorisation, EmptyRowsNeedAShift) {
  Factorisation factorisation;
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

}  // namespace
}  // namespace supple
