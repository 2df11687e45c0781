/// The blocks on the diagonal of D in L D L^T: their inverse, their sign, the way in which they are lowest.
#pragma once
#include "supple/solve/block.hpp"

namespace supple {

enum class PivotSign {
  positive,    ///< all eigenvalues are
  indefinite,  ///< not all are positive, but there is an inverse
  singular     ///< no inverse, or elements that are no numbers
};

/// Inverts a symmetric block. Of a singular one nothing is written.
template <int Size>
PivotSign invert(const Block<Size>& pivot, Block<Size>& inverse);

/// Least eigenvalue of a symmetric block, and its unit vector.
template <int Size>
struct LeastMode {
  double value;
  double x[Size];
};
template <int Size>
LeastMode<Size> least_mode(const Block<Size>& pivot);

}  // namespace supple
