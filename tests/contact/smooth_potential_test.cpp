#include <gtest/gtest.h>

#include "supple/core/random.hpp"
#include "tests/support/probe.hpp"
#include "tests/support/sites_inside.hpp"

namespace supple {
namespace {

using namespace testing;

/// Largest change of force per step along a closed path of `steps` that keeps `gap` from the ring, as far as
/// it is outside.
template <class Force>
double largest_jump(const Probe& probe, const std::vector<Vec2>& path, int steps, const Force& force) {
  double largest = 0;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const Vec2 a = path[k], b = path[(k + 1) % path.size()];
    Vec2 before{};
    bool known = false;
    for (int s = 0; s <= steps; ++s) {
      const Vec2 p = a + (static_cast<double>(s) / steps) * (b - a);
      if (probe.inside(p) || probe.distance(p) < 0.05) {
        known = false;
        continue;
      }
      const Vec2 now = force(p);
      if (known) largest = std::max(largest, norm(now - before));
      before = now;
      known = true;
    }
  }
  return largest;
}

/// The other form: by the nearest point of the boundary.
Vec2 minimum_distance_force(const Probe& probe, const Vec2& p, double sigma) {
  const double h = 1e-7, d = probe.distance(p);
  if (d >= sigma) return {};
  const Vec2 slope{probe.distance(p + Vec2{h, 0}) - probe.distance(p - Vec2{h, 0}),
                   probe.distance(p + Vec2{0, h}) - probe.distance(p - Vec2{0, h})};
  return (sigma - d) / (2 * h) * slope;
}

/// Straight lines all over the body and its surroundings.
std::vector<Vec2> scribble(std::uint64_t seed, int points, const Vec2& size) {
  RandomStream draw(seed, Purpose::test);
  std::vector<Vec2> path;
  for (int k = 0; k < points; ++k)
    path.push_back({draw.uniform(-1, size[0] + 1), draw.uniform(-1, size[1] + 1)});
  return path;
}

TEST(SmoothContacts, ForceIsContinuousRoundEveryCorner) {
  const double sigma = 1;
  for (const auto& ring : {square, ell, notch, ledge, spike, regular(20, 3)}) {
    Probe probe(ring, sigma);
    const std::vector<Vec2> path = scribble(3, 40, {6, 5});
    const auto force = [&](const Vec2& p) { return probe.force(p); };
    const double coarse = largest_jump(probe, path, 500, force),
                 fine = largest_jump(probe, path, 5000, force);
    ASSERT_GT(coarse, 1e-3) << "the path misses the body";
    EXPECT_LT(fine, 0.15 * coarse) << "of " << ring.size() << " vertices";
  }
}

TEST(SmoothContacts, TheMinimumDistanceFormWouldJump) {
  for (const auto& ring : {ell, notch, ledge}) {
    Probe probe(ring, 1);
    const std::vector<Vec2> path = scribble(3, 40, {6, 5});
    const auto force = [&](const Vec2& p) { return minimum_distance_force(probe, p, 1); };
    EXPECT_GT(largest_jump(probe, path, 5000, force), 0.7 * largest_jump(probe, path, 500, force));
  }
}

TEST(SmoothContacts, IsTheMinimumDistanceFormOutsideOfConvexBodies) {
  const std::vector<Vec2> needle{{0, 0}, {4, 0.2}, {0, 0.4}};
  for (const auto& ring : {square, regular(20, 3), regular(11, 1.5, 2), needle}) {
    Probe probe(ring, 1.1, {2.5, false});
    RandomStream draw(7, Purpose::test);
    int touched = 0;
    for (int k = 0; k < 3000; ++k) {
      const Vec2 p{draw.uniform(-4.5, 4.5), draw.uniform(-4.5, 4.5)};
      if (probe.inside(p)) continue;
      const double d = probe.distance(p), u = d < 1.1 ? 1.25 * (1.1 - d) * (1.1 - d) : 0;
      ASSERT_NEAR(probe.energy(p), u, 1e-12);
      ASSERT_EQ(probe.contacts().feature_violations(), 0);
      touched += u > 0;
    }
    EXPECT_GT(touched, 100);
  }
}

/// Outside, where the boundary within sigma is one arc and is seen from its outer side: edges minus vertices,
/// distances to closed segments.
TEST(SmoothContacts, CountsEdgesMinusVertices) {
  for (const auto& ring : {ell, notch, ledge}) {
    Probe probe(ring, 0.9);
    RandomStream draw(8, Purpose::test);
    int overlaps = 0;
    for (int k = 0; k < 4000; ++k) {
      const Vec2 p{draw.uniform(-1, 7), draw.uniform(-1, 5)};
      if (probe.inside(p)) continue;
      const auto phi = [](double d) { return d < 0.9 ? 0.5 * (0.9 - d) * (0.9 - d) : 0; };
      double u = 0;
      int edges = 0;
      bool behind = false;
      for (std::size_t e = 0; e < ring.size(); ++e) {
        const Vec2 a = ring[e], b = ring[(e + 1) % ring.size()];
        const ClosestOnSegment<2> c = closest_on_segment(p, a, b);
        u += phi(norm(c.from)) - phi(norm(p - a));
        edges += c.along > 0 && c.along < 1 && norm(c.from) < 0.9;
        behind = behind || (norm(c.from) < 0.9 && cross(p - a, b - a) < 0 && c.along > 0 && c.along < 1);
      }
      if (behind) continue;  // through an acute convex corner
      ASSERT_NEAR(probe.energy(p), u, 1e-13) << p[0] << ", " << p[1];
      overlaps += edges > 1;
    }
    EXPECT_GT(overlaps, 20);
  }
}

TEST(SmoothContacts, OneTouchPerVertexAndBody) {
  Probe probe(ell, 1);
  const Vec2 corner{1.6, 2.4};  // two edges and the concave vertex
  const Vec2 force = probe.force(corner);
  const auto records = probe.contacts().records(probe.system());
  ASSERT_EQ(records.size(), 3u);
  const auto touches = sum_touches(probe.system(), records, probe.contacts().laws());
  ASSERT_EQ(touches.size(), 1u);
  EXPECT_EQ(touches[0].site, 6);
  EXPECT_EQ(touches[0].body, 0);
  EXPECT_LT(norm(touches[0].force - force), 1e-15);
}

/// Into the body through each edge, also where a second edge is near: nothing jumps on the way.
TEST(SmoothContacts, GoOnSmoothlyWhereAVertexCrossesAnEdge) {
  for (const auto& ring : {square, ell, notch, ledge, spike}) {
    Probe probe(ring, 0.8, {3, false});
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 a = ring[k], b = ring[(k + 1) % ring.size()], edge = b - a,
                 outward = (1 / norm(edge)) * Vec2{edge[1], -edge[0]};
      for (const double t : {0.03, 0.3, 0.5, 0.9, 0.98}) {
        const Vec2 at = a + t * edge;
        const double h = 1e-7;
        const Vec2 before = probe.force(at + h * outward);
        const double above = probe.energy(at + h * outward);
        EXPECT_TRUE(find_sites_inside(probe.system()).empty());
        const Vec2 after = probe.force(at - h * outward);
        EXPECT_EQ(find_sites_inside(probe.system()),
                  (std::vector<SiteInside>{{static_cast<std::int32_t>(ring.size()), 0}}));
        EXPECT_NEAR(probe.energy(at - h * outward), above, 1e-5);
        EXPECT_LT(norm(after - before), 1e-4) << "edge " << k << " at " << t;
      }
    }
  }
}

