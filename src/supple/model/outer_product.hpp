/// Parts of second derivatives that couple all sites of a body, not multiplied out.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// factor s s^T, s = slope of the sites first, first + 1, ...: n numbers in the place of n^2.
template <int Dim>
struct OuterProduct {
  double factor;
  std::int32_t first;
  std::vector<Vec<Dim>> slope;
};

template <int Dim>
using OuterProducts = std::vector<OuterProduct<Dim>>;

}  // namespace supple
