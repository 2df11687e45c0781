/// Systems of triangulated surfaces for tests.
#pragma once
#include <algorithm>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/core/random.hpp"

namespace supple::testing {

/// Moves every vertex of a mesh by up to `jitter` in each direction.
inline void shake(TriangleMesh& mesh, double jitter, RandomStream& draw) {
  for (Vec3& x : mesh.vertex)
    for (int d = 0; d < 3; ++d) x[d] += draw.uniform(-jitter, jitter);
}

/// The same surface with its triangles in another order, each from another corner on: another triangulation.
inline void reorder(TriangleMesh& mesh, RandomStream& draw) {
  for (std::size_t f = mesh.face.size() - 1; f > 0; --f)
    std::swap(mesh.face[f], mesh.face[draw.below(f + 1)]);
  for (auto& face : mesh.face)
    std::rotate(face.begin(), face.begin() + static_cast<int>(draw.below(3)), face.end());
}

/// Adds the mesh at `centre`, after its preferred shape has been taken from it and its vertices shaken.
inline void add_shaken(System<3>& system, TriangleMesh mesh, const Vec3& centre, const ShapeSpec& shape,
                       double jitter, RandomStream& draw) {
  const std::int32_t first = system.state.size();
  add_surface(system, mesh, 1, shape);
  shake(mesh, jitter, draw);
  for (std::size_t i = 0; i < mesh.vertex.size(); ++i)
    system.state.position[first + static_cast<std::int32_t>(i)] = centre + mesh.vertex[i];
}

struct SurfaceDraw {
  std::vector<int> vertices{12, 42, 162, 42, 12};  ///< of each body
  std::uint64_t seed = 1;
  ShapeSpec shape{.area = 1, .length = 1, .bending = 0.1, .tension = 0.05};
  double jitter = 0.04;  ///< of every vertex of a body of volume 1
  Vec3 first_centre{};   ///< of the first body; the others are beside it
};

/// Geodesic spheres shaken, which then have hinges of many angles, concave ones too.
inline System<3> random_surfaces(const SurfaceDraw& draw = {}) {
  System<3> system;
  const auto bodies = static_cast<double>(draw.vertices.size());
  system.box.length = {2.0 * bodies, 3, 3};
  for (std::size_t b = 0; b < draw.vertices.size(); ++b) {
    RandomStream stream(draw.seed, Purpose::test, b);
    add_shaken(system, geodesic_icosahedron(draw.vertices[b]),
               draw.first_centre + Vec3{2.0 * static_cast<double>(b), 0, 0}, draw.shape, draw.jitter, stream);
  }
  return system;
}

}  // namespace supple::testing
