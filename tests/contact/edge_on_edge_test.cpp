/// Two surfaces whose edges touch first: contacts are of vertices, and these must notice.
#include <gtest/gtest.h>

#include "supple/contact/edge_cover.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_surfaces.hpp"
#include "supple/core/error.hpp"
#include "supple/force/force_field.hpp"
#include "tests/support/corner_meshes.hpp"
#include "tests/support/surface_probe.hpp"

namespace supple {
namespace {

using namespace testing;

/// A convex mesh with this edge along x, the point at `share` of it at the origin, and all of the mesh below
/// z = 0: `lean` in (0, 1) says which plane through the edge that is, from one of its triangles to the other.
TriangleMesh with_edge_on_top(TriangleMesh mesh, const std::array<std::int32_t, 4>& hinge, double share,
                              double lean) {
  const auto x = [&](std::size_t k) { return mesh.vertex[hinge[k]]; };
  const Vec3 edge = x(1) - x(0), origin = x(0) + share * edge, left = cross(edge, x(2) - x(0)),
             right = cross(x(3) - x(0), edge);
  const Vec3 up = (1 - lean) * ((1 / norm(left)) * left) + lean * ((1 / norm(right)) * right),
             e = (1 / norm(edge)) * edge, n = (1 / norm(up)) * up, t = cross(n, e);
  for (Vec3& v : mesh.vertex) {
    const Vec3 r = v - origin;
    v = {dot(r, e), dot(r, t), dot(r, n)};
  }
  return mesh;
}

/// Turned over, about x, and then by an angle about z.
TriangleMesh upside_down(TriangleMesh mesh, double angle) {
  for (Vec3& v : mesh.vertex) {
    const double x = v[0], y = -v[1];
    v = {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, -v[2]};
  }
  return mesh;
}

/// What two wedges that touch are like: numbers in [0, 1), some for each wedge and one for the angle.
using Numbers = std::array<double, 13>;

/// A wedge with an edge of length 1 on top and two more vertices below, by the first six numbers from
/// `first`.
TriangleMesh wedge(const Numbers& u, std::size_t first) {
  const double depth = 0.1 + 0.8 * u[first], width = 0.01 + 0.3 * u[first + 1];
  const TriangleMesh mesh{{{0, 0, 0},
                           {1, 0, 0},
                           {0.3 + 0.4 * u[first + 2], width, -depth},
                           {0.3 + 0.4 * u[first + 3], -width, -depth}},
                          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  return with_edge_on_top(mesh, hinges_of(mesh)[0], 0.01 + 0.98 * u[first + 4], 0.1 + 0.8 * u[first + 5]);
}

/// Two bodies at the instant when their edges touch.
struct Touch {
  TriangleMesh below, above;
};

Touch touch_of(const Numbers& u) { return {wedge(u, 0), upside_down(wedge(u, 6), 6.3 * u[12])}; }

Numbers draw_numbers(RandomStream& draw) {
  Numbers u;
  for (double& x : u) x = draw.uniform(0, 1);
  return u;
}

double longest_edge(const TriangleMesh& mesh) {
  double longest = 0;
  for (const auto& f : mesh.face)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, norm(mesh.vertex[f[k]] - mesh.vertex[f[(k + 1) % 3]]));
  return longest;
}

/// Least distance of a vertex of either from the surface (smooth), or from a vertex (rough), of the other,
/// over the longest edge.
double smooth_distance(const Touch& touch) {
  const SurfaceProbe below(touch.below, 1), above(touch.above, 1);
  double least = 1e300;
  for (const Vec3& x : touch.above.vertex) least = std::min(least, below.distance(x));
  for (const Vec3& x : touch.below.vertex) least = std::min(least, above.distance(x));
  return least / std::max(longest_edge(touch.below), longest_edge(touch.above));
}
double rough_distance(const Touch& touch) {
  double least = 1e300;
  for (const Vec3& x : touch.above.vertex)
    for (const Vec3& y : touch.below.vertex) least = std::min(least, norm(x - y));
  return least / std::max(longest_edge(touch.below), longest_edge(touch.above));
}

/// The touch that is hardest to see: the worst of 10000 at random, made worse by small changes.
template <class Distance>
Numbers worst_touch(std::uint64_t seed, const Distance& distance) {
  RandomStream draw(seed, Purpose::test);
  Numbers worst{};
  double largest = 0;
  const auto look = [&](const Numbers& u) {
    const double d = distance(touch_of(u));
    if (d > largest) largest = d, worst = u;
  };
  for (int k = 0; k < 10000; ++k) look(draw_numbers(draw));
  for (int k = 0; k < 10000; ++k) {
    Numbers u = worst;
    const double step = k < 5000 ? 0.1 : 0.01;
    for (double& x : u) x = std::clamp(x + step * draw.uniform(-1, 1), 0.0, 0.999);
    look(u);
  }
  return worst;
}

TEST(EdgeOnEdge, IsSeenFromHalfOfTheLongestEdgeOnAndRoughFromItsRoot) {
  const double smooth = smooth_distance(touch_of(worst_touch(1, smooth_distance))),
               rough = rough_distance(touch_of(worst_touch(2, rough_distance)));
  RecordProperty("smooth", std::to_string(smooth));
  RecordProperty("rough", std::to_string(rough));
  EXPECT_LT(smooth, least_smooth_diameter);
  EXPECT_GT(smooth, 0.97 * least_smooth_diameter);
  EXPECT_LT(rough, least_rough_diameter);
  EXPECT_GT(rough, 0.97 * least_rough_diameter);
}

/// Round bodies of small triangles need less.
TEST(EdgeOnEdge, OfGeodesicSpheres) {
  for (const int vertices : {12, 42}) {
    RandomStream draw(2, Purpose::test);
    const TriangleMesh sphere = geodesic_icosahedron(vertices);
    const auto hinges = hinges_of(sphere);
    const auto put = [&] {
      return with_edge_on_top(sphere, hinges[draw.below(hinges.size())], draw.uniform(0.01, 0.99),
                              draw.uniform(0.1, 0.9));
    };
    double smooth = 0, rough = 0;
    for (int k = 0; k < 1000; ++k) {
      const Touch touch{put(), upside_down(put(), draw.uniform(0, 6.3))};
      smooth = std::max(smooth, smooth_distance(touch));
      rough = std::max(rough, rough_distance(touch));
    }
    RecordProperty("smooth " + std::to_string(vertices), std::to_string(smooth));
    RecordProperty("rough " + std::to_string(vertices), std::to_string(rough));
    EXPECT_LT(smooth, 0.2);
    EXPECT_LT(rough, 0.6);
  }
}

double energy_at(const Touch& touch, const BodyContacts<3>& contacts, double diameter) {
  System<3> system;
  system.box.length = {100, 100, 100};
  system.box.periodic = {false, false, false};
  for (const TriangleMesh& mesh : {touch.below, touch.above})
    add_surface(system, mesh, 0.5 * diameter, {}, 1, std::vector<double>(mesh.face.size(), 1),
                std::vector<double>(mesh.face.size() * 3 / 2, 1));
  ForceField<3> field(contacts);
  Evaluation<3> out;
  field.evaluate(system, Detail::energies, out);
  return out.energy.elastic;
}

/// The same by the contacts themselves: above the least diameter something acts at every touch, below not at
/// the worst.
TEST(EdgeOnEdge, ContactsResistAtTheLeastDiameter) {
  const SmoothSurfaces smooth(Harmonic{1});
  const RoughContacts<3> rough(Harmonic{1});
  RandomStream draw(3, Purpose::test);
  std::vector<Numbers> touches{worst_touch(1, smooth_distance), worst_touch(2, rough_distance)};
  EXPECT_EQ(energy_at(touch_of(touches[0]), smooth, 0.95 * least_smooth_diameter), 0);
  EXPECT_EQ(energy_at(touch_of(touches[1]), rough, 0.95 * least_rough_diameter), 0);
  for (int k = 0; k < 3000; ++k) touches.push_back(draw_numbers(draw));
  for (const Numbers& u : touches) {
    const Touch touch = touch_of(u);
    const double longest = std::max(longest_edge(touch.below), longest_edge(touch.above));
    ASSERT_GT(energy_at(touch, smooth, 1.0001 * least_smooth_diameter * longest), 0);
    ASSERT_GT(energy_at(touch, rough, 1.0001 * least_rough_diameter * longest), 0);
  }
}

/// Edges of length 1 that cross in their middles at right angles, sharp wedges at a height h: four ends, each
/// with half the law, at the distance sqrt(h^2 + 1/4) from the other edge.
TEST(EdgeOnEdge, ResistWithAFiniteForce) {
  const TriangleMesh sharp{{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-3, -3}, {0.5, -1e-3, -3}},
                           {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  const TriangleMesh below = with_edge_on_top(sharp, hinges_of(sharp)[0], 0.5, 0.5);
  double strongest = 0,
         before = energy_at({below, upside_down(below, std::acos(0))}, SmoothSurfaces(Harmonic{1}), 1);
  EXPECT_NEAR(before, 0.25, 1e-3) << "the barrier: k (sigma - l/2)^2";
  for (double h = 0.01; h < 0.9; h += 0.01) {
    TriangleMesh above = upside_down(below, std::acos(0));
    for (Vec3& x : above.vertex) x[2] += h;
    const double now = energy_at({below, above}, SmoothSurfaces(Harmonic{1}), 1);
    const double d = std::sqrt(h * h + 0.25);
    EXPECT_NEAR(now, d < 1 ? (1 - d) * (1 - d) : 0, 2e-3);
    strongest = std::max(strongest, (before - now) / 0.01);
    before = now;
  }
  EXPECT_NEAR(strongest, 0.45, 0.01);
}

TEST(EdgeCover, RefusesLongEdges) {
  System<3> system;
  add_surface(system, geodesic_icosahedron(42), 0.51, ShapeSpec{});
  EXPECT_THROW(require_covered_edges(system, least_rough_diameter), Error);
  EXPECT_THROW(require_covered_edges(system, least_smooth_diameter), Error);
  System<3> thick;
  add_surface(thick, geodesic_icosahedron(42), 0.6, ShapeSpec{});
  EXPECT_NO_THROW(require_covered_edges(thick, least_smooth_diameter));
  try {
    require_covered_edges(thick, least_rough_diameter);
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("take at least 0.707 of the longest edge"), std::string::npos);
  }
}

}  // namespace
}  // namespace supple
