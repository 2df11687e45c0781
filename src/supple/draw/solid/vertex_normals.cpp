#include "supple/draw/solid/vertex_normals.hpp"

#include <cmath>

namespace supple {

std::vector<Vec3> vertex_normals(const SolidScene& scene) {
  std::vector<Vec3> normal(scene.vertex.size());
  for (const SolidTriangle& t : scene.triangle)
    for (int k = 0; k < 3; ++k) {
      const Vec3& at = scene.vertex[t.vertex[k]];
      const Vec3 a = scene.vertex[t.vertex[(k + 1) % 3]] - at, b = scene.vertex[t.vertex[(k + 2) % 3]] - at;
      const Vec3 area = cross(a, b);
      const double twice = norm(area);
      if (twice > 0) normal[t.vertex[k]] += (std::atan2(twice, dot(a, b)) / twice) * area;
    }
  for (Vec3& n : normal)
    if (const double length = norm(n); length > 0) n *= 1 / length;
  return normal;
}

}  // namespace supple
