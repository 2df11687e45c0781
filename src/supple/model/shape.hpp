/// The preferred shape of deformable bodies: stiffnesses and rest values of the shape energy. Plastic flow
/// may change the rest values.
#pragma once
#include <vector>

namespace supple {

/// Stiffnesses of the shape energy of one body [MacKeith 2025, eq. 9.1-9.2]; v enclosed area (volume), l
/// length of an edge (area of a triangle), theta angle of a hinge:
///     U = (volume/2)(v - v0)^2 + sum (facet/2)(l - l0)^2 + sum (hinge/2)(theta - theta0)^2 + tension sum l.
struct ShapeStiffness {
  double volume = 0;   ///< k_a [energy/length^4] in 2D
  double facet = 0;    ///< k_l [energy/length^2] in 2D
  double hinge = 0;    ///< k_b [energy]
  double tension = 0;  ///< gamma [energy/length] in 2D
};

/// Stiffnesses and rest volume of each body, and rest values aligned with Topology::facet and ::hinge. Empty:
/// no body has a shape energy.
struct Shape {
  std::vector<ShapeStiffness> stiffness;       ///< of each body; 0 for discs and rigid bodies
  std::vector<double> rest_volume;             ///< of each body; an area in 2D [length^2]
  std::vector<double> rest_facet, rest_hinge;  ///< of edges in 2D [length]; of corners [radian]

  bool empty() const { return stiffness.empty(); }
};

}  // namespace supple
