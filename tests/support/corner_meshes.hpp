/// Closed triangulated surfaces for tests: convex ones, and ones with pits, saddles and flat faces.
#pragma once
#include <cmath>

#include "supple/build/surfaces.hpp"
#include "supple/core/random.hpp"

namespace supple::testing {

/// The box from the origin to `size`, two triangles a side: edges between triangles of one plane are flat.
inline TriangleMesh box_mesh(const Vec3& size) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertex.push_back({(k & 1) ? size[0] : 0, (k & 2) ? size[1] : 0, (k & 4) ? size[2] : 0});
  mesh.face = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
               {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// What lies between the polygon at height 0 and at height `height`; its top and bottom are fans about the
/// vertex 0, from which all of a polygon must be seen.
inline TriangleMesh prism_mesh(const std::vector<Vec2>& ring, double height) {
  TriangleMesh mesh;
  const auto n = static_cast<std::int32_t>(ring.size());
  for (const double z : {0.0, height})
    for (const Vec2& x : ring) mesh.vertex.push_back({x[0], x[1], z});
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t next = (k + 1) % n;
    mesh.face.push_back({k, next, next + n});
    mesh.face.push_back({k, next + n, k + n});
    if (k == 0 || next == 0) continue;
    mesh.face.push_back({0, next, k});
    mesh.face.push_back({n, k + n, next + n});
  }
  return mesh;
}

/// A beam with an L-shaped cross section: one concave edge, whose ends are saddle corners.
inline TriangleMesh ell_mesh() { return prism_mesh({{2, 2}, {0, 2}, {0, 0}, {4, 0}, {4, 4}, {2.3, 4}}, 3); }

/// A geodesic sphere of radius 1 with a pit: what is within `angle` of the z axis is drawn toward the centre
/// by up to `depth`. Its rim is convex and its wall a ring of saddle corners.
inline TriangleMesh dented_sphere(int vertices, double depth, double angle) {
  TriangleMesh mesh = geodesic_icosahedron(vertices);
  for (Vec3& x : mesh.vertex) {
    x = (1 / norm(x)) * x;
    const double away = std::acos(x[2]) / angle;
    if (away < 1) x = (1 - depth * (1 - away * away) * (1 - away * away)) * x;
  }
  return mesh;
}

/// A geodesic sphere of radius 1 whose vertices are drawn toward the centre or away from it, each by up to
/// `height`: a star of spikes, pits and saddles of any kind.
inline TriangleMesh star_mesh(int vertices, double height, std::uint64_t seed) {
  TriangleMesh mesh = geodesic_icosahedron(vertices);
  RandomStream draw(seed, Purpose::test);
  for (Vec3& x : mesh.vertex) x = ((1 + height * draw.uniform(-1, 1)) / norm(x)) * x;
  return mesh;
}

/// A vertex on the x-y plane at the origin where `waves` ridges and as many valleys of height `height` meet,
/// on a cylinder of radius 2 below it: a saddle of many arcs.
inline TriangleMesh saddle_mesh(int waves, double height) {
  TriangleMesh mesh{{{0, 0, 0}, {0, 0, -3}}, {}};
  const int n = 4 * waves;
  for (const double z : {0.0, -3.0})
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.3) / n;
      mesh.vertex.push_back(
          {2 * std::cos(angle), 2 * std::sin(angle), z + (z < 0 ? 0 : height * std::cos(waves * angle))});
    }
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t next = (k + 1) % n;
    mesh.face.push_back({0, k + 2, next + 2});
    mesh.face.push_back({1, next + 2 + n, k + 2 + n});
    mesh.face.push_back({k + 2 + n, next + 2 + n, next + 2});
    mesh.face.push_back({k + 2 + n, next + 2, k + 2});
  }
  return mesh;
}

/// A thin body with edges of 20 degrees.
inline const TriangleMesh needle{{{0, 0, 0}, {4, 0.3, 0.1}, {4, -0.3, 0.2}, {4, 0, -0.6}},
                                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

}  // namespace supple::testing
