#include "supple/geometry/mesh_fault.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "supple/core/error.hpp"
#include "supple/geometry/mesh_connections.hpp"
#include "tests/support/meshes.hpp"

namespace supple {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::joined;
using testing::tetrahedron;
using ::testing::UnorderedElementsAre;

/// The fault of a mesh, which must be of this kind and have words for all that an error says.
MeshFault fault_of(const TriangleMesh& mesh, MeshFaultKind kind) {
  const auto fault = find_fault(mesh);
  if (!fault) {
    ADD_FAILURE() << "no fault";
    return {};
  }
  EXPECT_EQ(fault->kind, kind) << fault->what;
  EXPECT_NE(fault->why, "");
  EXPECT_NE(fault->to_do, "");
  for (const std::int32_t v : fault->vertices) EXPECT_THAT(fault->what, HasSubstr(std::to_string(v)));
  for (const std::int32_t f : fault->triangles) EXPECT_THAT(fault->what, HasSubstr(std::to_string(f)));
  return *fault;
}

TriangleMesh sphere() { return geodesic_icosahedron(42); }

TEST(MeshFault, SoundMeshesHaveNone) {
  for (const int vertices : {12, 42, 162, 642}) EXPECT_FALSE(find_fault(geodesic_icosahedron(vertices)));
  for (const TriangleMesh& mesh :
       {tetrahedron(), testing::torus(24, 12), testing::torus(5, 3), testing::star()}) {
    const auto fault = find_fault(mesh);
    EXPECT_FALSE(fault) << fault->what;
    EXPECT_NO_THROW(require_sound(mesh, "mesh"));
  }
}

TEST(MeshFault, SizeAndPlaceAreNone) {
  for (const double scale : {1e-15, 1e12})
    for (const Vec3& shift : {Vec3{}, Vec3{1e4, -3e4, 2e4}}) {
      TriangleMesh mesh = testing::star();
      for (Vec3& x : mesh.vertex) x = scale * (x + shift);
      const auto fault = find_fault(mesh);
      EXPECT_FALSE(fault) << fault->what;
    }
}

TEST(MeshFault, OfListsThatAreTooShort) {
  TriangleMesh mesh = sphere();
  mesh.face.clear();
  EXPECT_THAT(fault_of(mesh, MeshFaultKind::no_triangles).what, HasSubstr("42 vertices and no triangles"));
  fault_of({}, MeshFaultKind::no_triangles);
  const TriangleMesh sheet = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  EXPECT_THAT(fault_of(sheet, MeshFaultKind::too_few_vertices).what, HasSubstr("3 vertices"));
}

TEST(MeshFault, ACornerThatIsNoVertex) {
  for (const int corner : {-1, 42, std::numeric_limits<int>::max()}) {
    TriangleMesh mesh = sphere();
    mesh.face[5][1] = corner;
    const MeshFault fault = fault_of(mesh, MeshFaultKind::no_such_vertex);
    EXPECT_THAT(fault.triangles, ElementsAre(5));
    EXPECT_THAT(fault.why, HasSubstr("from 0 to 41"));
    EXPECT_EQ(fault.to_do.find("from 0 on") != std::string::npos, corner == 42);
  }
}

TEST(MeshFault, ACoordinateThatCannotBeComputedWith) {
  for (const double x : {std::nan(""), std::numeric_limits<double>::infinity(), -1e70, 1e-70}) {
    TriangleMesh mesh = sphere();
    mesh.vertex[7][2] = x;
    const MeshFault fault = fault_of(mesh, MeshFaultKind::no_number);
    EXPECT_THAT(fault.vertices, ElementsAre(7));
    EXPECT_THAT(fault.what, HasSubstr("z coordinate"));
    EXPECT_THAT(fault.why, HasSubstr(std::isfinite(x) ? "between 1e-60 and 1e+60" : "finite"));
  }
}

TEST(MeshFault, ACornerTwice) {
  for (const auto& [k, l] : {std::pair{0, 1}, {1, 2}, {2, 0}}) {
    TriangleMesh mesh = sphere();
    mesh.face[9][k] = mesh.face[9][l];
    EXPECT_THAT(fault_of(mesh, MeshFaultKind::repeated_corner).triangles, ElementsAre(9));
  }
}

TEST(MeshFault, AVertexOfNoTriangle) {
  TriangleMesh mesh = sphere();
  mesh.vertex.push_back({9, 9, 9});
  EXPECT_THAT(fault_of(mesh, MeshFaultKind::unused_vertex).what,
              HasSubstr("vertex 42 belongs to no triangle"));
  mesh.vertex.push_back({9, 9, 8});
  EXPECT_THAT(fault_of(mesh, MeshFaultKind::unused_vertex).what, HasSubstr("2 vertices"));
}

/// As in files that list each triangle with corners of its own.
TEST(MeshFault, TwoVerticesAtOnePlace) {
  for (const double apart : {0.0, 1e-10}) {
    TriangleMesh mesh = sphere();
    mesh.vertex.push_back(mesh.vertex[3] + Vec3{apart, 0, -apart});
    for (auto& face : mesh.face)
      if (auto* at = std::find(face.begin(), face.end(), 3); at != face.end()) {
        *at = 42;
        break;
      }
    const MeshFault fault = fault_of(mesh, MeshFaultKind::coincident_vertices);
    EXPECT_THAT(fault.vertices, ElementsAre(3, 42));
    EXPECT_THAT(fault.to_do, HasSubstr("name vertex 3"));
  }
  TriangleMesh soup;
  for (const auto& face : sphere().face) {
    for (const int v : face) soup.vertex.push_back(sphere().vertex[v]);
    const auto n = static_cast<std::int32_t>(soup.vertex.size());
    soup.face.push_back({n - 3, n - 2, n - 1});
  }
  EXPECT_THAT(fault_of(soup, MeshFaultKind::coincident_vertices).what, HasSubstr("198 such pairs"));
  for (Vec3& x : soup.vertex) x = {1, 2, 3};
  EXPECT_THAT(fault_of(soup, MeshFaultKind::coincident_vertices).what, HasSubstr("(1, 2, 3)"));
}

TEST(MeshFault, ATriangleWithoutArea) {
  TriangleMesh mesh = sphere();
  const auto& [a, b, c] = mesh.face[20];
  mesh.vertex[a] = 0.3 * mesh.vertex[b] + 0.7 * mesh.vertex[c];
  EXPECT_THAT(fault_of(mesh, MeshFaultKind::flat_triangle).triangles, ElementsAre(20));
}

TEST(MeshFault, ATriangleTwice) {
  for (const bool turned : {false, true}) {
    TriangleMesh mesh = sphere();
    const auto [a, b, c] = mesh.face[4];
    mesh.face.push_back(turned ? std::array{b, a, c} : std::array{b, c, a});
    const MeshFault fault = fault_of(mesh, MeshFaultKind::repeated_triangle);
    EXPECT_THAT(fault.triangles, ElementsAre(4, 80));
    EXPECT_THAT(fault.vertices, UnorderedElementsAre(a, b, c));
  }
}

TEST(MeshFault, AHole) {
  TriangleMesh mesh = sphere();
  mesh.face.erase(mesh.face.begin() + 30);
  EXPECT_THAT(fault_of(mesh, MeshFaultKind::border_edge).what,
              HasSubstr("3 edges belong to one triangle alone"));
  TriangleMesh half = sphere();
  const MeshFault fault =
      fault_of({half.vertex, {half.face.begin(), half.face.begin() + 79}}, MeshFaultKind::border_edge);
  const auto& removed = half.face[79];
  for (const int v : fault.vertices) EXPECT_THAT(removed, ::testing::Contains(v));
}

/// Two tetrahedra that share an edge, and so four triangles there.
TEST(MeshFault, AnEdgeOfMoreThanTwoTriangles) {
  TriangleMesh mesh = joined(tetrahedron(), tetrahedron({7, 0, 0}));
  for (auto& face : mesh.face)
    for (int& v : face) v = v == 6 ? 0 : v == 7 ? 1 : v;
  mesh.vertex.resize(6);
  mesh.vertex[4] = {5, 0.3, 2}, mesh.vertex[5] = {5, 0.1, -2};
  const MeshFault fault = fault_of(mesh, MeshFaultKind::crowded_edge);
  EXPECT_THAT(fault.vertices, ElementsAre(0, 1));
  EXPECT_EQ(fault.triangles.size(), 4u);
  EXPECT_THAT(fault.what, HasSubstr("4 triangles"));
}

TEST(MeshFault, ATurnedTriangle) {
  for (const std::size_t face : {0, 33, 79}) {
    TriangleMesh mesh = sphere();
    std::swap(mesh.face[face][0], mesh.face[face][1]);
    const MeshFault fault = fault_of(mesh, MeshFaultKind::turned_triangle);
    ASSERT_EQ(fault.triangles.size(), 2u);
    EXPECT_EQ(fault.triangles[0], static_cast<int>(face));
    EXPECT_THAT(fault.what, HasSubstr("one of 3 such edges"));
    EXPECT_THAT(fault.to_do, HasSubstr("triangle " + std::to_string(face)));
  }
}

TEST(MeshFault, APointWhereTwoPartsMeet) {
  TriangleMesh mesh = joined(tetrahedron(), tetrahedron({2, 2, 2}));
  for (auto& face : mesh.face)
    for (int& v : face) v = v == 7 ? 0 : v;
  mesh.vertex.pop_back();
  const MeshFault fault = fault_of(mesh, MeshFaultKind::pinched_vertex);
  ASSERT_EQ(fault.triangles.size(), 2u);
  EXPECT_THAT(fault.vertices, ElementsAre(0));
  EXPECT_LT(fault.triangles[0], 4);
  EXPECT_GE(fault.triangles[1], 4);
}

TEST(MeshFault, SeveralPieces) {
  const TriangleMesh two = joined(sphere(), tetrahedron({9, 0, 0}));
  const MeshFault fault = fault_of(two, MeshFaultKind::several_pieces);
  EXPECT_THAT(fault.triangles, ElementsAre(0, 80));
  EXPECT_THAT(fault.what, HasSubstr("2 pieces"));
  EXPECT_THAT(fault_of(joined(two, tetrahedron({0, 9, 0})), MeshFaultKind::several_pieces).what,
              HasSubstr("3 pieces"));
}

TEST(MeshFault, AVolumeThatIsNone) {
  const TriangleMesh pillow = {
      {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0.1, 0, 0}, {-0.1, 0, 0}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
  fault_of(pillow, MeshFaultKind::no_volume);
  TriangleMesh mesh = sphere();
  for (auto& face : mesh.face) std::swap(face[0], face[1]);
  EXPECT_THAT(fault_of(mesh, MeshFaultKind::inside_out).what, HasSubstr("volume -1"));
}

TEST(MeshFault, AFoldedEdge) {
  TriangleMesh mesh = sphere();
  const auto [a, b, c, d] = hinges_of(mesh)[50];
  mesh.vertex[d] = 0.4 * mesh.vertex[a] + 0.4 * mesh.vertex[b] + 0.2 * mesh.vertex[c];
  const MeshFault fault = fault_of(mesh, MeshFaultKind::folded_edge);
  EXPECT_THAT(fault.vertices, UnorderedElementsAre(a, b));
  for (const int f : fault.triangles) EXPECT_THAT(mesh.face[f], ::testing::Contains(a));
}

TEST(MeshFault, ASurfaceThatGoesThroughItself) {
  TriangleMesh mesh = sphere();
  mesh.vertex[20] = -1.2 * mesh.vertex[20];
  const MeshFault fault = fault_of(mesh, MeshFaultKind::crossing);
  ASSERT_EQ(fault.triangles.size(), 2u);
  const auto has = [&](int f) { return std::count(mesh.face[f].begin(), mesh.face[f].end(), 20) > 0; };
  EXPECT_NE(has(fault.triangles[0]), has(fault.triangles[1]));
  EXPECT_THAT(fault.what, HasSubstr("such pairs"));
}

/// A sphere pressed in from above and below until two triangles lie on each other in the middle: they share
/// no vertex.
TEST(MeshFault, TwoTrianglesInOnePlane) {
  TriangleMesh mesh = sphere();
  const auto top = mesh.face[3];
  Vec3 up;
  for (const int v : top) up += mesh.vertex[v];
  up *= 1 / norm(up);
  const Vec3 side = mesh.vertex[top[0]] - dot(mesh.vertex[top[0]], up) * up;
  const Vec3 e = (1 / norm(side)) * side, f = cross(up, e);
  for (Vec3& x : mesh.vertex) x = {dot(x, e), dot(x, f), dot(x, up)};
  const auto highest = [&](std::size_t a, std::size_t b) { return mesh.vertex[a][2] > mesh.vertex[b][2]; };
  std::vector<std::size_t> order(mesh.vertex.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), highest);
  for (const double gap : {0.01, 0.0}) {
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.vertex[order[k]][2] = gap;
      Vec3& below = mesh.vertex[order[order.size() - 1 - k]];
      if (gap > 0) below = 0.6 * below;
      below[2] = 0;
    }
    if (gap > 0) {
      EXPECT_FALSE(find_fault(mesh));
    }
  }
  EXPECT_THAT(fault_of(mesh, MeshFaultKind::overlap).triangles, ::testing::Contains(3));
}

