/// How large the eigenvalues of a symmetric matrix can be, of one that couples all numbers of each body as
/// well.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/solve/degrees.hpp"

namespace supple {

/// A part factor s s^T of a matrix, of the numbers with these indices. No number is in two of them.
struct OuterPart {
  double factor = 0;
  std::vector<std::int32_t> index;
  std::vector<double> slope;
};

/// Largest eigenvalue, or more, of |A|, A = entries + outer parts: max_i (|A| x)_i / x_i for any x > 0
/// [Collatz 1942], the least of 30 iterations, of each set of numbers that are connected. It takes as long as
/// there are entries and slopes: parts are not multiplied out.
double eigenvalue_bound(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer, int size);

}  // namespace supple
