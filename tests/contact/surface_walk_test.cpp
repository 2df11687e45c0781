#include "supple/contact/surface_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/corner_meshes.hpp"
#include "tests/support/surface_probe.hpp"

namespace supple {
namespace {

using namespace testing;

Vec3 draw_point(RandomStream& draw, double most) {
  return {draw.uniform(-most, most), draw.uniform(-most, most), draw.uniform(-most, most)};
}

/// A point in the box of the mesh and `margin` around.
Vec3 draw_near(RandomStream& draw, const TriangleMesh& mesh, double margin) {
  Vec3 low = mesh.vertex[0], high = low;
  for (const Vec3& x : mesh.vertex)
    for (int d = 0; d < 3; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  Vec3 p;
  for (int d = 0; d < 3; ++d) p[d] = draw.uniform(low[d] - margin, high[d] + margin);
  return p;
}

double phi(double d, double sigma) { return d < sigma ? 0.5 * (sigma - d) * (sigma - d) : 0; }

TEST(PatchInReach, IsTheMinimumDistanceOutsideOfConvexBodies) {
  for (const TriangleMesh& mesh : {box_mesh({2, 1, 0.4}), geodesic_icosahedron(42, 3), needle}) {
    ASSERT_GT(enclosed_volume(mesh), 0);
    const SurfaceProbe probe(mesh, 1.1);
    RandomStream draw(7, Purpose::test);
    int touched = 0;
    for (int k = 0; k < 4000; ++k) {
      const Vec3 p = draw_near(draw, mesh, 1);
      if (probe.inside(p)) continue;
      const double d = probe.distance(p), u = phi(d, probe.sigma);
      ASSERT_NEAR(probe.energy(p), u, 1e-12) << p[0] << ", " << p[1] << ", " << p[2];
      ASSERT_NEAR(norm(probe.force(p)), std::max(0.0, probe.sigma - d), 1e-12);
      ASSERT_EQ(probe.met(p).euler, u > 0 ? 1 : 0);
      touched += u > 0;
    }
    EXPECT_GT(touched, 1000);
  }
}

/// Outside, where nothing within sigma is seen from behind: faces minus edges plus vertices, distances to
/// closed triangles and segments.
TEST(PatchInReach, CountsFacesMinusEdgesPlusVertices) {
  int many = 0, tested = 0, two_arcs = 0;
  for (const TriangleMesh& mesh : {ell_mesh(), dented_sphere(162, 0.7, 0.9), star_mesh(42, 0.35, 3),
                                   saddle_mesh(2, 0.8), saddle_mesh(3, 0.8), saddle_mesh(4, 0.5)}) {
    const SurfaceProbe probe(mesh, 0.5);
    RandomStream draw(8, Purpose::test);
    for (int k = 0; k < 4000; ++k) {
      const Vec3 p = draw_near(draw, mesh, 0.4);
      if (probe.inside(p)) continue;
      double u = 0, twice_euler = 0;
      bool behind = false;
      for (const auto& face : mesh.face) {
        const ClosestOnTriangle at = probe.closest(p, face);
        u += phi(norm(at.from), probe.sigma);
        twice_euler += 2 * (norm(at.from) < probe.sigma);
        for (std::size_t e = 0; e < 3; ++e) {  // half of each edge, as each has two triangles
          const double d =
              norm(closest_on_segment(p, mesh.vertex[face[e]], mesh.vertex[face[(e + 1) % 3]]).from);
          u -= 0.5 * phi(d, probe.sigma);
          twice_euler -= d < probe.sigma;
        }
        behind = behind || (norm(at.from) < probe.sigma && dot(at.from, at.normal) < 0);
      }
      if (behind) continue;
      for (const Vec3& x : mesh.vertex) {
        u += phi(norm(p - x), probe.sigma);
        twice_euler += 2 * (norm(p - x) < probe.sigma);
      }
      ASSERT_EQ(2 * probe.met(p).euler, twice_euler);
      ASSERT_NEAR(probe.energy(p), u, 1e-13) << p[0] << ", " << p[1] << ", " << p[2];
      tested += u > 0;
      int parts = 0;
      probe.meet(p, [&](const smooth::SurfaceFoot& foot) {
        ++parts;
        two_arcs += foot.sites == 1 && foot.sign < 0;
      });
      many += parts > 1;
    }
  }
  EXPECT_GT(tested, 2000);
  EXPECT_GT(many, 100);
  EXPECT_GT(two_arcs, 5) << "of saddle corners";
}

/// What a point meets, and the force on it.
struct Met {
  std::vector<std::array<std::int32_t, 5>> parts;  ///< of each: how many sites, which, and the sign
  Vec3 force{};

  Met(const SurfaceProbe& probe, const Vec3& p) {
    probe.meet(p, [&](const smooth::SurfaceFoot& foot) {
      parts.push_back({foot.sites, foot.site[0], foot.site[1], foot.site[2], foot.sign});
      force += foot.sign * (probe.sigma - foot.distance) * foot.normal;
    });
    std::ranges::sort(parts);
  }
};

/// The force along a line, which is smooth while the point meets the same parts: each change of them is
/// closed in by halving, down to 2^-28 of the line.
struct ForceOnLine {
  const SurfaceProbe& probe;
  Vec3 a, along;
  double largest_jump = 0;
  int changes = 0;

  ForceOnLine(const SurfaceProbe& surface, const Vec3& from, const Vec3& to, int steps)
      : probe(surface), a(from), along(to - from) {
    Met low(probe, a);
    for (int s = 1; s <= steps; ++s) {
      Met high(probe, a + static_cast<double>(s) / steps * along);
      close_in(static_cast<double>(s - 1) / steps, static_cast<double>(s) / steps, low, high);
      low = std::move(high);
    }
  }

 private:
  void close_in(double from, double to, const Met& low, const Met& high) {
    if (low.parts == high.parts) return;
    if (to - from < std::ldexp(1, -28)) {
      ++changes;
      largest_jump = std::max(largest_jump, norm(high.force - low.force));
      return;
    }
    const double middle = 0.5 * (from + to);
    const Met between(probe, a + middle * along);
    close_in(from, middle, low, between);
    close_in(middle, to, between, high);
  }
};

/// Ten thousand lines round corners of every kind, wherever they stay outside, at any size of the patch.
TEST(PatchInReach, ForceHasNoJumpOutside) {
  double moved = 0;
  int lines = 0, changes = 0;
  for (const TriangleMesh& mesh : {geodesic_icosahedron(42, 3), ell_mesh(), dented_sphere(42, 0.7, 1.1),
                                   star_mesh(42, 0.5, 4), saddle_mesh(2, 0.8), saddle_mesh(3, 0.8), needle}) {
    const SurfaceProbe probe(mesh, 0.6);
    RandomStream draw(9, Purpose::test);
    for (int k = 0; k < 1500; ++lines) {
      const Vec3 a = draw_near(draw, mesh, 0.3), b = a + draw_point(draw, 0.3);
      const double clear = norm(b - a);
      // The line keeps 0.02 away from the surface: nearer, forces turn fast.
      if (probe.inside(a) || probe.distance(0.5 * (a + b)) < 0.5 * clear + 0.02) continue;
      ++k;
      const ForceOnLine line(probe, a, b, 8);
      ASSERT_LT(line.largest_jump, 1e-7 * probe.sigma)
          << "line " << k << " from " << a[0] << ", " << a[1] << ", " << a[2];
      changes += line.changes;
      moved += norm(probe.force(a) - probe.force(b));
    }
  }
  EXPECT_GT(moved, 100) << "nothing acted";
  EXPECT_GT(changes, 5000) << "the point met the same all the way";
}

/// Into the body through every triangle, also where other parts are near: nothing jumps on the way.
TEST(PatchInReach, GoesOnSmoothlyWhereAPointCrossesAFace) {
  for (const TriangleMesh& mesh : {box_mesh({2, 1, 0.4}), ell_mesh(), dented_sphere(42, 0.7, 1.1),
                                   star_mesh(42, 0.5, 4), saddle_mesh(3, 0.8)}) {
    const SurfaceProbe probe(mesh, 0.6);
    RandomStream draw(10, Purpose::test);
    for (const auto& face : mesh.face)
      for (int times = 0; times < 20; ++times) {
        const double a = draw.uniform(0.02, 0.9), b = draw.uniform(0.01, 0.98 - a);
        const Vec3 &x = mesh.vertex[face[0]], u = mesh.vertex[face[1]] - x, v = mesh.vertex[face[2]] - x,
                   normal = (1 / norm(cross(u, v))) * cross(u, v), at = x + a * u + b * v;
        const Vec3 above = at + 1e-9 * normal, below = at - 1e-9 * normal;
        ASSERT_FALSE(probe.inside(above));
        ASSERT_TRUE(probe.inside(below));
        ASSERT_NEAR(probe.energy(above), probe.energy(below), 1e-8);
        ASSERT_LT(norm(probe.force(above) - probe.force(below)), 1e-6);
        ASSERT_EQ(probe.met(above).euler, probe.met(below).euler);
      }
  }
}

/// The side of the nearest part against the number of times that the surface winds about the point.
TEST(PatchInReach, FindsEveryPointThatIsInside) {
  int inside = 0, outside = 0;
  for (const TriangleMesh& mesh :
       {ell_mesh(), dented_sphere(42, 0.7, 1.1), star_mesh(42, 0.5, 4), saddle_mesh(3, 0.8), needle}) {
    const SurfaceProbe probe(mesh, 0.6);
    RandomStream draw(12, Purpose::test);
    for (int k = 0; k < 2000; ++k) {
      const Vec3 p = draw_near(draw, mesh, 0.3);
      if (!(probe.distance(p) < probe.sigma)) continue;
      bool found = false;
      probe.meet(p, [&](const smooth::SurfaceFoot& foot) { found = found || foot.distance < 0; });
      ASSERT_EQ(found, probe.inside(p)) << p[0] << ", " << p[1] << ", " << p[2];
      (found ? inside : outside) += 1;
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

TEST(PatchInReach, PushesOutWithTheDepth) {
  const SurfaceProbe box(box_mesh({3, 3, 3}), 0.8);
  EXPECT_NEAR(box.energy({1.4, 1.2, 0.3}), 0.5 * 1.1 * 1.1, 1e-13);
  EXPECT_NEAR(box.force({1.4, 1.2, 0.3})[2], -1.1, 1e-13);
  EXPECT_NEAR(box.force({2.8, 1.2, 0.3})[0], 1.0, 1e-13) << "the nearest side";
  EXPECT_EQ(box.energy({1.5, 1.5, 1.5}), 0) << "deeper than sigma";
  // Behind the concave edge of the beam, which runs along z at (2, 2), and of two other kinds of vertices.
  const SurfaceProbe ell(ell_mesh(), 0.4);
  EXPECT_NEAR(ell.energy({2.1, 1.9, 1.3}), phi(-std::sqrt(0.02), 0.4), 1e-13);
  const SurfaceProbe pit(dented_sphere(42, 0.7, 1.1), 0.4);
  const Vec3 bottom = *std::min_element(pit.mesh.vertex.begin(), pit.mesh.vertex.end(),
                                        [](const Vec3& a, const Vec3& b) { return norm(a) < norm(b); });
  EXPECT_NEAR(pit.energy(0.9 * bottom), phi(-0.1 * norm(bottom), 0.4), 1e-13);
  EXPECT_LT(dot(pit.force(0.9 * bottom), -bottom), 0) << "out through the bottom of the pit";
}

/// Also exactly over, or on, edges and vertices between triangles of one plane, and of none.
TEST(PatchInReach, CountsOnceOnBorders) {
  const TriangleMesh mesh = box_mesh({2, 1, 0.4});
  const SurfaceProbe probe(mesh, 0.3);
  for (const auto& hinge : hinges_of(mesh))
    for (const double t : {0.25, 0.5}) {
      const Vec3 on = mesh.vertex[hinge[0]] + t * (mesh.vertex[hinge[1]] - mesh.vertex[hinge[0]]);
      const Vec3 out = on - Vec3{1, 0.5, 0.2};
      for (const double away : {0.0, 0.1, 0.2}) {
        const Vec3 p = on + (away / norm(out)) * out;
        ASSERT_NEAR(probe.energy(p), phi(probe.distance(p), 0.3), 1e-13);
        ASSERT_NEAR(norm(probe.force(p)), 0.3 - probe.distance(p), 1e-13);
        ASSERT_EQ(probe.met(p).euler, 1);
      }
    }
  EXPECT_NEAR(probe.energy({1, 0.5, 0.5}), phi(0.1, 0.3), 1e-15) << "over a flat edge";
  EXPECT_NEAR(probe.energy({1, 0.5, 0.3}), phi(-0.1, 0.3), 1e-15) << "and under it";
  for (const TriangleMesh& any : {mesh, ell_mesh(), star_mesh(42, 0.5, 4), saddle_mesh(3, 0.8)}) {
    const SurfaceProbe on(any, 0.2);
    for (const Vec3& x : any.vertex) {
      EXPECT_NEAR(on.energy(x), phi(0, 0.2), 1e-13);
      EXPECT_NEAR(norm(on.force(x)), 0.2, 1e-13);
    }
  }
}

TEST(PatchInReach, SaysWhereThePatchIsNoDisc) {
  const SurfaceProbe ell(ell_mesh(), 0.5);
  EXPECT_EQ(ell.met({1.6, 2.4, 1.3}).euler, 2) << "both sides of the corner, but not yet the corner";
  EXPECT_EQ(ell.met({1.7, 2.3, 1.3}).euler, 1);
  const TriangleMesh dented = dented_sphere(642, 0.7, 0.8);
  double floor = 1;
  for (const Vec3& x : dented.vertex) floor = std::min(floor, norm(x));
  const SurfaceProbe pit(dented, 0.45);
  int rings = 0, discs = 0;
  for (double z = floor + 0.02; z < 1.3; z += 0.02) {
    const smooth::MetParts met = pit.met({0.003, 0.002, z});
    rings += met.parts > 0 && met.euler == 0;
    discs += met.euler == 1;
    ASSERT_TRUE(met.parts > 0 || z > floor + 0.4);
  }
  EXPECT_GT(rings, 3) << "the wall of the pit, without its bottom";
  EXPECT_GT(discs, 3);
}

/// Slopes of U by every coordinate, and what follows: no net force or torque, and the virial.
TEST(PatchInReach, ForcesAreSlopesOfTheEnergy) {
  int inside = 0, edges = 0, corners = 0, negative = 0;
  for (const TriangleMesh& mesh :
       {ell_mesh(), star_mesh(42, 0.5, 4), saddle_mesh(3, 0.8), saddle_mesh(4, 0.5)}) {
    SurfaceProbe probe(mesh, 0.5);
    RandomStream draw(11, Purpose::test);
    for (int tested = 0; tested < 100;) {
      Vec3 p = draw_near(draw, mesh, 0.3);
      if (tested % 2) p = mesh.vertex[draw.below(mesh.vertex.size())] + draw_point(draw, 0.3);
      const double d = probe.distance(p);
      if (d < 0.05 || d > 0.45) continue;
      ++tested;
      std::vector<Vec3> force(mesh.vertex.size() + 1);
      Mat<3> virial;
      probe.meet(p, [&](const smooth::SurfaceFoot& foot) {
        const Vec3 push = (foot.sign * (probe.sigma - foot.distance)) * foot.normal;
        force.back() += push;
        for (int k = 0; k < foot.sites; ++k) force[foot.site[k]] -= foot.weight[k] * push;
        virial.add_outer(foot.distance, push, foot.normal);
        inside += foot.distance < 0;
        edges += foot.sites == 2;
        corners += foot.sites == 1;
        negative += foot.sign < 0;
      });
      const double h = 1e-6;
      Vec3 net{}, torque{};
      Mat<3> moment;
      for (std::size_t i = 0; i < force.size(); ++i) {
        Vec3& x = i + 1 < force.size() ? probe.mesh.vertex[i] : p;
        for (int c = 0; c < 3; ++c) {
          const double x0 = x[c];
          x[c] = x0 + h;
          const double above = probe.energy(p);
          x[c] = x0 - h;
          const double below = probe.energy(p);
          x[c] = x0;
          ASSERT_NEAR(force[i][c], (below - above) / (2 * h), 1e-7) << "site " << i;
        }
        net += force[i];
        torque += cross(x, force[i]);
        moment.add_outer(1, force[i], x);
      }
      ASSERT_LT(norm(net), 1e-14);
      ASSERT_LT(norm(torque), 1e-13);
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) ASSERT_NEAR(virial[a][b], moment[a][b], 1e-13);
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(edges, 50);
  EXPECT_GT(corners, 15);
  EXPECT_GT(negative, 15);
}

}  // namespace
}  // namespace supple
