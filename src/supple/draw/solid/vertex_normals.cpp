#include "supple/draw/solid/vertex_normals.hpp"

namespace supple {

std::vector<Vec3> vertex_normals(const SolidScene& scene) {
  std::vector<Vec3> normal(scene.vertex.size());
  for (const SolidTriangle& t : scene.triangle) {
    const auto [a, b, c] = t.vertex;
    const Vec3 area = cross(scene.vertex[b] - scene.vertex[a], scene.vertex[c] - scene.vertex[a]);
    for (const std::int32_t v : t.vertex) normal[v] += area;
  }
  for (Vec3& n : normal)
    if (const double length = norm(n); length > 0) n *= 1 / length;
  return normal;
}

}  // namespace supple
