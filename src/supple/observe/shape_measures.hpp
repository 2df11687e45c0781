/// Sizes and shapes of bodies.
#pragma once
#include <optional>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// Measures of each body: of the polygon or polyhedron of its sites, without the discs or spheres there; of a
/// body of one site, of its disc or sphere.
template <int Dim>
struct ShapeMeasures {
  std::vector<double> volume;   ///< area in 2D [length^2], volume in 3D [length^3]
  std::vector<double> surface;  ///< perimeter in 2D [length], area of the surface in 3D [length^2]
  /// 2D: p^2/(4 pi a), at least N tan(pi/N)/pi for N vertices. 3D: s^1.5/(6 sqrt(pi) v), at least 1. 0 for a
  /// body of one site.
  std::vector<double> shape_parameter;
  std::vector<Vec<Dim>> centre;  ///< of the area or volume, in the unwrapped copy
};

ShapeMeasures<2> measure_shapes(const System<2>& system);
ShapeMeasures<3> measure_shapes(const System<3>& system);

/// Mean shape parameter of the bodies of more than one site, as discs and spheres have none. Nothing where
/// there is no other body.
template <int Dim>
std::optional<double> mean_shape_parameter(const ShapeMeasures<Dim>& shapes) {
  double sum = 0, bodies = 0;
  for (const double a : shapes.shape_parameter)
    if (a > 0) sum += a, ++bodies;
  if (bodies == 0) return std::nullopt;
  return sum / bodies;
}

}  // namespace supple
