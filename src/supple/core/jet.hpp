/// Forward-mode differentiation: numbers that carry their derivatives.
#pragma once
#include <array>
#include <cmath>

namespace supple {

/// Value and derivatives by N variables. `Jet<double, N>` gives gradients; `Jet<Jet<double, N>, N>` Hessians.
template <class S, int N>
struct Jet {
  S value{};
  std::array<S, N> slope{};

  Jet() = default;
  Jet(double constant) : value(constant) {}
  /// f(x) where f = value and f' = slope at x: the chain rule.
  Jet(const S& f, const S& derivative, const Jet& x) : value(f) {
    for (int k = 0; k < N; ++k) slope[k] = derivative * x.slope[k];
  }

  Jet& operator+=(const Jet& b) {
    value += b.value;
    for (int k = 0; k < N; ++k) slope[k] += b.slope[k];
    return *this;
  }
  Jet& operator-=(const Jet& b) {
    value -= b.value;
    for (int k = 0; k < N; ++k) slope[k] -= b.slope[k];
    return *this;
  }
  Jet& operator*=(const Jet& b) {
    for (int k = 0; k < N; ++k) slope[k] = slope[k] * b.value + value * b.slope[k];
    value *= b.value;
    return *this;
  }
  Jet& operator/=(const Jet& b) {
    value /= b.value;
    for (int k = 0; k < N; ++k) slope[k] = (slope[k] - value * b.slope[k]) / b.value;
    return *this;
  }
  Jet& operator*=(double s) {
    value *= s;
    for (S& d : slope) d *= s;
    return *this;
  }

  friend Jet operator+(Jet a, const Jet& b) { return a += b; }
  friend Jet operator-(Jet a, const Jet& b) { return a -= b; }
  friend Jet operator*(Jet a, const Jet& b) { return a *= b; }
  friend Jet operator/(Jet a, const Jet& b) { return a /= b; }
  friend Jet operator+(Jet a, double s) {
    a.value += s;
    return a;
  }
  friend Jet operator+(double s, Jet a) {
    a.value += s;
    return a;
  }
  friend Jet operator-(Jet a, double s) {
    a.value -= s;
    return a;
  }
  friend Jet operator-(double s, const Jet& a) { return -a + s; }
  friend Jet operator*(Jet a, double s) { return a *= s; }
  friend Jet operator*(double s, Jet a) { return a *= s; }
  friend Jet operator/(Jet a, double s) { return a *= 1 / s; }
  friend Jet operator/(double s, const Jet& a) { return Jet(s) /= a; }
  friend Jet operator-(Jet a) { return a *= -1.0; }
  friend bool operator<(const Jet& a, const Jet& b) { return a.value < b.value; }
  friend bool operator>(const Jet& a, const Jet& b) { return b < a; }
  friend bool operator==(const Jet& a, const Jet& b) { return a.value == b.value; }
};

/// Functions of a Jet, by the chain rule.
template <class S, int N>
Jet<S, N> sqrt(const Jet<S, N>& x) {
  using std::sqrt;
  const S root = sqrt(x.value);
  return {root, 0.5 / root, x};
}
template <class S, int N>
Jet<S, N> exp(const Jet<S, N>& x) {
  using std::exp;
  const S e = exp(x.value);
  return {e, e, x};
}
template <class S, int N>
Jet<S, N> log(const Jet<S, N>& x) {
  using std::log;
  return {log(x.value), 1.0 / x.value, x};
}
template <class S, int N>
Jet<S, N> sin(const Jet<S, N>& x) {
  using std::cos, std::sin;
  return {sin(x.value), cos(x.value), x};
}
template <class S, int N>
Jet<S, N> cos(const Jet<S, N>& x) {
  using std::cos, std::sin;
  return {cos(x.value), -sin(x.value), x};
}
template <class S, int N>
Jet<S, N> pow(const Jet<S, N>& x, double exponent) {
  using std::pow;
  return {pow(x.value, exponent), exponent * pow(x.value, exponent - 1), x};
}
/// Angle of the point (x, y).
template <class S, int N>
Jet<S, N> atan2(const Jet<S, N>& y, const Jet<S, N>& x) {
  using std::atan2;
  const S square = x.value * x.value + y.value * y.value;
  Jet<S, N> angle;
  angle.value = atan2(y.value, x.value);
  for (int k = 0; k < N; ++k) angle.slope[k] = (x.value * y.slope[k] - y.value * x.slope[k]) / square;
  return angle;
}
template <class S, int N>
Jet<S, N> abs(const Jet<S, N>& x) {
  return x < Jet<S, N>(0.0) ? -x : x;
}

/// The number itself, without derivatives.
inline double value_of(double x) { return x; }
template <class S, int N>
double value_of(const Jet<S, N>& x) {
  return value_of(x.value);
}

}  // namespace supple
