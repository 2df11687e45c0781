/// Second derivatives of the energy by the positions of pairs of sites.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Adds d2U / dx_a dx_b = h at the block (a, b); where a != b the block (b, a) is its transpose and is not
/// listed. The same pair may occur many times: blocks add up.
template <int Dim>
struct HessianBlock {
  std::int32_t a, b;
  Mat<Dim> h;
};

/// What is asked for: all of it, or what a preconditioner needs. Without the parts that couple all
/// sites of a body, where they change no stiffness by much, it is factorised several times faster.
enum class HessianKind { exact, sparse };

template <int Dim>
using HessianBlocks = std::vector<HessianBlock<Dim>>;

}  // namespace supple
