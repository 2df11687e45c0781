/// Sums over long arrays in eight lanes: fast, and with the same bits for any alignment and width of vector
/// instructions.
#pragma once
#include <cmath>
#include <cstddef>
#include <span>

namespace supple {

/// Eight numbers that the compiler keeps in vector registers.
struct Lanes {
  typedef double Eight __attribute__((vector_size(64)));
  Eight value{};

  static void load(const double* p, Eight& e) { __builtin_memcpy(&e, p, sizeof e); }
  double sum() const {
    return ((value[0] + value[4]) + (value[2] + value[6])) + ((value[1] + value[5]) + (value[3] + value[7]));
  }
};

/// Sum of a_i b_i.
inline double dot(std::span<const double> a, std::span<const double> b) {
  Lanes lanes;
  Lanes::Eight x, y;
  std::size_t i = 0;
  for (; i + 8 <= a.size(); i += 8) {
    Lanes::load(&a[i], x);
    Lanes::load(&b[i], y);
    lanes.value += x * y;
  }
  double rest = 0;
  for (; i < a.size(); ++i) rest += a[i] * b[i];
  return lanes.sum() + rest;
}

/// Largest |component|; 0 for an empty array.
inline double largest(std::span<const double> a) {
  Lanes lanes;
  Lanes::Eight e;
  std::size_t i = 0;
  for (; i + 8 <= a.size(); i += 8) {
    Lanes::load(&a[i], e);
    const Lanes::Eight size = e < 0 ? -e : e;
    lanes.value = size > lanes.value ? size : lanes.value;
  }
  double result = 0;
  for (int k = 0; k < 8; ++k) result = lanes.value[k] > result ? lanes.value[k] : result;
  for (; i < a.size(); ++i) result = std::abs(a[i]) > result ? std::abs(a[i]) : result;
  return result;
}

/// Largest a_k^2 + a_(k+1)^2 over even k; the size of a must be even.
inline double largest_square_of_pairs(std::span<const double> a) {
  Lanes lanes;
  Lanes::Eight e;
  std::size_t i = 0;
  for (; i + 8 <= a.size(); i += 8) {
    Lanes::load(&a[i], e);
    const Lanes::Eight square = e * e,
                       both = square + __builtin_shufflevector(square, square, 1, 0, 3, 2, 5, 4, 7, 6);
    lanes.value = both > lanes.value ? both : lanes.value;
  }
  double result = 0;
  for (int k = 0; k < 8; ++k) result = lanes.value[k] > result ? lanes.value[k] : result;
  for (; i < a.size(); i += 2) {
    const double square = a[i] * a[i] + a[i + 1] * a[i + 1];
    result = square > result ? square : result;
  }
  return result;
}

/// Largest square of a vector of Dim numbers, one after the other in a.
template <int Dim>
double largest_square(std::span<const double> a) {
  if constexpr (Dim == 2) return largest_square_of_pairs(a);
  double result = 0;
  for (std::size_t i = 0; i < a.size(); i += Dim) {
    double square = 0;
    for (std::size_t d = i; d < i + Dim; ++d) square += a[d] * a[d];
    result = square > result ? square : result;
  }
  return result;
}

/// Adds factor x to y.
inline void add_scaled(double factor, std::span<const double> x, std::span<double> y) {
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += factor * x[i];
}

}  // namespace supple
