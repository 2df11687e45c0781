/// Which periodic image each row of the pair table is about.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// Bodies that deform are not wrapped, so their sites may be any number of cells apart. Where every period is
/// at least twice the distance up to which pairs have rows, the image that is nearest when a row is made is
/// the only one that can touch while the row exists. A few images then serve all rows, and an evaluation
/// looks up the shift of a row in a list. In smaller cells the nearest image is searched for at every
/// evaluation.
template <int Dim>
class RowImages {
 public:
  /// Finds the images again if they may have changed. Returns whether images or rows are others than before.
  bool update(const System<Dim>& system);
  /// Of each row: index into shifts().
  const std::vector<std::int32_t>& index() const { return index_; }
  /// Of each image, the cells to subtract from x_second - x_first, by direction.
  const std::vector<Vec<Dim>>& cells() const { return cells_; }
  /// Of each image, the vector to subtract from x_second - x_first [length], for the box as it is now. The
  /// first one is zero.
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
