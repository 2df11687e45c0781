#include "supple/geometry/triangles_cross.hpp"

#include <algorithm>
#include <cmath>

#include "supple/geometry/orientation.hpp"

namespace supple {

namespace {

/// The sides of a plane on which the corners of a triangle are.
struct Sides {
  int corner[3];

  Sides(const Vec3 (&x)[3], const Vec3 (&plane)[3]) {
    for (int k = 0; k < 3; ++k) corner[k] = side_of_plane(x[k], plane[0], plane[1], plane[2]);
  }
  bool all_in_plane() const { return corner[0] == 0 && corner[1] == 0 && corner[2] == 0; }
  bool on_both() const {
    return std::min({corner[0], corner[1], corner[2]}) < 0 && std::max({corner[0], corner[1], corner[2]}) > 0;
  }
  /// The corner that is alone on its side, for a triangle with corners on both.
  int lone() const {
    for (int k = 0; k < 2; ++k)
      if (corner[k] != 0 && corner[k] != corner[(k + 1) % 3] && corner[k] != corner[(k + 2) % 3]) return k;
    return 2;
  }
};

/// Of triangles with corners on both sides of each other's plane: whether they cut the line of the planes
/// along a common segment.
bool share_a_segment(const Vec3 (&p)[3], const Sides& of_p, const Vec3 (&q)[3], const Sides& of_q) {
  const int i = of_p.lone(), j = of_q.lone();
  const Vec3 *p1 = &p[(i + 1) % 3], *p2 = &p[(i + 2) % 3], *q1 = &q[(j + 1) % 3], *q2 = &q[(j + 2) % 3];
  // The triangles are turned over so that each has the lone corner of the other above it. The segment of p
  // then runs from its edge to p2 to that to p1, the one of q from its edge to q1 to that to q2.
  if (of_p.corner[i] < 0) std::swap(q1, q2);
  if (of_q.corner[j] < 0) std::swap(p1, p2);
  return side_of_plane(*q1, p[i], *p1, q[j]) < 0 && side_of_plane(*q2, p[i], *p2, q[j]) > 0;
}

/// Whether triangles of one plane share an area: no edge of either has the other on its outer side.
bool share_an_area(const Vec3 (&p)[3], const Vec3 (&q)[3]) {
  const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
  int drop = 0;  // seen along the axis that the normal is nearest to
  for (int d = 1; d < 3; ++d)
    if (std::abs(normal[d]) > std::abs(normal[drop])) drop = d;
  Vec2 a[2][3];
  for (int k = 0; k < 3; ++k) {
    a[0][k] = {p[k][(drop + 1) % 3], p[k][(drop + 2) % 3]};
    a[1][k] = {q[k][(drop + 1) % 3], q[k][(drop + 2) % 3]};
  }
  for (int t = 0; t < 2; ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec2 &from = a[t][k], &to = a[t][(k + 1) % 3];
      const int inner = side_of_line(a[t][(k + 2) % 3], from, to);
      const auto outside = [&](const Vec2& x) { return side_of_line(x, from, to) * inner <= 0; };
      if (std::all_of(a[1 - t], a[1 - t] + 3, outside)) return false;
    }
  return true;
}

}  // namespace

TriangleMeeting meeting_of(const Vec3 (&p)[3], const Vec3 (&q)[3]) {
  const Sides of_q(q, p);
  if (of_q.all_in_plane())
    return Sides(p, q).all_in_plane() && share_an_area(p, q) ? TriangleMeeting::overlap
                                                             : TriangleMeeting::none;
  if (!of_q.on_both()) return TriangleMeeting::none;
  const Sides of_p(p, q);
  return of_p.on_both() && share_a_segment(p, of_p, q, of_q) ? TriangleMeeting::crossing
                                                             : TriangleMeeting::none;
}

}  // namespace supple