TEST(MeshFault, IsAnInputErrorWithTheNameOfTheMesh) {
  TriangleMesh mesh = sphere();
  mesh.face.pop_back();
  try {
    require_sound(mesh, "the mesh of 'cell.stl'");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_THAT(e.what(),
                ::testing::StartsWith("the mesh of 'cell.stl': 3 edges belong to one triangle alone"));
    EXPECT_THAT(e.what(), HasSubstr("(the surface has a hole"));
  }
}

/// Whatever the triangles are, there is an answer; and where that is that nothing is wrong, there is a body.
TEST(MeshFault, AnyListOfTrianglesIsAnswered) {
  RandomStream draw(8, Purpose::test);
  std::set<MeshFaultKind> kinds;
  int sound = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    TriangleMesh mesh = trial % 2 ? tetrahedron() : geodesic_icosahedron(12);
    for (int changes = 1 + trial % 3; changes > 0; --changes) {
      const auto f = draw.below(mesh.face.size());
      const auto v = static_cast<std::int32_t>(draw.below(mesh.vertex.size()));
      switch (draw.below(5)) {
        case 0: mesh.face[f][draw.below(3)] = v; break;
        case 1: std::swap(mesh.face[f][0], mesh.face[f][1]); break;
        case 2: mesh.vertex[v] = draw.uniform(-1, 1) * mesh.vertex[v]; break;
        case 3: mesh.face.push_back({mesh.face[f][0], v, mesh.face[f][1]}); break;
        default:
          mesh.vertex.push_back(mesh.vertex[v]);
          mesh.face[f][0] = v;
          break;
      }
    }
    if (const auto fault = find_fault(mesh)) {
      kinds.insert(fault->kind);
      continue;
    }
    ++sound;
    System<3> system;
    EXPECT_NO_THROW(add_surface(system, mesh, 1, {.area = 1, .length = 1}));
  }
  EXPECT_GT(sound, 200);
  EXPECT_GE(kinds.size(), 8u);
}

TEST(MeshFault, SortedEdgesOfAClosedSurfaceStandInPairs) {
  const TriangleMesh mesh = testing::torus(7, 5);
  const auto edges = sorted_edges(mesh);
  ASSERT_EQ(edges.size(), 3 * mesh.face.size());
  for (std::size_t k = 0; k < edges.size(); k += 2) {
    EXPECT_EQ(edges[k].low, edges[k + 1].low);
    EXPECT_EQ(edges[k].high, edges[k + 1].high);
    EXPECT_NE(edges[k].ascending, edges[k + 1].ascending);
    EXPECT_LT(edges[k].face, edges[k + 1].face);
  }
}

}  // namespace
}  // namespace supple
