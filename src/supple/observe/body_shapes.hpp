/// The bodies of a cell laid out in space, each in one copy.
#pragma once
#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "supple/geometry/bounds.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// What a body covers. Rough: the polygon or polyhedron and a disc or sphere at every site, of the site's
/// radius. Smooth: everything within that radius of the polygon or polyhedron. A body of one site is a disc
/// or sphere either way.
enum class Outline { rough, smooth };

/// A body near the cell: a disc (one site) or a polygon, counter-clockwise.
struct BodyShape {
  std::vector<Vec2> ring;
  std::vector<double> radius;  ///< of the disc at each vertex; smooth: reach beyond the polygon
  Bounds bounds;               ///< of all that the body covers

  bool is_disc() const { return ring.size() == 1; }
  int size() const { return static_cast<int>(ring.size()); }
  int next(int i) const { return i + 1 < size() ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : size() - 1; }
  double distance_to_edge(int k, const Vec2& x) const;
  /// Exterior angle at vertex i [radian], positive where the ring turns left.
  double turn_at(int i) const;
};

/// A body near the cell: a sphere (one site) or a closed surface. Triangles and hinges are those of Topology,
/// with numbers of the body's own vertices.
struct BodySurface {
  std::vector<Vec3> vertex;
  std::vector<double> radius;  ///< of the sphere at each vertex; smooth: reach beyond the polyhedron
  std::vector<std::array<std::int32_t, 3>> face;
  std::vector<std::array<std::int32_t, 4>> hinge;
  BoundsOf<3> bounds;  ///< of all that the body covers

  bool is_sphere() const { return face.empty(); }
  int size() const { return static_cast<int>(vertex.size()); }
  /// The corners of a triangle or of a hinge.
  template <std::size_t N>
  std::array<Vec3, N> corners(const std::array<std::int32_t, N>& of) const {
    std::array<Vec3, N> x;
    for (std::size_t k = 0; k < N; ++k) x[k] = vertex[static_cast<std::size_t>(of[k])];
    return x;
  }
  /// Volume within the surface alone [length^3]; 0 for a sphere.
  double polyhedron() const;
};

template <int Dim>
using ShapeOf = std::conditional_t<Dim == 2, BodyShape, BodySurface>;

/// One copy of every body of any shape, the middle of its bounds brought into the cell. Throws an input error
/// on a cell without size and on a body without sites.
std::vector<BodyShape> lay_out_bodies(const System<2>& system);
std::vector<BodySurface> lay_out_bodies(const System<3>& system);

/// The same for bodies that must have an area or a volume. Throws an input error also on a ring that is
/// clockwise or has two neighbours in one place, a surface whose triangles look inward, a body of several
/// sites without either, a negative radius, a number that is not finite, and for smooth outlines a body of
/// unequal radii.
std::vector<BodyShape> body_shapes(const System<2>& system, Outline outline);
std::vector<BodySurface> body_shapes(const System<3>& system, Outline outline);

}  // namespace supple
