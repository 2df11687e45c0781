/// Sizes and shapes of bodies.
#pragma once
#include <optional>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// Measures of each body: of the polygon of its sites, without the discs there; of a body of one site, of its
/// disc.
struct ShapeMeasures {
  std::vector<double> area, perimeter;  ///< [length^2], [length]
  std::vector<double>
      shape_parameter;  ///< p^2/(4 pi a), at least N tan(pi/N)/pi for N vertices; 0 for a body of one site
  std::vector<Vec2> centre;  ///< of the area, in the unwrapped copy
};

ShapeMeasures measure_shapes(const System<2>& system);

/// Mean shape parameter of the polygons, as discs have none. Nothing where there is no polygon.
std::optional<double> mean_shape_parameter(const ShapeMeasures& shapes);

}  // namespace supple
