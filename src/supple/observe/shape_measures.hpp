/// Sizes and shapes of bodies.
#pragma once
#include <optional>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// Of each body. A polygon is that of its sites, without the discs at them; a body of one site is its disc.
struct ShapeMeasures {
  std::vector<double> area, perimeter;  ///< [length^2], [length]
  std::vector<double>
      shape_parameter;  ///< p^2/(4 pi a), at least N tan(pi/N)/pi for N vertices; 0 for a body of one site
  std::vector<Vec2> centre;  ///< of the area, in the unwrapped copy
};

ShapeMeasures measure_shapes(const System<2>& system);

/// Over the polygons: discs have none. Nothing where there are none.
std::optional<double> mean_shape_parameter(const ShapeMeasures& shapes);

}  // namespace supple
