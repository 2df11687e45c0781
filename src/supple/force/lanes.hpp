/// Loops and sums in blocks of eight numbers, which become vector instructions.
#pragma once
#include <cstring>

namespace supple::lanes {

/// Loops go in blocks of this many numbers, each of which becomes vector instructions without a remainder.
/// The last block runs past the end, over numbers that are never used.
inline constexpr int block = 8;
inline constexpr int padded(int n) { return (n + block - 1) / block * block; }

/// body(v) for v in [0, n) and on to the end of the block, in any order.
template <class Body>
[[gnu::always_inline]] inline void for_blocks(int n, const Body& body) {
  for (int b = 0; b < n; b += block)
#pragma GCC ivdep
    for (int v = b; v < b + block; ++v) body(v);
}

/// A sum of many numbers in eight lanes, whose additions the processor can overlap.
struct LaneSum {
  typedef double Lanes __attribute__((vector_size(block * sizeof(double))));
  Lanes lanes{};

  void add(const double* part, int n) {
    constexpr Lanes index{0, 1, 2, 3, 4, 5, 6, 7}, zero{};
    for (int v = 0; v < n; v += block) {
      Lanes here;
      std::memcpy(&here, part + v, sizeof here);
      lanes += index < static_cast<double>(n - v) ? here : zero;
    }
  }
  double total() const {
    return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) + ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
  }
  LaneSum& operator+=(const LaneSum& b) {
    lanes += b.lanes;
    return *this;
  }
};

}  // namespace supple::lanes
