#include "supple/core/rotation.hpp"

#include <cmath>
#include <numbers>

namespace supple {

namespace {

/// What the functions of a rotation vector of this length are made of.
struct Factors {
  double a, b, c;  ///< sin t/t, (1 - cos t)/t^2, (t - sin t)/t^3
  double db, dc;   ///< (db/dt)/t, (dc/dt)/t
};

/// Sum over k of (-1)^k x^k/(2k + first)!, to rounding for x up to 1.
double alternating(double x, int first) {
  double term = 1, sum = 0;
  for (int k = 2; k <= first; ++k) term /= k;
  for (int k = 0; k < 10; ++k) {
    sum += term;
    term *= -x / ((2 * k + first + 1) * (2 * k + first + 2));
  }
  return sum;
}
/// Its derivative by x.
double alternating_slope(double x, int first) {
  double term = 1, sum = 0;
  for (int k = 2; k <= first + 2; ++k) term /= k;
  for (int k = 1; k < 10; ++k) {
    sum -= k * term;
    term *= -x / ((2 * k + first + 1) * (2 * k + first + 2));
  }
  return sum;
}

Factors factors(double square) {
  if (square < 1)  // the closed forms lose digits
    return {alternating(square, 1), alternating(square, 2), alternating(square, 3),
            2 * alternating_slope(square, 2), 2 * alternating_slope(square, 3)};
  const double t = std::sqrt(square), sine = std::sin(t), cosine = std::cos(t);
  Factors f{sine / t, (1 - cosine) / square, (t - sine) / (square * t), 0, 0};
  f.db = (f.a - 2 * f.b) / square;
  f.dc = (f.b - 3 * f.c) / square;
  return f;
}

/// I + s [q x] + r [q x]^2.
Mat<3> series(const Vec3& q, double square, double s, double r) {
  Mat<3> m;
  m.add_outer(r, q, q);
  for (int k = 0; k < 3; ++k) m[k][k] += 1 - r * square;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    m[last][next] += s * q[k];
    m[next][last] -= s * q[k];
  }
  return m;
}

}  // namespace

Mat<3> rotation(const Vec3& q) {
  const double square = dot(q, q);
  const Factors f = factors(square);
  return series(q, square, f.a, f.b);
}

Mat<3> turning(const Vec3& q) {
  const double square = dot(q, q);
  const Factors f = factors(square);
  return series(q, square, f.b, f.c);
}

Mat<3> turning_slope(const Vec3& q, const Vec3& m) {
  const double square = dot(q, q), along = dot(q, m);
  const Factors f = factors(square);
  const Vec3 aside = cross(m, q);
  Mat<3> slope;
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l)
      slope[k][l] += f.db * q[l] * aside[k] + f.dc * q[l] * (along * q[k] - square * m[k]) +
                     f.c * (m[l] * q[k] - 2 * q[l] * m[k]);
    slope[k][k] += f.c * along;
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    slope[next][last] -= f.b * m[k];  // (e_last x e_next) . m = -m_k
    slope[last][next] += f.b * m[k];
  }
  return slope;
}

Vec3 shortest(const Vec3& q) {
  constexpr double turn = 2 * std::numbers::pi;
  const double angle = norm(q);
  if (!(angle > std::numbers::pi)) return q;
  return std::remainder(angle, turn) / angle * q;
}

namespace {

/// A unit quaternion, cos(|q|/2) and sin(|q|/2) q/|q|.
struct Quaternion {
  double w;
  Vec3 v;
};
Quaternion quaternion(const Vec3& q) {
  const Vec3 half = 0.5 * q;
  return {std::cos(norm(half)), factors(dot(half, half)).a * half};
}

}  // namespace

Vec3 combined(const Vec3& first, const Vec3& second) {
  const Quaternion a = quaternion(second), b = quaternion(first);
  double w = a.w * b.w - dot(a.v, b.v);
  Vec3 v = a.w * b.v + b.w * a.v + cross(a.v, b.v);
  if (w < 0) w = -w, v = -v;  // the same rotation, the short way round
  const double sine = norm(v);
  return sine > 0 ? 2 * std::atan2(sine, w) / sine * v : Vec3{};
}

Vec3 solution(const Mat<3>& m, const Vec3& v) {  // by Cramer's rule
  Vec3 column[3];
  for (int c = 0; c < 3; ++c) column[c] = {m[0][c], m[1][c], m[2][c]};
  const Vec3 normal = cross(column[1], column[2]);
  return 1 / dot(column[0], normal) *
         Vec3{dot(v, normal), dot(column[0], cross(v, column[2])), dot(column[0], cross(column[1], v))};
}

Mat<3> turned(const Mat<3>& m0, const Mat<3>& rotation) {
  Mat<3> out;
  for (int c = 0; c < 3; ++c) {
    const Vec3 axis{rotation[0][c], rotation[1][c], rotation[2][c]};  // where the axis c goes
    Vec3 column{};
    for (int r = 0; r < 3; ++r) column += m0[r][c] * Vec3{rotation[0][r], rotation[1][r], rotation[2][r]};
    out.add_outer(1, column, axis);
  }
  return out;
}

}  // namespace supple
