/// Triangle meshes for tests.
#pragma once
#include <cmath>
#include <numbers>

#include "supple/build/surfaces.hpp"
#include "supple/core/random.hpp"

namespace supple::testing {

/// A tetrahedron about `centre`, its triangles counter-clockwise as seen from outside.
inline TriangleMesh tetrahedron(const Vec3& centre = {}) {
  TriangleMesh mesh{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                    {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  for (Vec3& x : mesh.vertex) x += centre;
  return mesh;
}

/// Both meshes, the vertices of the second behind those of the first.
inline TriangleMesh joined(TriangleMesh first, const TriangleMesh& second) {
  const auto shift = static_cast<std::int32_t>(first.vertex.size());
  first.vertex.insert(first.vertex.end(), second.vertex.begin(), second.vertex.end());
  for (const auto& [a, b, c] : second.face) first.face.push_back({a + shift, b + shift, c + shift});
  return first;
}

/// A ring of radius 2 and thickness 2 * 0.7, of `around` times `across` vertices.
inline TriangleMesh torus(int around, int across) {
  TriangleMesh mesh;
  const double full = 2 * std::numbers::pi;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = full * i / around, b = full * j / across, r = 2 + 0.7 * std::cos(b);
      mesh.vertex.push_back({r * std::cos(a), r * std::sin(a), 0.7 * std::sin(b)});
    }
  const auto at = [&](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      mesh.face.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.face.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// A sphere of 162 vertices with deep dents: the distance of a vertex from the centre is 1 + 0.6 cos(5
/// phi) sin(theta)^2.
inline TriangleMesh star() {
  TriangleMesh mesh = geodesic_icosahedron(162);
  for (Vec3& x : mesh.vertex) {
    const double sine = std::hypot(x[0], x[1]) / norm(x);
    x = ((1 + 0.6 * std::cos(5 * std::atan2(x[1], x[0])) * sine * sine) / norm(x)) * x;
  }
  return mesh;
}

/// A random displacement for each of n vertices, components in [-1, 1).
inline std::vector<Vec3> random_moves(std::size_t n, int seed) {
  RandomStream draw(seed, Purpose::test);
  std::vector<Vec3> moves(n);
  for (Vec3& m : moves)
    for (int d = 0; d < 3; ++d) m[d] = draw.uniform(-1, 1);
  return moves;
}

/// Whether a triangle is pierced by the inside of a segment inside the triangle's edges, with the margin
/// 1e-12: the equation from + t (to - from) = t0 + u (t1 - t0) + v (t2 - t0), solved in extended numbers.
inline bool pierces(const Vec3& from, const Vec3& to, const Vec3 (&t)[3]) {
  using Long = VecOf<long double, 3>;
  const auto difference = [](const Vec3& a, const Vec3& b) {
    return Long{static_cast<long double>(a[0]) - b[0], static_cast<long double>(a[1]) - b[1],
                static_cast<long double>(a[2]) - b[2]};
  };
  const Long d = difference(from, to), u = difference(t[1], t[0]), v = difference(t[2], t[0]),
             r = difference(from, t[0]);
  const long double determinant = dot(d, cross(u, v));
  if (determinant == 0) return false;
  const long double along = dot(r, cross(u, v)) / determinant, a = dot(d, cross(r, v)) / determinant,
                    b = dot(d, cross(u, r)) / determinant, margin = 1e-12L;
  return along > margin && along < 1 - margin && a > margin && b > margin && a + b < 1 - margin;
}

/// Whether an edge of either triangle pierces the other: for triangles in general position, the same as that
/// they cross.
inline bool an_edge_pierces(const Vec3 (&p)[3], const Vec3 (&q)[3]) {
  for (int k = 0; k < 3; ++k)
    if (pierces(p[k], p[(k + 1) % 3], q) || pierces(q[k], q[(k + 1) % 3], p)) return true;
  return false;
}

}  // namespace supple::testing