TEST(SmoothContacts, PushOutWithTheDepth) {
  Probe probe(square, 0.8, {3, false});
  EXPECT_NEAR(probe.energy({1.4, 0.3}), 1.5 * 1.1 * 1.1, 1e-13);
  EXPECT_NEAR(probe.force({1.4, 0.3})[1], -3 * 1.1, 1e-13);
  EXPECT_NEAR(probe.force({2.8, 0.3})[0], 3 * 1.0, 1e-13) << "the nearest edge";
  EXPECT_EQ(probe.energy({1.5, 1.5}), 0) << "deeper than sigma";
  EXPECT_EQ(find_sites_inside(probe.system()), (std::vector<SiteInside>{{4, 0}}));
  Probe corner(ell, 1);  // nearest to the concave vertex (2, 2)
  EXPECT_NEAR(corner.energy({2.1, 1.9}), 0.5 * std::pow(1 + std::sqrt(0.02), 2), 1e-13);
}

TEST(SmoothContacts, AreFiniteAtEveryVertex) {
  for (const auto& ring : {square, ell, notch, ledge, spike}) {
    Probe probe(ring, 0.1, {3, false});
    for (const Vec2& vertex : ring) {
      EXPECT_NEAR(probe.energy(vertex), 1.5 * 0.1 * 0.1, 1e-13);
      EXPECT_NEAR(norm(probe.force(vertex)), 0.3, 1e-13);
    }
  }
}

TEST(SmoothContacts, ReportABoundaryThatIsNoSimpleArc) {
  Probe probe(notch, 0.9);
  probe.force({3, 4.8});
  EXPECT_EQ(probe.contacts().feature_violations(), 0);
  probe.force({3, 3.4});  // both sides within sigma, their corner not
  EXPECT_EQ(probe.contacts().feature_violations(), 1);
  probe.force({3, 1.7});  // and the corner too
  EXPECT_EQ(probe.contacts().feature_violations(), 0);
}

}  // namespace
}  // namespace supple
