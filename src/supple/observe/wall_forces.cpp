#include "supple/observe/wall_forces.hpp"

#include <algorithm>

namespace supple {

WallForces sum_wall_forces(std::span<const SiteForce<2>> wall) {
  WallForces sum;
  for (const SiteForce<2>& w : wall) {
    const double along = w.force[flow], up = w.force[gradient];
    sum.floor += std::max(up, 0.0);
    sum.lid += std::max(-up, 0.0);
    if (up != 0) {
      sum.drag += along;
      continue;
    }
    sum.left += std::max(along, 0.0);
    sum.right += std::max(-along, 0.0);
  }
  return sum;
}

}  // namespace supple
