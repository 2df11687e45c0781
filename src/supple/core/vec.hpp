/// Small fixed-size vectors and matrices, templated on the scalar so that energies can be differentiated.
#pragma once
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace supple {

/// A vector of Dim components of type S: double, or a Jet, which carries derivatives.
template <class S, int Dim>
struct VecOf {
  S e[Dim]{};
  constexpr S& operator[](int a) { return e[a]; }
  constexpr const S& operator[](int a) const { return e[a]; }

  constexpr VecOf& operator+=(const VecOf& b) {
    for (int a = 0; a < Dim; ++a) e[a] += b[a];
    return *this;
  }
  constexpr VecOf& operator-=(const VecOf& b) {
    for (int a = 0; a < Dim; ++a) e[a] -= b[a];
    return *this;
  }
  constexpr VecOf& operator*=(const S& s) {
    for (int a = 0; a < Dim; ++a) e[a] *= s;
    return *this;
  }
  friend constexpr VecOf operator+(VecOf a, const VecOf& b) { return a += b; }
  friend constexpr VecOf operator-(VecOf a, const VecOf& b) { return a -= b; }
  friend constexpr VecOf operator*(const S& s, VecOf a) { return a *= s; }
  friend constexpr VecOf operator*(VecOf a, const S& s) { return a *= s; }
  friend constexpr VecOf operator-(VecOf a) {
    for (int k = 0; k < Dim; ++k) a[k] = -a[k];
    return a;
  }
  friend constexpr bool operator==(const VecOf& a, const VecOf& b) {
    for (int k = 0; k < Dim; ++k)
      if (!(a[k] == b[k])) return false;
    return true;
  }
};

template <int Dim>
using Vec = VecOf<double, Dim>;
using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

template <class S, int Dim>
constexpr S dot(const VecOf<S, Dim>& a, const VecOf<S, Dim>& b) {
  S sum = a[0] * b[0];
  for (int k = 1; k < Dim; ++k) sum += a[k] * b[k];
  return sum;
}
template <class S, int Dim>
S norm(const VecOf<S, Dim>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// z component of a x b.
template <class S>
constexpr S cross(const VecOf<S, 2>& a, const VecOf<S, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}
template <class S>
constexpr VecOf<S, 3> cross(const VecOf<S, 3>& a, const VecOf<S, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// a turned counter-clockwise by 90 degrees.
template <class S>
constexpr VecOf<S, 2> turned_left(const VecOf<S, 2>& a) {
  return {-a[1], a[0]};
}
/// The cross product (0, 0, w) x a: velocity of a point at a under the angular velocity w.
constexpr Vec2 cross(double w, const Vec2& a) { return w * turned_left(a); }

/// Angular velocity or torque: a number about z in 2D, a vector in 3D.
template <int Dim>
using Angular = std::conditional_t<Dim == 2, double, Vec<Dim>>;

/// Square matrix, m[row][column]; stress and virial: row = force component, column = position component.
template <int Dim>
struct Mat {
  double e[Dim][Dim]{};
  constexpr double* operator[](int a) { return e[a]; }
  constexpr const double* operator[](int a) const { return e[a]; }
  constexpr Mat& operator+=(const Mat& b) {
    for (int a = 0; a < Dim; ++a)
      for (int c = 0; c < Dim; ++c) e[a][c] += b[a][c];
    return *this;
  }
  constexpr Mat& operator*=(double s) {
    for (int a = 0; a < Dim; ++a)
      for (int c = 0; c < Dim; ++c) e[a][c] *= s;
    return *this;
  }
  friend constexpr Mat operator+(Mat a, const Mat& b) { return a += b; }
  friend constexpr Mat operator*(double s, Mat a) { return a *= s; }
  friend constexpr Vec<Dim> operator*(const Mat& m, const Vec<Dim>& x) {
    Vec<Dim> y;
    for (int a = 0; a < Dim; ++a)
      for (int c = 0; c < Dim; ++c) y[a] += m[a][c] * x[c];
    return y;
  }
  /// Adds s * f r^T.
  constexpr void add_outer(double s, const Vec<Dim>& f, const Vec<Dim>& r) {
    for (int a = 0; a < Dim; ++a)
      for (int c = 0; c < Dim; ++c) e[a][c] += s * f[a] * r[c];
  }
};
using Mat2 = Mat<2>;

/// Determinant of a matrix.
constexpr double determinant(const Mat<2>& m) { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; }
constexpr double determinant(const Mat<3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Moment of inertia [mass length^2]: a number about z in 2D, a tensor in 3D.
template <int Dim>
using Inertia = std::conditional_t<Dim == 2, double, Mat<Dim>>;

}  // namespace supple
