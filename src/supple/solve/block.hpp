/// Small square blocks of a sparse matrix, and what a factorisation spends its time with: products of them.
#pragma once

namespace supple {

/// Two or four numbers that one instruction treats.
typedef double Two __attribute__((vector_size(16)));
typedef double Four __attribute__((vector_size(32)));

/// A matrix of Size x Size, row after row. A row of three takes four places, the last of them 0, so that it
/// fills a vector.
template <int Size>
struct Block {
  static_assert(Size == 2 || Size == 3, "the numbers of a site in 2D or 3D");
  static constexpr int stride = Size == 2 ? 2 : 4;  ///< places of a row, and of the numbers of a site
  double e[Size * stride];
  double& at(int row, int column) { return e[stride * row + column]; }
  double at(int row, int column) const { return e[stride * row + column]; }
};

/// As many numbers as a block has rows, in registers.
template <int Size>
struct BlockVector;
template <>
struct BlockVector<2> {
  using Type = Two;
};
template <>
struct BlockVector<3> {
  using Type = Four;
};
template <int Size>
typename BlockVector<Size>::Type load_vector(const double* from) {
  typename BlockVector<Size>::Type v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
template <class Vector>
void store_vector(Vector v, double* to) {
  __builtin_memcpy(to, &v, sizeof v);
}

/// A block in registers. Each element of a result is computed as the comments of the general case say, in
/// this order, whatever the size.
template <int Size>
struct Packed;

template <>
struct Packed<2> {
  Four v{};

  Packed() = default;
  explicit Packed(Four four) : v(four) {}
  explicit Packed(const Block<2>& block) { __builtin_memcpy(&v, block.e, sizeof v); }
  void store(Block<2>& block) const { __builtin_memcpy(block.e, &v, sizeof v); }

  Packed transposed() const { return Packed(__builtin_shufflevector(v, v, 0, 2, 1, 3)); }
  Packed& operator+=(const Packed& b) {
    v += b.v;
    return *this;
  }
  Packed& operator-=(const Packed& b) {
    v -= b.v;
    return *this;
  }
  /// x - row_0 f_0 - row_1 f_1 ..., which is x - (this transposed) f.
  Two minus_rows(Two x, const double* f) const {
    return x - f[0] * __builtin_shufflevector(v, v, 0, 1) - f[1] * __builtin_shufflevector(v, v, 2, 3);
  }
  /// Each row times x, element by element.
  Packed each_row_times(Two x) const { return Packed(v * __builtin_shufflevector(x, x, 0, 1, 0, 1)); }
  /// Subtracts the sum of each row from `to`.
  void subtract_row_sums(double* to) const {
    to[0] -= v[0] + v[1];
    to[1] -= v[2] + v[3];
  }
};

/// A block that is multiplied by others again and again: each of its elements in as many lanes as a row has.
template <int Size>
struct LeftFactor;

template <>
struct LeftFactor<2> {
  explicit LeftFactor(const Packed<2>& a)
      : left(__builtin_shufflevector(a.v, a.v, 0, 0, 2, 2)),
        right(__builtin_shufflevector(a.v, a.v, 1, 1, 3, 3)) {}
  /// a_r0 b_0c + a_r1 b_1c + ...
  Packed<2> times(const Packed<2>& b) const {
    return Packed<2>(left * first_row_twice(b) + right * second_row_twice(b));
  }
  /// x_rc - a_r0 b_0c - a_r1 b_1c - ...
  Packed<2> subtract_product(const Packed<2>& b, const Packed<2>& x) const {
    return Packed<2>(x.v - left * first_row_twice(b) - right * second_row_twice(b));
  }

 private:
  static Four first_row_twice(const Packed<2>& b) { return __builtin_shufflevector(b.v, b.v, 0, 1, 0, 1); }
  static Four second_row_twice(const Packed<2>& b) { return __builtin_shufflevector(b.v, b.v, 2, 3, 2, 3); }
  Four left, right;
};

template <>
struct Packed<3> {
  Four row[3]{};

  Packed() = default;
  explicit Packed(const Block<3>& block) { __builtin_memcpy(row, block.e, sizeof row); }
  void store(Block<3>& block) const { __builtin_memcpy(block.e, row, sizeof row); }

  Packed transposed() const {
    Packed t;
    for (int r = 0; r < 3; ++r) t.row[r] = Four{row[0][r], row[1][r], row[2][r], 0};
    return t;
  }
  Packed& operator+=(const Packed& b) {
    for (int r = 0; r < 3; ++r) row[r] += b.row[r];
    return *this;
  }
  Packed& operator-=(const Packed& b) {
    for (int r = 0; r < 3; ++r) row[r] -= b.row[r];
    return *this;
  }
  Four minus_rows(Four x, const double* f) const { return x - f[0] * row[0] - f[1] * row[1] - f[2] * row[2]; }
  Packed each_row_times(Four x) const {
    Packed p;
    for (int r = 0; r < 3; ++r) p.row[r] = row[r] * x;
    return p;
  }
  void subtract_row_sums(double* to) const {
    for (int r = 0; r < 3; ++r) to[r] -= row[r][0] + row[r][1] + row[r][2];
  }
};

template <>
struct LeftFactor<3> {
  explicit LeftFactor(const Packed<3>& a) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) e[r][c] = Four{} + a.row[r][c];
  }
  Packed<3> times(const Packed<3>& b) const {
    Packed<3> p;
    for (int r = 0; r < 3; ++r) p.row[r] = e[r][0] * b.row[0] + e[r][1] * b.row[1] + e[r][2] * b.row[2];
    return p;
  }
  Packed<3> subtract_product(const Packed<3>& b, const Packed<3>& x) const {
    Packed<3> p;
    for (int r = 0; r < 3; ++r)
      p.row[r] = x.row[r] - e[r][0] * b.row[0] - e[r][1] * b.row[1] - e[r][2] * b.row[2];
    return p;
  }

 private:
  Four e[3][3];
};

}  // namespace supple
