/// A sparse symmetric matrix in blocks, its rows in an order of elimination.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/solve/block.hpp"
#include "supple/solve/sparse_matrix.hpp"

namespace supple {

/// The lower triangle of a symmetric matrix by columns of blocks, blocks on the diagonal whole. Where the
/// number of rows is no multiple of Size, the rest of the last block is 0.
template <int Size>
struct BlockColumns {
  explicit BlockColumns(const SparseMatrix& lower);

  int size;  ///< columns of blocks
  std::vector<std::int32_t> begin, row;
  std::vector<Block<Size>> block;
};

/// The place of each row of blocks in an order of elimination that fills in little: minimum degree, from
/// Eigen.
template <int Size>
std::vector<std::int32_t> elimination_places(const BlockColumns<Size>& columns);

/// The matrix in such an order: the blocks of row k left of its diagonal are [begin[k], begin[k + 1]).
template <int Size>
struct BlockRows {
  void sort(const BlockColumns<Size>& columns, const std::vector<std::int32_t>& place);

  std::vector<std::int32_t> begin, column;
  std::vector<Block<Size>> block, diagonal;
};

}  // namespace supple
