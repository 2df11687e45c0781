/// Second derivatives of the energy with respect to the positions of pairs of sites.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// A contribution h [energy/length^2] to the block d2U / dx_a dx_b of the Hessian. Where a != b, the block
/// (b, a) is the transpose and is not listed. The same pair may occur many times: contributions add up.
template <int Dim>
struct HessianBlock {
  std::int32_t a, b;
  Mat<Dim> h;
};

/// `exact`: all second derivatives. `sparse`: what a preconditioner needs. It leaves out those that couple
/// all sites of a body where they change no stiffness by much, and is factorised several times faster.
enum class HessianKind { exact, sparse };

template <int Dim>
using HessianBlocks = std::vector<HessianBlock<Dim>>;

}  // namespace supple
