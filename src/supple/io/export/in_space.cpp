#include "supple/io/export/in_space.hpp"

#include <algorithm>

#include "supple/draw/scene/drawn_cell.hpp"

namespace supple {

template <int Dim>
SpaceCell space_cell(const BodyScene<Dim>& scene) {
  SpaceCell cell;
  const std::array<Vec<Dim>, Dim> edges = cell_edges(scene.box);
  for (int d = 0; d < Dim; ++d) {
    cell.edge[d] = in_space(edges[d]);
    cell.periodic[d] = scene.box.periodic[d];
  }
  cell.origin = in_space(cell_corners(scene.box)[0]);
  if constexpr (Dim == 2) {
    const double thickest =
        scene.radius.empty() ? 0 : *std::max_element(scene.radius.begin(), scene.radius.end());
    const double depth = thickest > 0 ? 2 * thickest : 1;
    cell.edge[2] = {0, 0, depth};
    cell.periodic[2] = false;
    cell.origin[2] = -0.5 * depth;
  }
  return cell;
}

template SpaceCell space_cell(const BodyScene<2>&);
template SpaceCell space_cell(const BodyScene<3>&);

}  // namespace supple
