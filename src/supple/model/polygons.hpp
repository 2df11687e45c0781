/// Builders of deformable particles: polygons, their preferred shapes, and the families of Table 9.1.
#pragma once
#include <string>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// How the stiffnesses of a family [MacKeith 2025, Table 9.1] are meant.
enum class StiffnessKind {
  absolute,  ///< (k_a/2)(a - a0)^2, (k_l/2)(l - l0)^2: energy/length^4, energy/length^2
  relative   ///< (k_a/2)(a/a0 - 1)^2, (k_l/2)(l/l0 - 1)^2: energy
};

/// Shape energy of one particle before its size is known: k_a, k_l, k_b and gamma, in this order. Relative
/// line tension has the energy gamma p/p0, p the perimeter; bending is the same in both kinds.
struct ShapeSpec {
  double area = 1, length = 1, bending = 0, tension = 0;
  StiffnessKind kind = StiffnessKind::relative;
  /// Preferred shape parameter A0 = p0^2/(4 pi a0), p0 the preferred perimeter and a0 the preferred area; 0:
  /// that of the regular polygon, the least possible.
  double shape_parameter = 0;
  /// Rest angle of every corner: 2 pi/N (true) or 0 [radian]. The choice changes no force, as the angles sum
  /// to 2 pi.
  bool regular_angles = true;
};

/// Adds a regular polygon of n >= 3 vertices with preferred area a0 [length^2] about a centre, its first
/// vertex at `angle`, and gives it its preferred shape; it starts with area a0, so that a shape parameter
/// above the least one means edges under compression. Vertices have mass 1 and diameter sigma =
/// `diameter_ratio` l0. Input errors on bad numbers.
void add_polygon(System<2>& system, const Vec2& centre, double a0, int n, double angle, double diameter_ratio,
                 const ShapeSpec& shape);

/// Adds a smooth disc: a body of one site of mass 1. All bodies of a system must be added by these functions.
void add_disc_body(System<2>& system, const Vec2& centre, double radius);

/// Adds a polygon of these vertices as they are (counter-clockwise, unwrapped), each of mass 1 and this
/// radius [length], with its own rest area, rest length of each edge and rest angle of each corner (see
/// Topology). Input error where there are less than three or the lists differ in length.
void add_ring(System<2>& system, const std::vector<Vec2>& vertices, double radius,
              const ShapeStiffness& stiffness, double rest_area, const std::vector<double>& rest_length,
              const std::vector<double>& rest_angle);

/// N tan(pi/N)/pi, the shape parameter p^2/(4 pi a) of a regular polygon, the least that n edges allow.
double least_shape_parameter(int n);

/// Absolute stiffnesses (ShapeStiffness) of a particle of n edges with preferred area a0 and edge length l0.
ShapeStiffness absolute_stiffness(const ShapeSpec& shape, double a0, double l0, int n);

}  // namespace supple
