/// Which pairs may touch: a cell grid and a Verlet skin.
#pragma once
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// Skin of a neighbour list as a share of the mean radius; larger: fewer builds, more rows. By measurement.
inline constexpr double default_skin = 0.4;

/// Keeps System::pairs complete: every pair closer than the sum of its radii, and every permanent link however
/// stretched, has a row; pairs within the skin have one too. Rows that leave lose their history; permanent ones stay.
/// Stale when a site has moved, relative to the affine flow since the last build, so far that a pair without a row
/// could touch: 2 max|u| + |strain change| * reach > skin.
template <int Dim>
class NeighborList {
 public:
  explicit NeighborList(double relative_skin = default_skin) : relative_skin_(relative_skin) {}

  /// Rebuilds if stale. Returns whether it did.
  bool update(System<Dim>& system);
  /// Forces a build at the next update (after sites, radii, links or the box were changed by hand).
  void invalidate() { built_ = false; }
  long builds() const { return builds_; }

 private:
  bool stale(const System<Dim>& system) const;
  void build(System<Dim>& system);

  double relative_skin_;
  double skin_ = 0, reach_ = 0;
  bool built_ = false;
  long builds_ = 0;
  double strain_at_build_ = 0;
  Vec<Dim> length_at_build_{};
  std::vector<Vec<Dim>> position_at_build_;
  PairTable old_;                                    ///< kept for its memory
  std::vector<std::vector<std::int32_t>> partners_;  ///< of the sites of each chunk
};

}  // namespace supple
