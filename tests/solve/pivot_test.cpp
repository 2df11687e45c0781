#include "supple/solve/pivot.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <type_traits>

#include "supple/core/random.hpp"

namespace supple {
namespace {

template <class Size>
struct PivotOf : ::testing::Test {
  static constexpr int n = Size::value;
  using Matrix = Eigen::Matrix<double, n, n>;

  static Block<n> block(const Matrix& m) {
    Block<n> b{};
    for (int r = 0; r < n; ++r)
      for (int c = 0; c < n; ++c) b.at(r, c) = m(r, c);
    return b;
  }
  static Matrix matrix(const Block<n>& b) {
    Matrix m;
    for (int r = 0; r < n; ++r)
      for (int c = 0; c < n; ++c) m(r, c) = b.at(r, c);
    return m;
  }
  static Matrix random_rotation(RandomStream& draw) {
    Matrix m;
    for (int r = 0; r < n; ++r)
      for (int c = 0; c < n; ++c) m(r, c) = draw.uniform(-1, 1);
    return Eigen::HouseholderQR<Matrix>(m).householderQ();
  }
  /// A symmetric matrix of these eigenvalues, to the last bit symmetric.
  static Matrix turned(RandomStream& draw, const Eigen::Matrix<double, n, 1>& values) {
    const Matrix q = random_rotation(draw), m = q * values.asDiagonal() * q.transpose();
    return 0.5 * (m + m.transpose());
  }
};
using Sizes = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PivotOf, Sizes, );

TYPED_TEST(PivotOf, InvertsAndKnowsTheSign) {
  constexpr int size = TypeParam::value;
  RandomStream draw(3, Purpose::test);
  int indefinite = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Eigen::Matrix<double, size, 1> values;
    for (int k = 0; k < size; ++k) values[k] = draw.uniform(-0.5, 1);
    if (values.cwiseAbs().minCoeff() < 0.01) continue;
    const auto m = this->turned(draw, values);
    Block<size> inverse;
    const PivotSign sign = invert(this->block(m), inverse);
    EXPECT_EQ(sign, values.minCoeff() > 0 ? PivotSign::positive : PivotSign::indefinite) << values;
    EXPECT_LT((this->matrix(inverse) * m - decltype(m)::Identity()).norm(), 1e-11);
    indefinite += sign == PivotSign::indefinite;
  }
  EXPECT_GT(indefinite, 100);
  EXPECT_LT(indefinite, 300);
}

/// A stiff spring in a soft surrounding: the digits that are lost are those of the condition, not of its
/// square.
TYPED_TEST(PivotOf, KeepsTheDigitsOfIllConditionedBlocks) {
  constexpr int size = TypeParam::value;
  RandomStream draw(4, Purpose::test);
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::Matrix<double, size, 1> values;
    for (int k = 0; k < size; ++k) values[k] = k == 0 ? 1 : 1e-9 * draw.uniform(1, 2);
    const auto m = this->turned(draw, values);
    Block<size> inverse;
    ASSERT_EQ(invert(this->block(m), inverse), PivotSign::positive);
    EXPECT_LT((this->matrix(inverse) * m - decltype(m)::Identity()).norm(), 1e-5);
  }
}

TYPED_TEST(PivotOf, RefusesSingularBlocks) {
  constexpr int size = TypeParam::value;
  Block<size> zero{}, inverse, ones{}, no_number{};
  for (int r = 0; r < size; ++r)
    for (int c = 0; c < size; ++c) ones.at(r, c) = 1;
  for (int r = 0; r < size; ++r) no_number.at(r, r) = std::nan("");
  for (const Block<size>& pivot : {zero, ones, no_number})
    EXPECT_EQ(invert(pivot, inverse), PivotSign::singular);
}

TYPED_TEST(PivotOf, InvertsWhereTheFirstElementIsZero) {
  constexpr int size = TypeParam::value;
  Block<size> pivot{}, inverse;  // antidiagonal: its own inverse
  for (int r = 0; r < size; ++r) pivot.at(r, size - 1 - r) = 1;
  ASSERT_EQ(invert(pivot, inverse), PivotSign::indefinite);
  EXPECT_EQ(this->matrix(inverse), this->matrix(pivot));
}

TYPED_TEST(PivotOf, LeastModeHasTheLeastEigenvalue) {
  constexpr int size = TypeParam::value;
  RandomStream draw(6, Purpose::test);
  for (int trial = 0; trial < 100; ++trial) {
    Eigen::Matrix<double, size, 1> values, x;
    for (int k = 0; k < size; ++k) values[k] = draw.uniform(-1, 1);
    const auto m = this->turned(draw, values);
    const LeastMode<size> mode = least_mode(this->block(m));
    for (int k = 0; k < size; ++k) x[k] = mode.x[k];
    EXPECT_NEAR(mode.value, values.minCoeff(), 1e-14);
    EXPECT_NEAR(x.norm(), 1, 1e-14);
    EXPECT_LT((m * x - mode.value * x).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace supple
