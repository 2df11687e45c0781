/// Symmetric matrices as dense ones of Eigen.
#pragma once
#include <Eigen/Core>

#include "supple/solve/sparse_matrix.hpp"

namespace supple::testing {

inline Eigen::MatrixXd dense(const SparseMatrix& lower) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(lower.size, lower.size);
  for (int c = 0; c < lower.size; ++c)
    for (int k = lower.begin[c]; k < lower.begin[c + 1]; ++k)
      full(lower.row[k], c) = full(c, lower.row[k]) = lower.value[k];
  return full;
}

}  // namespace supple::testing
