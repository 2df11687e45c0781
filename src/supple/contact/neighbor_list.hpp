/// Which pairs may touch: grids of cells and a Verlet skin.
#pragma once
#include <vector>

#include "supple/contact/reach.hpp"

namespace supple {

/// Skin of a neighbour list as a share of the mean radius: a larger one means fewer builds and more rows.
/// Found by measurement.
inline constexpr double default_skin = 0.4;

/// Keeps System::pairs complete: a row for every pair of sites of different bodies that are closer than the
/// sum of their reaches (reach_of_sites) plus the skin, and for every permanent link, however stretched. A
/// row that is dropped loses its history; links stay. The list is stale, and made anew, once a pair without a
/// row could touch: 2 max|u| + (|strain change| + |relative change of lengths|) reach > skin, with the
/// displacements u of sites since the last build, relative to the affine strain of the cell. A periodic cell
/// so short that a site could meet another body on two sides (least_period) is refused, also after it has
/// shrunk: it holds too few particles.
template <int Dim>
class NeighborList {
 public:
  explicit NeighborList(double relative_skin = default_skin, Meeting meeting = Meeting::sites,
                        double range = 1)
      : relative_skin_(relative_skin), meeting_(meeting), range_(range) {}

  /// Makes the rows anew if they are stale, and returns whether it did. Throws an input error where a period
  /// is too short.
  bool update(System<Dim>& system);
  /// Makes the next update() build. Call it after sites, radii, links or the box were changed by hand.
  void invalidate() { built_ = false; }
  long builds() const { return builds_; }
  /// Gap up to which pairs that did not touch got a row at the last build [length].
  double skin() const { return skin_; }

 private:
  bool stale(const System<Dim>& system) const;
  void build(System<Dim>& system);

  void require_periods(const Box<Dim>& box) const;

  double relative_skin_;
  Meeting meeting_;
  double range_;
  double skin_ = 0, reach_ = 0, least_period_ = 0;
  bool built_ = false;
  std::uint64_t version_ = 0;  ///< of the table made last; no version is given twice
  long builds_ = 0;
  double strain_at_build_ = 0;
  Vec<Dim> length_at_build_{};
  std::vector<Vec<Dim>> position_at_build_;
  PairTable old_;                                    ///< the table before; its memory is used again
  std::vector<std::vector<std::int32_t>> partners_;  ///< of the sites of each chunk
};

}  // namespace supple
