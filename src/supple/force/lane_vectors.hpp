/// Numbers and vectors side by side in one register, and points that come from anywhere. For source files of
/// the library alone: how registers pass between functions depends on the processor.
#pragma once
#include <cstdint>
#include <cstring>

#include "supple/core/vec.hpp"
#include "supple/force/lanes.hpp"
#include "supple/geometry/inverse_root.hpp"

namespace supple::lanes {

/// Numbers in a register: eight, or half a block where no register has eight. Both give the same bits.
#ifdef __AVX512F__
inline constexpr int width = 8;
#else
inline constexpr int width = 4;
#endif
typedef double Numbers __attribute__((vector_size(width * sizeof(double))));
using Vectors = VecOf<Numbers, 3>;
/// A point and a fourth number, which is 0.
typedef double Point __attribute__((vector_size(4 * sizeof(double))));

template <class V = Numbers>
[[gnu::always_inline]] inline V load(const double* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
template <class V>
[[gnu::always_inline]] inline void store(const V& v, double* to) {
  std::memcpy(to, &v, sizeof v);
}

/// The vectors of three rows of a block, and the other way.
[[gnu::always_inline]] inline Vectors load_vectors(const double* from) {
  return {load(from), load(from + block), load(from + 2 * block)};
}
[[gnu::always_inline]] inline void store_vectors(const Vectors& v, double* to) {
  for (int d = 0; d < 3; ++d) store(v[d], to + d * block);
}

#ifdef __AVX512F__
/// Points, one behind the other, as vectors side by side.
[[gnu::always_inline]] inline Vectors side_by_side(const Point (&v)[width]) {
  const auto both = [](Point a, Point b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); };
  const Numbers a = both(v[0], v[2]), b = both(v[1], v[3]), c = both(v[4], v[6]), d = both(v[5], v[7]);
  const Numbers xz_low = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14),
                xz_high = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14),
                y_low = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15),
                y_high = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  return {__builtin_shufflevector(xz_low, xz_high, 0, 1, 4, 5, 8, 9, 12, 13),
          __builtin_shufflevector(y_low, y_high, 0, 1, 4, 5, 8, 9, 12, 13),
          __builtin_shufflevector(xz_low, xz_high, 2, 3, 6, 7, 10, 11, 14, 15)};
}

/// The other way: stores points one behind the other.
[[gnu::always_inline]] inline void store_points(const Vectors& v, double* to) {
  constexpr Numbers zero{};
  const Numbers xy_low = __builtin_shufflevector(v[0], v[1], 0, 8, 1, 9, 2, 10, 3, 11),
                xy_high = __builtin_shufflevector(v[0], v[1], 4, 12, 5, 13, 6, 14, 7, 15),
                z_low = __builtin_shufflevector(v[2], zero, 0, 8, 1, 9, 2, 10, 3, 11),
                z_high = __builtin_shufflevector(v[2], zero, 4, 12, 5, 13, 6, 14, 7, 15);
  store(__builtin_shufflevector(xy_low, z_low, 0, 1, 8, 9, 2, 3, 10, 11), to);
  store(__builtin_shufflevector(xy_low, z_low, 4, 5, 12, 13, 6, 7, 14, 15), to + 8);
  store(__builtin_shufflevector(xy_high, z_high, 0, 1, 8, 9, 2, 3, 10, 11), to + 16);
  store(__builtin_shufflevector(xy_high, z_high, 4, 5, 12, 13, 6, 7, 14, 15), to + 24);
}
#else
[[gnu::always_inline]] inline Vectors side_by_side(const Point (&v)[width]) {
  const Numbers xz_low = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6),
                xz_high = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6),
                y_low = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7),
                y_high = __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
  return {__builtin_shufflevector(xz_low, xz_high, 0, 1, 4, 5),
          __builtin_shufflevector(y_low, y_high, 0, 1, 4, 5),
          __builtin_shufflevector(xz_low, xz_high, 2, 3, 6, 7)};
}

[[gnu::always_inline]] inline void store_points(const Vectors& v, double* to) {
  constexpr Numbers zero{};
  const Numbers xy_even = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6),
                xy_odd = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7),
                z_even = __builtin_shufflevector(v[2], zero, 0, 4, 2, 6),
                z_odd = __builtin_shufflevector(v[2], zero, 1, 5, 3, 7);
  store(__builtin_shufflevector(xy_even, z_even, 0, 1, 4, 5), to);
  store(__builtin_shufflevector(xy_odd, z_odd, 0, 1, 4, 5), to + 4);
  store(__builtin_shufflevector(xy_even, z_even, 2, 3, 6, 7), to + 8);
  store(__builtin_shufflevector(xy_odd, z_odd, 2, 3, 6, 7), to + 12);
}
#endif

/// from[at[0]], from[at[1]], ...
[[gnu::always_inline]] inline Numbers gathered(const double* from, const std::uint32_t* at) {
  double here[width];
  for (int v = 0; v < width; ++v) here[v] = from[at[v]];
  return load(here);
}

/// body(v) for the lanes of a register.
template <class Body>
[[gnu::always_inline]] inline void for_lanes(const Body& body) {
#pragma GCC ivdep
  for (int v = 0; v < width; ++v) body(v);
}

[[gnu::always_inline]] inline Numbers per_root(const Numbers& x) {
  double lane[width];
  store(x, lane);
  for_lanes([&lane](int v) { lane[v] = inverse_root(lane[v]); });
  return load(lane);
}

/// Whether a comparison holds in some lane.
template <class Flags>
[[gnu::always_inline]] inline bool any(const Flags& flags) {
  typedef std::int8_t Bytes __attribute__((vector_size(width)));
  const Bytes bytes = __builtin_convertvector(flags, Bytes);
  std::uint64_t bits = 0;
  std::memcpy(&bits, &bytes, sizeof bytes);
  return bits != 0;
}

}  // namespace supple::lanes
