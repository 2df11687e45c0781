#include "supple/draw/solid/cell_planes.hpp"

#include "supple/draw/scene/drawn_cell.hpp"

namespace supple {

std::vector<CellPlane> cell_planes(const Box<3>& box) {
  const std::array<Vec3, 8> corner = cell_corners(box);
  std::vector<CellPlane> planes;
  for (int d = 0; d < 3; ++d) {
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    Vec3 normal = cross(corner[1 << e] - corner[0], corner[1 << f] - corner[0]);
    normal *= 1 / norm(normal);
    planes.push_back({-normal, dot(-normal, corner[0]), d});
    planes.push_back({normal, dot(normal, corner[7]), d});
  }
  return planes;
}

}  // namespace supple
