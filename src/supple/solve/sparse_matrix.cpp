#include "supple/solve/sparse_matrix.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace supple {

/// By columns with a counting sort, then each column by rows.
void sum_entries(int size, const std::vector<MatrixEntry>& entries, SparseMatrix& lower) {
  std::vector<std::int32_t> begin(static_cast<std::size_t>(size) + 1);
  for (const MatrixEntry& e : entries) ++begin[e.col() + 1];
  for (int c = 0; c < size; ++c) begin[c + 1] += begin[c];
  std::vector<std::pair<std::int32_t, double>> sorted(entries.size());
  std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
  for (const MatrixEntry& e : entries) sorted[next[e.col()]++] = {e.row(), e.value()};

  lower.size = size;
  lower.begin.resize(static_cast<std::size_t>(size) + 1);
  lower.row.resize(entries.size());
  lower.value.resize(entries.size());
  int at = 0;
  for (int c = 0; c < size; ++c) {
    lower.begin[c] = at;
    std::stable_sort(sorted.begin() + begin[c], sorted.begin() + begin[c + 1],
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::int32_t k = begin[c]; k < begin[c + 1]; ++k) {
      if (k > begin[c] && sorted[k].first == sorted[k - 1].first) {
        lower.value[at - 1] += sorted[k].second;
        continue;
      }
      lower.row[at] = sorted[k].first;
      lower.value[at++] = sorted[k].second;
    }
  }
  lower.begin[size] = at;
  lower.row.resize(at);
  lower.value.resize(at);
}

}  // namespace supple
