/// Which periodic image each row of the pair table is about: found when the list is built, good until the next build.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// Bodies that deform are not wrapped, so their sites may be any number of cells apart. The image that is near when a
/// row is made stays near while the row lives, and a few images serve all rows: an evaluation looks its shift up
/// instead of searching for it.
template <int Dim>
class RowImages {
 public:
  /// Finds the images again if the rows have changed. Returns whether they had.
  bool update(const System<Dim>& system);
  /// Of each row: index into shifts().
  const std::vector<std::int32_t>& index() const { return index_; }
  /// Cells to subtract, by direction, that shifts() belongs to.
  const std::vector<Vec<Dim>>& cells() const { return cells_; }
  /// What to subtract from x_second - x_first, for the box as it is now; the first one is zero.
  const std::vector<Vec<Dim>>& shifts(const Box<Dim>& box);

 private:
  std::vector<std::int32_t> index_;
  std::vector<Vec<Dim>> cells_, shifts_;
  std::uint64_t version_ = 0;
};

}  // namespace supple
