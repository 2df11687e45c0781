/// A quick proof that a surface does not cross itself.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "supple/core/vec.hpp"

namespace supple {

/// Whether all of a closed surface is seen from `centre`, each triangle from its inner side: then the ray in
/// any direction meets it once, and it does not cross itself. Each triangle must form a tetrahedron of
/// positive volume with the centre, beyond rounding, and one ray must meet one triangle: the directions of
/// triangles then cover the sphere as often as that ray, as they can fold nowhere. False proves nothing.
inline bool is_seen_from(const Vec3& centre, std::span<const Vec3> vertex,
                         std::span<const std::array<std::int32_t, 3>> faces) {
  constexpr double rounding = 1e-12;
  if (faces.empty()) return false;
  const auto at = [&](std::int32_t k) { return vertex[static_cast<std::size_t>(k)] - centre; };
  const Vec3 ray = at(faces[0][0]) + 0.9 * at(faces[0][1]) + 0.8 * at(faces[0][2]);
  int met = 0;
  for (const auto& face : faces) {
    const Vec3 a = at(face[0]), b = at(face[1]), c = at(face[2]), across = cross(b, c);
    if (!(dot(a, across) > rounding * norm(a) * norm(b) * norm(c))) return false;
    met += dot(ray, across) >= 0 && dot(ray, cross(c, a)) >= 0 && dot(ray, cross(a, b)) >= 0;
  }
  return met == 1;
}

}  // namespace supple
