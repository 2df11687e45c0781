#include "supple/solve/pivot.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace supple {

template <>
PivotSign invert(const Block<2>& pivot, Block<2>& inverse) {
  const double a = pivot.e[0], b = pivot.e[1], c = pivot.e[3], determinant = a * c - b * b;
  if (!(std::abs(determinant) > 0)) return PivotSign::singular;
  inverse = {{c / determinant, -b / determinant, -b / determinant, a / determinant}};
  return a > 0 && c - b * (b / a) > 0 ? PivotSign::positive : PivotSign::indefinite;
}

namespace {

/// Of a symmetric block by cofactors: right for any sign, but it loses digits as the square of its condition.
PivotSign invert_by_cofactors(const Block<3>& p, Block<3>& inverse) {
  const auto cofactor = [&](int r, int c) {
    const int i = (r + 1) % 3, j = (r + 2) % 3, k = (c + 1) % 3, l = (c + 2) % 3;
    return p.at(i, k) * p.at(j, l) - p.at(i, l) * p.at(j, k);
  };
  const double determinant =
      p.at(0, 0) * cofactor(0, 0) + p.at(0, 1) * cofactor(0, 1) + p.at(0, 2) * cofactor(0, 2);
  if (!(std::abs(determinant) > 0)) return PivotSign::singular;
  inverse = {};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c <= r; ++c) inverse.at(r, c) = inverse.at(c, r) = cofactor(r, c) / determinant;
  return PivotSign::indefinite;
}

}  // namespace

template <>
PivotSign invert(const Block<3>& p, Block<3>& inverse) {
  // L D L^T of the block itself, which loses digits as its condition only, where it is positive.
  const double d0 = p.at(0, 0), l1 = p.at(1, 0) / d0, l2 = p.at(2, 0) / d0;
  const double d1 = p.at(1, 1) - l1 * p.at(1, 0), l21 = (p.at(2, 1) - l2 * p.at(1, 0)) / d1;
  const double d2 = p.at(2, 2) - l2 * p.at(2, 0) - l21 * l21 * d1;
  if (!(d0 > 0 && d1 > 0 && d2 > 0)) return invert_by_cofactors(p, inverse);
  // The rows of L^-1 are (1, 0, 0), (-l1, 1, 0), (m, -l21, 1).
  const double m = l1 * l21 - l2, i0 = 1 / d0, i1 = 1 / d1, i2 = 1 / d2;
  inverse = {};
  inverse.at(0, 0) = i0 + l1 * l1 * i1 + m * m * i2;
  inverse.at(1, 0) = inverse.at(0, 1) = -l1 * i1 - m * l21 * i2;
  inverse.at(2, 0) = inverse.at(0, 2) = m * i2;
  inverse.at(1, 1) = i1 + l21 * l21 * i2;
  inverse.at(2, 1) = inverse.at(1, 2) = -l21 * i2;
  inverse.at(2, 2) = i2;
  return PivotSign::positive;
}

template <>
LeastMode<2> least_mode(const Block<2>& pivot) {
  const double a = pivot.e[0], b = pivot.e[1], c = pivot.e[3];
  const double half = 0.5 * (a - c), root = std::hypot(half, b);
  const double value = 0.5 * (a + c) - root;
  // Of (A - value I) v = 0 the row whose element on the diagonal is the larger one.
  double x = -b, y = half + root;
  if (half < 0) x = root - half, y = -b;
  const double length = std::hypot(x, y);
  if (!(length > 0)) return {value, {1, 0}};
  return {value, {x / length, y / length}};
}

template <>
LeastMode<3> least_mode(const Block<3>& pivot) {
  Eigen::Matrix3d matrix;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) matrix(r, c) = pivot.at(r, c);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(matrix);
  const Eigen::Vector3d v = modes.eigenvectors().col(0);
  return {modes.eigenvalues()[0], {v[0], v[1], v[2]}};
}

}  // namespace supple
