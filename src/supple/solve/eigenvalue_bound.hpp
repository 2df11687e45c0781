/// An upper bound of the eigenvalues of a symmetric matrix, also of one that couples all numbers of each
/// body.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "supple/solve/sparse_matrix.hpp"

namespace supple {

/// A part factor s s^T of a matrix, s being `slope` at the numbers `index`. No number is in two such parts.
struct OuterPart {
  double factor = 0;
  std::vector<std::int32_t> index;
  std::vector<double> slope;
};

/// Bounds of one matrix after the other, in memory that is used again.
class EigenvalueBound {
 public:
  EigenvalueBound();
  ~EigenvalueBound();

  /// An upper bound of the largest eigenvalue of |A|, A = entries + outer parts, or `least` where that is
  /// larger: max_i (|A| x)_i / x_i for any x > 0 [Collatz 1942]. It is the least of 30 iterations, for each
  /// set of connected numbers by itself. Of a matrix in portions that nothing connects it is that of the last
  /// one, if `least` is that of the portions before: none is then sharpened for nothing. Outer parts are not
  /// multiplied out, so that the time grows as the number of entries and slopes.
  double of(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer, int size,
            double least = 0);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// The same of one matrix.
inline double eigenvalue_bound(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer,
                               int size) {
  return EigenvalueBound().of(lower, outer, size);
}

}  // namespace supple
