#include "supple/core/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/core/random.hpp"

namespace supple {
namespace {

using std::numbers::pi;

/// Rotation vectors of these lengths along random axes; from 1 on closed forms take the place of series.
std::vector<Vec3> samples() {
  std::vector<Vec3> all{{}};
  RandomStream draw(1, Purpose::test);
  for (const double angle : {1e-9, 1e-4, 0.3, 0.999999, 1.000001, 2.0, 3.1, pi, 4.5, 6.2, 20.0}) {
    const Vec3 axis{draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)};
    all.push_back(angle / norm(axis) * axis);
  }
  return all;
}

Mat<3> product(const Mat<3>& a, const Mat<3>& b) {
  Mat<3> c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
Mat<3> transposed(const Mat<3>& a) {
  Mat<3> t;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) t[i][j] = a[j][i];
  return t;
}
double difference(const Mat<3>& a, const Mat<3>& b) {
  double most = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(a[i][j] - b[i][j]));
  return most;
}
const Mat<3> unit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

TEST(Rotation, IsCounterClockwiseAboutItsVector) {
  const Mat<3> quarter = rotation({0, 0, pi / 2});
  EXPECT_LT(norm(quarter * Vec3{1, 0, 0} - Vec3{0, 1, 0}), 1e-15);
  EXPECT_LT(norm(quarter * Vec3{0, 1, 0} - Vec3{-1, 0, 0}), 1e-15);
  EXPECT_LT(norm(quarter * Vec3{0, 0, 1} - Vec3{0, 0, 1}), 1e-15);
}

TEST(Rotation, KeepsLengthsAndItsAxisAndHasItsAngle) {
  for (const Vec3& q : samples()) {
    const Mat<3> r = rotation(q);
    EXPECT_LT(difference(product(r, transposed(r)), unit), 2e-15) << norm(q);
    EXPECT_LE(norm(r * q - q), 4e-15 * norm(q)) << norm(q);
    EXPECT_NEAR(r[0][0] + r[1][1] + r[2][2], 1 + 2 * std::cos(norm(q)), 4e-15) << norm(q);
  }
}

TEST(Rotation, TurnsAtTheRateOfItsVector) {
  for (const Vec3& q : samples()) {
    const double h = 1e-5;
    const Mat<3> t = turning(q), back = transposed(rotation(q));
    for (int k = 0; k < 3; ++k) {
      Vec3 above = q, below = q;
      above[k] += h;
      below[k] -= h;
      const Mat<3> change =
          1 / (2 * h) * (product(rotation(above), back) + -1.0 * product(rotation(below), back));
      EXPECT_NEAR(change[2][1], t[0][k], 2e-10) << norm(q) << ' ' << k;
      EXPECT_NEAR(change[0][2], t[1][k], 2e-10) << norm(q) << ' ' << k;
      EXPECT_NEAR(change[1][0], t[2][k], 2e-10) << norm(q) << ' ' << k;
    }
  }
}

TEST(Rotation, TheRateOfTurningHasItsSlope) {
  const Vec3 m{0.3, -1.1, 0.7};
  for (const Vec3& q : samples()) {
    const double h = 1e-5;
    const Mat<3> slope = turning_slope(q, m);
    for (int l = 0; l < 3; ++l) {
      Vec3 above = q, below = q;
      above[l] += h;
      below[l] -= h;
      const Vec3 change = 1 / (2 * h) * (transposed(turning(above)) * m - transposed(turning(below)) * m);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(change[k], slope[k][l], 2e-10) << norm(q) << k << l;
    }
  }
}

TEST(Rotation, OfAVectorLongerThanPiHasAShorterOne) {
  for (const Vec3& q : samples()) {
    const Vec3 s = shortest(q);
    EXPECT_LE(norm(s), pi);
    EXPECT_LT(difference(rotation(s), rotation(q)), 1e-14) << norm(q);
    if (norm(q) < pi) {
      EXPECT_EQ(s, q);
    }
  }
}

TEST(Rotation, OneAfterTheOtherIsOne) {
  for (const Vec3& a : samples())
    for (const Vec3& b : samples()) {
      const Vec3 both = combined(a, b);
      EXPECT_LE(norm(both), pi * (1 + 1e-15));
      EXPECT_LT(difference(rotation(both), product(rotation(b), rotation(a))), 2e-14) << norm(a) << norm(b);
    }
}

TEST(Rotation, LinearEquationsAreSolved) {
  const Mat<3> m{{{4, 1, -1}, {0.5, 3, 2}, {-1, 0.2, 5}}};
  const Vec3 x{1, -2, 3};
  EXPECT_LT(norm(solution(m, m * x) - x), 1e-14);
}

TEST(Rotation, TensorsTurnWithTheirFrame) {
  const Mat<3> m{{{4, 1, -1}, {1, 3, 2}, {-1, 2, 5}}};
  for (const Vec3& q : samples()) {
    const Mat<3> r = rotation(q);
    EXPECT_LT(difference(turned(m, r), product(product(r, m), transposed(r))), 1e-14);
  }
}

}  // namespace
}  // namespace supple
