/// An upper bound of the eigenvalues of a symmetric matrix, also of one that couples all numbers of each
/// body.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/solve/degrees.hpp"

namespace supple {

/// A part factor s s^T of a matrix, s being `slope` at the numbers `index`. No number is in two such parts.
struct OuterPart {
  double factor = 0;
  std::vector<std::int32_t> index;
  std::vector<double> slope;
};

/// An upper bound of the largest eigenvalue of |A|, A = entries + outer parts: max_i (|A| x)_i / x_i for any
/// x > 0 [Collatz 1942]. It is the least of 30 iterations, for each set of connected numbers by itself. Outer
/// parts are not multiplied out, so that the time grows as the number of entries and slopes.
double eigenvalue_bound(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer, int size);

}  // namespace supple
