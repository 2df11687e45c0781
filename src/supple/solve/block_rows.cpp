#include "supple/solve/block_rows.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

namespace supple {

template <int Size>
BlockColumns<Size>::BlockColumns(const SparseMatrix& lower) : size((lower.size + Size - 1) / Size), begin{0} {
  std::vector<std::int32_t> place(static_cast<std::size_t>(size), -1);
  for (int column = 0; column < size; ++column) {
    for (int part = 0; part < Size && Size * column + part < lower.size; ++part)
      for (int k = lower.begin[Size * column + part]; k < lower.begin[Size * column + part + 1]; ++k) {
        const int r = lower.row[k] / Size, within = lower.row[k] % Size;
        if (place[r] < begin.back()) {
          place[r] = static_cast<std::int32_t>(row.size());
          row.push_back(r);
          block.push_back({});
        }
        Block<Size>& b = block[static_cast<std::size_t>(place[r])];
        b.at(within, part) = lower.value[k];
        if (r == column) b.at(part, within) = lower.value[k];
      }
    begin.push_back(static_cast<std::int32_t>(row.size()));
  }
}

template <int Size>
std::vector<std::int32_t> elimination_places(const BlockColumns<Size>& columns) {
  const std::vector<double> ones(columns.row.size(), 1.0);
  const Eigen::Map<const Eigen::SparseMatrix<double>> lower(
      columns.size, columns.size, static_cast<Eigen::Index>(ones.size()), columns.begin.data(),
      columns.row.data(), ones.data());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> eliminated;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), eliminated);
  std::vector<std::int32_t> place(static_cast<std::size_t>(columns.size));
  for (int k = 0; k < columns.size; ++k) place[eliminated.indices()[k]] = k;
  return place;
}

template <int Size>
void BlockRows<Size>::sort(const BlockColumns<Size>& columns, const std::vector<std::int32_t>& place) {
  const int n = columns.size;
  diagonal.assign(static_cast<std::size_t>(n), {});
  begin.assign(static_cast<std::size_t>(n) + 1, 0);
  const auto later = [&](int a, int b) { return std::max(place[a], place[b]); };
  for (int c = 0; c < n; ++c)
    for (std::int32_t k = columns.begin[c]; k < columns.begin[c + 1]; ++k)
      if (columns.row[k] != c) ++begin[later(columns.row[k], c) + 1];
  for (int k = 0; k < n; ++k) begin[k + 1] += begin[k];
  column.resize(static_cast<std::size_t>(begin.back()));
  block.resize(column.size());
  std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
  for (int c = 0; c < n; ++c)
    for (std::int32_t k = columns.begin[c]; k < columns.begin[c + 1]; ++k) {
      const std::int32_t r = columns.row[k], row_place = place[r], column_place = place[c];
      if (r == c) {
        diagonal[row_place] = columns.block[k];
        continue;
      }
      const std::int32_t at = next[std::max(row_place, column_place)]++;
      column[at] = std::min(row_place, column_place);
      const Packed<Size> b(columns.block[k]);
      (row_place > column_place ? b : b.transposed()).store(block[at]);
    }
}

template struct BlockColumns<2>;
template struct BlockColumns<3>;
template std::vector<std::int32_t> elimination_places(const BlockColumns<2>&);
template std::vector<std::int32_t> elimination_places(const BlockColumns<3>&);
template struct BlockRows<2>;
template struct BlockRows<3>;

}  // namespace supple
