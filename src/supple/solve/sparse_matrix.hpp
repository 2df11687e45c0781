/// A sparse symmetric matrix as plain data.
#pragma once
#include <cstdint>
#include <vector>

namespace supple {

/// One entry of a symmetric matrix, row >= column; entries at one place add up.
class MatrixEntry {
 public:
  MatrixEntry(std::int32_t row, std::int32_t column, double value)
      : row_(row), column_(column), value_(value) {}
  std::int32_t row() const { return row_; }
  std::int32_t col() const { return column_; }
  double value() const { return value_; }

 private:
  std::int32_t row_, column_;
  double value_;
};

/// The lower triangle of a symmetric matrix of `size` rows, column after column, rows ascending. Column c has
/// the elements [begin[c], begin[c + 1]). It is no type of a library: what Eigen's are like depends on flags
/// of the compiler, which a program that uses Supple need not share.
struct SparseMatrix {
  int size = 0;
  std::vector<int> begin, row;
  std::vector<double> value;
};

/// Sums entries, those of the same place in their order.
void sum_entries(int size, const std::vector<MatrixEntry>& entries, SparseMatrix& lower);

}  // namespace supple
