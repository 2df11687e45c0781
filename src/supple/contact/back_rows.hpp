/// The rows of a pair table by their second site.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/model/pair_table.hpp"

namespace supple {

/// For each site, the rows in which it is the second one. The pair table is sorted by first sites, and a site
/// that gathers all of its contacts needs both kinds.
class BackRows {
 public:
  /// Lists the rows again if the table has changed.
  void update(const PairTable& pairs, int sites) {
    if (version_ == pairs.version && static_cast<int>(begin_.size()) == sites + 1 &&
        row_.size() == static_cast<std::size_t>(pairs.size()))
      return;
    begin_.assign(static_cast<std::size_t>(sites) + 1, 0);
    for (std::int32_t j : pairs.second) ++begin_[j + 1];
    for (int i = 0; i < sites; ++i) begin_[i + 1] += begin_[i];
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    row_.resize(static_cast<std::size_t>(pairs.size()));
    for (int row = 0; row < pairs.size(); ++row) row_[next[pairs.second[row]]++] = row;
    version_ = pairs.version;
  }
  /// Rows whose second site is i, in ascending order of their first site.
  std::span<const std::int32_t> of(std::int32_t i) const {
    return {row_.data() + begin_[i], row_.data() + begin_[i + 1]};
  }

 private:
  std::vector<std::int32_t> begin_, row_;
  std::uint64_t version_ = 0;
};

}  // namespace supple
