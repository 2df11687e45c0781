/// Surfaces that a mesh file must not hold, each with its error, whoever wrote the file.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "supple/io/mesh/mesh_file.hpp"
#include "tests/io/mesh_texts.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/support/meshes.hpp"

namespace supple {
namespace {

using namespace testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
using BadSurface = TemporaryFolder;

/// The input error of a surface that is none.
template <class Act>
std::string input_error_of(Act&& act) {
  try {
    act();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input) << e.what();
    return e.what();
  }
  return "";
}

/// Meshes that are no surfaces, and words of the error.
std::vector<std::pair<TriangleMesh, const char*>> bad_meshes() {
  const TriangleMesh sound = geodesic_icosahedron(42);
  std::vector<std::pair<TriangleMesh, const char*>> all;
  const auto add = [&](const char* words, auto&& change) {
    TriangleMesh mesh = sound;
    change(mesh);
    all.emplace_back(mesh, words);
  };
  add("no triangles", [](auto& m) { m.face.clear(); });
  add("there are 3 vertices", [](auto& m) {
    m = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  });
  add("y coordinate 1e+70", [](auto& m) { m.vertex[7][1] = 1e70; });
  add("has the corners 0, ", [](auto& m) { m.face[0][1] = m.face[0][0] = 0; });
  add("vertex 42 belongs to no triangle", [](auto& m) { m.vertex.push_back({9, 9, 9}); });
  add("are both at", [](auto& m) {
    m.vertex.push_back(m.vertex[m.face[0][0]]);
    m.face[0][0] = 42;
  });
  add("has no area", [](auto& m) {
    const auto& [a, b, c] = m.face[20];
    m.vertex[a] = 0.5 * m.vertex[b] + 0.5 * m.vertex[c];
  });
  add("triangles 4 and 80", [](auto& m) { m.face.push_back(m.face[4]); });
  add("3 edges belong to one triangle alone", [](auto& m) { m.face.erase(m.face.begin() + 30); });
  add("4 triangles", [](auto& m) {
    m = joined(tetrahedron(), tetrahedron({7, 0, 0}));
    for (auto& face : m.face)
      for (int& v : face) v = v == 6 ? 0 : v == 7 ? 1 : v;
    m.vertex.resize(6);
    m.vertex[4] = {5, 0.3, 2}, m.vertex[5] = {5, 0.1, -2};
  });
  add("one of 3 such edges", [](auto& m) { std::swap(m.face[33][0], m.face[33][1]); });
  add("2 pieces", [](auto& m) { m = joined(m, tetrahedron({9, 0, 0})); });
  add("encloses the volume -1", [](auto& m) {
    for (auto& face : m.face) std::swap(face[0], face[1]);
  });
  add("encloses the volume", [](auto& m) {
    m = octahedron();
    m.vertex[4] = {0.1, 0, 0};
    m.vertex[5] = {-0.1, 0, 0};
  });
  add("folded along the edge", [](auto& m) {
    const auto [a, b, c, d] = hinges_of(m)[50];
    m.vertex[d] = 0.4 * m.vertex[a] + 0.4 * m.vertex[b] + 0.2 * m.vertex[c];
  });
  add("go through each other", [](auto& m) { m.vertex[20] *= -1.2; });
  add("such pairs", [](auto& m) { m.vertex[21] *= -1.3; });
  return all;
}

/// Text of OBJ and OFF, and binary PLY and STL, that were not made by write_mesh, which would refuse to.
TEST_F(BadSurface, FilesOfBadSurfaces) {
  const auto meshes = bad_meshes();
  ASSERT_GE(meshes.size(), 15u);
  for (const auto& [mesh, words] : meshes) {
    std::string obj;
    for (const Vec3& x : mesh.vertex) obj += fmt::format("v {} {} {}\n", x[0], x[1], x[2]);
    for (const auto& [a, b, c] : mesh.face) obj += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
    for (const auto& [name, content] : {std::pair<const char*, std::string>{"a.obj", obj},
                                        {"a.ply", as_binary_ply<double>(mesh, "double", std::endian::big)}}) {
      const std::string path = in_folder(name);
      write_content(path, content);
      EXPECT_THAT(input_error_of([&] { read_mesh(path); }),
                  AllOf(HasSubstr("the mesh of '" + path), HasSubstr(words)));
    }
  }
}

/// The error says where in the file the triangles and vertices stand.
TEST_F(BadSurface, ABadSurfaceIsShownInItsFile) {
  write_content(in_folder("a.obj"), replaced("# one\n" + octahedron_obj, "f 3 1 6", "\nf 1 3 6"));
  EXPECT_THAT(input_error_of([&] { read_mesh(in_folder("a.obj")); }),
              HasSubstr("[counted from 0; triangle 4: line 14, "));
  write_content(in_folder("a.obj"), replaced(octahedron_obj, "v 0 0 1\n", "\nv 0 0 1\nv 5 5 5\n"));
  EXPECT_THAT(input_error_of([&] { read_mesh(in_folder("a.obj")); }),
              HasSubstr("[counted from 0; vertex 6: line 9]"));
  TriangleMesh turned = octahedron();
  std::swap(turned.face[3][0], turned.face[3][1]);
  write_content(in_folder("a.stl"), as_binary_stl(turned));
  EXPECT_THAT(input_error_of([&] { read_mesh(in_folder("a.stl")); }), HasSubstr("triangle 3: byte 234"));
}

TEST_F(BadSurface, NoBadSurfaceIsWritten) {
  for (const auto& [mesh, words] : bad_meshes())
    for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl"})
      EXPECT_THAT(input_error_of([&, &bad = mesh] { write_mesh(in_folder(name), bad); }),
                  AllOf(HasSubstr(in_folder(name)), HasSubstr(words)));
  TriangleMesh none = octahedron();
  none.vertex[0][0] = std::nan("");
  EXPECT_THAT(input_error_of([&] { write_mesh(in_folder("a.ply"), none); }), HasSubstr("coordinate nan"));
  none = octahedron();
  none.face[2][1] = 6;
  EXPECT_THAT(input_error_of([&] { write_mesh(in_folder("a.obj"), none); }), HasSubstr("has the corner 6"));
  EXPECT_EQ(files(), 0u);
}

/// A surface whose vertices floats cannot tell apart, or hold.
TEST_F(BadSurface, WhatStlCannotHold) {
  TriangleMesh far = geodesic_icosahedron(162);
  for (Vec3& x : far.vertex) x += Vec3{1e7, 0, 0};
  EXPECT_THAT(input_error_of([&] { write_mesh(in_folder("a.stl"), far); }),
              AllOf(HasSubstr("STL holds floats of 7 digits"), HasSubstr("write OBJ, OFF or PLY")));
  TriangleMesh large = octahedron();
  for (Vec3& x : large.vertex) x *= 1e39;
  EXPECT_THAT(input_error_of([&] { write_mesh(in_folder("a.stl"), large); }),
              HasSubstr("a coordinate is 1e+39"));
  EXPECT_THAT(input_error_of([&] { write_mesh(in_folder("a.vtk"), octahedron()); }),
              HasSubstr("name it .obj, .off, .ply or .stl"));
  EXPECT_EQ(files(), 0u);
  EXPECT_THAT(file_error_of([&] { write_mesh(in_folder("none/a.obj"), octahedron()); }),
              HasSubstr("no folder"));
}

}  // namespace
}  // namespace supple
