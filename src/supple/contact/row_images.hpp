/// Which periodic image each row of the pair table is about.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// Bodies that deform are not wrapped, so their sites may be any number of cells apart. Where every period is
/// at least twice the distance to which rows are made, the image that is near when a row is made is the only
/// one that can touch while the row lives; a few images serve all rows, and an evaluation looks its shift up
/// instead of searching for it. In smaller cells the nearest image is found at every evaluation.
template <int Dim>
class RowImages {
 public:
  /// Finds the images again if they may have changed. Returns whether they had, or the rows had.
  bool update(const System<Dim>& system);
  /// Of each row: index into shifts().
  const std::vector<std::int32_t>& index() const { return index_; }
  /// Cells to subtract, by direction, that shifts() belongs to.
  const std::vector<Vec<Dim>>& cells() const { return cells_; }
  /// What to subtract from x_second - x_first, for the box as it is now; the first one is zero.
  const std::vector<Vec<Dim>>& shifts(const Box<Dim>& box);

 private:
  void find(const System<Dim>& system);
  bool good_while_rows_live(const System<Dim>& system) const;

  std::vector<std::int32_t> index_;
  std::vector<Vec<Dim>> cells_, shifts_;
  std::vector<Vec<Dim>> before_;  ///< the image of each row before the present search
  std::uint64_t version_ = 0;
};

}  // namespace supple
