/// Second derivatives that couple all sites of a body, kept as products of vectors.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// A part factor s s^T of the second derivatives, where s has the vector slope[k] at the site first + k: n
/// numbers in place of n^2.
template <int Dim>
struct OuterProduct {
  double factor;
  std::int32_t first;
  std::vector<Vec<Dim>> slope;
};

template <int Dim>
using OuterProducts = std::vector<OuterProduct<Dim>>;

}  // namespace supple
