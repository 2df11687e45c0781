/// Sizes and shapes of bodies, and bodies that have got into each other.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// Of each body. A polygon is that of its sites, without the discs at them; a body of one site is its disc.
struct ShapeMeasures {
  std::vector<double> area, perimeter;  ///< [length^2], [length]
  std::vector<double>
      shape_parameter;       ///< p^2/(4 pi a), at least N tan(pi/N)/pi for N vertices; 0 for a body of one site
  std::vector<Vec2> centre;  ///< of the area, in the unwrapped copy
};

ShapeMeasures measure_shapes(const System<2>& system);

/// Bodies with a site inside the polygon of another body (find_sites_inside), ascending: vertices have passed an edge.
std::vector<std::int32_t> bodies_inside_others(const System<2>& system);

}  // namespace supple
