#include "supple/contact/surface_fans.hpp"

#include <gtest/gtest.h>

#include "supple/core/error.hpp"
#include "tests/support/corner_meshes.hpp"

namespace supple {
namespace {

using namespace testing;

TEST(SurfaceFans, RefuseSurfacesThatAreOpenOrTouchThemselves) {
  const auto complaint = [](TriangleMesh mesh) {
    Topology<3> topology;
    topology.facet = mesh.face;
    try {
      SurfaceFans().update(topology, static_cast<int>(mesh.vertex.size()));
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  TriangleMesh mesh = box_mesh({1, 1, 1});
  EXPECT_EQ(complaint(mesh), "");
  mesh.face.pop_back();
  EXPECT_NE(complaint(mesh).find("no closed fan"), std::string::npos);
  mesh = needle;  // and another one that hangs at its vertex 0
  for (const Vec3& x : needle.vertex) mesh.vertex.push_back(-x);
  for (auto face : needle.face) {
    std::swap(face[0], face[1]);
    for (std::int32_t& k : face) k = k == 0 ? 0 : k + 4;
    mesh.face.push_back(face);
  }
  EXPECT_NE(complaint(mesh).find("vertex 0"), std::string::npos);
}

/// Rings go round counter-clockwise, every edge and vertex has one triangle that speaks for it.
TEST(SurfaceFans, MeetEveryEdgeAndVertexOnce) {
  const TriangleMesh mesh = star_mesh(162, 0.2, 5);
  Topology<3> topology;
  topology.facet = mesh.face;
  SurfaceFans fans;
  fans.update(topology, 162);
  std::vector<int> spoken(162);
  int edges = 0;
  for (std::int32_t f = 0; f < 320; ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      spoken[mesh.face[f][k]] += fans.of(f).speaks_for_corner[k];
      edges += fans.of(f).speaks_for_edge[k];
      const auto& other = mesh.face[fans.of(f).across[k]];
      const auto at = std::find(other.begin(), other.end(), mesh.face[f][k]);
      ASSERT_NE(at, other.end());
      EXPECT_EQ(other[(at - other.begin() + 2) % 3], mesh.face[f][(k + 1) % 3]) << "the edge the other way";
    }
  EXPECT_EQ(edges, 480);
  for (std::int32_t i = 0; i < 162; ++i) {
    EXPECT_EQ(spoken[i], 1);
    const auto ring = fans.round(i);
    ASSERT_GE(ring.size(), 5u);
    for (std::size_t k = 0; k < ring.size(); ++k)
      EXPECT_GT(dot(cross(mesh.vertex[ring[k]], mesh.vertex[ring[(k + 1) % ring.size()]]), mesh.vertex[i]),
                0);
  }
}

}  // namespace
}  // namespace supple
