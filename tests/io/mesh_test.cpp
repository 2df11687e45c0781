/// Meshes that files hold, in many spellings, and their way into files and back.
#include <gmock/gmock.h>

#include "supple/io/mesh/mesh_file.hpp"
#include "tests/io/mesh_texts.hpp"
#include "tests/io/same_mesh.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/surface_reference.hpp"

namespace supple {
namespace {

using namespace testing;
using ::testing::HasSubstr;

class MeshFile : public TemporaryFolder {
 protected:
  TriangleMesh read(const std::string& content, const std::string& name = "mesh") {
    write_content(in_folder(name), content);
    return read_mesh(in_folder(name));
  }
};

/// Replaces \n by another end of lines.
std::string with_line_ends(const std::string& text, const char* line_end) {
  return replaced(text, "\n", line_end);
}

TEST_F(MeshFile, ObjInManySpellings) {
  expect_same(read(octahedron_obj), octahedron());
  const std::string plain = tetrahedron_obj;
  for (const std::string& text :
       {plain, plain.substr(0, plain.size() - 1), with_line_ends(plain, "\r\n"), with_line_ends(plain, "\r"),
        with_line_ends(plain, " \t# a comment \\\n\n"), replaced(plain, " ", " \t "),
        replaced(plain, "1 1 1", "+1 +1 +1"), replaced(plain, "1\n", "1.\n"),
        replaced(plain, "v 1 -1 -1", "v 10e-1 -0.1e1 -1"), replaced(plain, " ", " \\\n"),
        replaced(plain, " ", "\\\n "), replaced(plain, " ", " \\\r\n\t"),
        replaced(plain, "v 1 1 1\n", "v 1 1 1 1.0\n"), replaced(plain, "1\nv", "1 0.5 0.25 1\nv"),
        replaced(plain, "f 2 4 3", "f -3 -1 -2"),
        "mtllib a b.mtl\no thing\n" + replaced(plain, "f 1 2 3", "g a b\nusemtl c\ns off\nf 1 2 3") +
            "p 1\nl 1 2 3 4\n",
        replaced("vt 0 0\nvn 0 0 1\nvn 1 0 0\nvp 1 2\n" + plain, "f 1 2 3", "f 1/1/2 2//-2 3/-1")}) {
    SCOPED_TRACE(text);
    expect_same(read(text), tetrahedron());
  }
}

/// Relative numbers count from the present line on, not from the end of the file.
TEST_F(MeshFile, ObjFacesBetweenVertices) {
  expect_same(read("v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nf -3 -2 -1\nv -1 -1 1\nf -4 -1 -3\nf 1 3 4\nf 2 4 3\n"),
              tetrahedron());
}

TEST_F(MeshFile, OffInManySpellings) {
  const std::string plain = tetrahedron_off;
  const std::string rows = plain.substr(plain.find("1 1 1")), faces = rows.substr(rows.find("3 0"));
  const std::string places = rows.substr(0, rows.size() - faces.size());
  for (const std::string& text :
       {plain, with_line_ends(plain, "\r\n"), with_line_ends(plain, "\r"), replaced(plain, "4 4 6", "4 4"),
        replaced(plain, "4 4 6", "4 4 0"), "OFF 4 4 6\n" + rows, "OFF 4 4\n" + rows,
        "# first\n\n" + with_line_ends(plain, " # behind\n\n# between\n"), " OFF\n4 4 6\n" + rows,
        "COFF\n4 4 6\n" + with_line_ends(places, " 255 0 0 255\n") + faces,
        "COFF\n4 4 6\n" + with_line_ends(places, " 0.5 0.5 0\n") + faces,
        "NOFF 4 4 6\n" + with_line_ends(places, " 0 0 1\n") + faces,
        "CNOFF 4 4 6\n" + with_line_ends(places, " 0 0 1 1 1 1\n") + faces,
        "STCNOFF 4 4 6\n" + with_line_ends(places, " 0 0 1 1 1 1 1 0 0\n") + faces,
        "OFF 4 4 6\n" + places +
            replaced(with_line_ends(faces, " 200 100 0\n"), "3 0 3 1 200 100 0", "3 0 3 1"),
        "OFF 4 4 6\n" + places + with_line_ends(faces, " 7\n"),
        "OFF 4 4 6\n" + places + with_line_ends(faces, " 0.1 0.2 0.3 1\n")}) {
    SCOPED_TRACE(text);
    expect_same(read(text), tetrahedron());
  }
}

TEST_F(MeshFile, PlyOfText) {
  const std::string plain = tetrahedron_ply;
  for (const std::string& text :
       {plain, plain.substr(0, plain.size() - 1), with_line_ends(plain, "\r\n"), with_line_ends(plain, "\r"),
        replaced(plain, "float", "double"), replaced(plain, "float", "int8"),
        replaced(plain, "float", "short"),
        replaced(plain, "uchar int vertex_indices", "uint32 uint8 vertex_index"),
        replaced(plain, "element face", "comment any words\nobj_info more\nelement face"),
        replaced(plain, "1 -1 -1", " 1\t-1.0e0  -1 "),
        replaced(replaced(plain, "property list", "property float quality\nproperty list"), "\n3 ",
                 "\nnan 3 "),
        replaced(replaced(plain, "element face",
                          "element edge 1\nproperty int a\nproperty list char float b\nelement face"),
                 "3 0 1 2", "5 2 0.5 1e-3\n3 0 1 2")}) {
    SCOPED_TRACE(text);
    expect_same(read(text), tetrahedron());
  }
}

/// Faces may stand before vertices.
TEST_F(MeshFile, PlyInAnyOrderOfElements) {
  expect_same(
      read("ply\nformat ascii 1.0\nelement face 4\nproperty list uchar int vertex_indices\nelement vertex 4\n"
           "property float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n3 0 3 1\n3 0 2 3\n"
           "3 1 3 2\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n"),
      tetrahedron());
}

TEST_F(MeshFile, PlyInBinary) {
  const TriangleMesh exact = geodesic_icosahedron(42);
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    expect_same(read(as_binary_ply<double>(exact, "double", order)), exact);
    expect_same(read(as_binary_ply<double>(exact, "float64", order)), exact);
    expect_same(read(as_binary_ply<float>(exact, "float32", order)), as_floats(exact));
    for (const auto& bytes : {as_binary_ply<std::int8_t>(octahedron(), "char", order),
                              as_binary_ply<std::int16_t>(octahedron(), "short", order),
                              as_binary_ply<std::int32_t>(octahedron(), "int", order)})
      expect_same(read(bytes), octahedron());
    TriangleMesh up = tetrahedron({3, 3, 3});
    for (const auto& bytes :
         {as_binary_ply<std::uint8_t>(up, "uchar", order), as_binary_ply<std::uint16_t>(up, "uint16", order),
          as_binary_ply<std::uint32_t>(up, "uint", order)})
      expect_same(read(bytes), up);
  }
}

/// The line end of the first line is that of the header, whatever byte the body begins with.
TEST_F(MeshFile, PlyInBinaryWithEveryLineEnd) {
  const std::string bytes = as_binary_ply<double>(octahedron(), "double", std::endian::big);
  const std::size_t body = bytes.find("end_header\n") + 11;
  for (const char* line_end : {"\r", "\r\n"})
    expect_same(read(with_line_ends(bytes.substr(0, body), line_end) + bytes.substr(body)), octahedron());
  std::string low =
      "ply\rformat binary_big_endian 1.0\relement vertex 4\rproperty char x\rproperty char y\r"
      "property char z\relement face 4\rproperty list char char vertex_index\rend_header\r";
  low += std::string("\n\n\n\n\r\r\r\n\r\r\r\n\3\0\1\2\3\0\3\1\3\0\2\3\3\1\3\2", 28);
  TriangleMesh small = tetrahedron();
  for (Vec3& x : small.vertex) x = Vec3{11.5, 11.5, 11.5} - 1.5 * x;
  for (auto& face : small.face) std::swap(face[1], face[2]);
  const TriangleMesh found = read(replaced(low, std::string("\3\0\1\2\3\0\3\1\3\0\2\3\3\1\3\2", 16),
                                           std::string("\3\0\2\1\3\0\1\3\3\0\3\2\3\1\2\3", 16)));
  expect_same(found, small);
}

/// Corners join where they are equal, and vertices are numbered by their first use.
TEST_F(MeshFile, StlOfText) {
  const TriangleMesh mesh = in_order_of_use(octahedron());
  EXPECT_NE(mesh.face, octahedron().face);
  const std::string plain = as_stl_text(octahedron());
  for (const std::string& text :
       {plain, with_line_ends(plain, "\r\n"), with_line_ends(plain, "\r"), with_line_ends(plain, " \n\n\t"),
        replaced(plain, "endsolid a name of words\n", "endsolid"), replaced(plain, " a name of words", ""),
        replaced(plain, "facet", "FACET"), replaced(plain, " 0 ", " -0 "),
        std::string(plain).replace(plain.find("normal 0 0 0"), 12, "normal 1 1e-3\n1")}) {
    SCOPED_TRACE(text);
    expect_equal(read(text), mesh);
  }
  const TriangleMesh exact = geodesic_icosahedron(42);
  expect_same(read(as_stl_text(exact)), in_order_of_use(exact));
}

/// Patches of one surface stand as solids of their own.
TEST_F(MeshFile, StlOfSeveralSolids) {
  const std::string text = as_stl_text(octahedron());
  const std::size_t half = text.find("  facet", text.size() / 2);
  expect_equal(read(text.substr(0, half) + "endsolid one\n\nsolid two\n" + text.substr(half)),
               in_order_of_use(octahedron()));
}

TEST_F(MeshFile, StlInBinaryIsKnownByItsSize) {
  const TriangleMesh exact = geodesic_icosahedron(42);
  for (const char* header :
       {"", "solid ascii", "solid a\nfacet normal 0 0 1\n", "OFF\n", "ply\n", "v 1 2 3\n"})
    for (const char* name : {"mesh", "mesh.stl", "mesh.ply"})
      expect_same(read(as_binary_stl(exact, header), name), in_order_of_use(as_floats(exact)));
}

/// The content says what a file is, its ending only where the content does not.
TEST_F(MeshFile, TheContentSaysTheFormat) {
  for (const std::string& content : {tetrahedron_obj, tetrahedron_off, tetrahedron_ply,
                                     as_stl_text(tetrahedron()), as_binary_stl(tetrahedron())})
    for (const char* name : {"a", "a.obj", "a.OFF", "a.ply", "a.stl", "a.txt"})
      expect_same(read(content, name), tetrahedron());
}

/// Numbers that any loss of digits would change.
TEST_F(MeshFile, EveryBitComesBack) {
  TriangleMesh ragged = star();
  const auto moves = random_moves(ragged.vertex.size(), 4);
  for (std::size_t v = 0; v < moves.size(); ++v) ragged.vertex[v] += 1e-3 * moves[v];
  TriangleMesh small = tetrahedron();
  for (Vec3& x : small.vertex) x *= 1e-17 / 3;
  TriangleMesh zero = octahedron();
  zero.vertex[0][1] = -0.0;
  for (const TriangleMesh& mesh : {ragged, small, zero, torus(24, 12), geodesic_icosahedron(162)})
    for (const char* name : {"a.obj", "a.off", "a.ply", "A.PLY"}) {
      write_mesh(in_folder(name), mesh, Existing::replace);
      expect_same(read_mesh(in_folder(name)), mesh);
      std::filesystem::copy_file(in_folder(name), in_folder("unnamed"),
                                 std::filesystem::copy_options::overwrite_existing);
      expect_same(read_mesh(in_folder("unnamed")), mesh);
    }
  write_mesh(in_folder("a.stl"), ragged);
  expect_same(read_mesh(in_folder("a.stl")), in_order_of_use(as_floats(ragged)));
}

/// The surface of 42 vertices that another program made.
TEST_F(MeshFile, TheReferenceOf42Vertices) {
  const SurfaceReference reference = read_surfaces("single_shell_42");
  const TriangleMesh mesh = mesh_of(reference.system, 0);
  ASSERT_EQ(mesh.vertex.size(), 42u);
  for (const char* name : {"a.obj", "a.off", "a.ply"}) {
    write_mesh(in_folder(name), mesh);
    const TriangleMesh back = read_mesh(in_folder(name));
    expect_same(back, mesh);
    EXPECT_EQ(enclosed_volume(back), enclosed_volume(mesh));
    EXPECT_EQ(hinges_of(back), hinges_of(mesh));
  }
}

/// A file of a name that exists stays, unless it is to be replaced.
TEST_F(MeshFile, NothingIsReplacedUnasked) {
  write_content(in_folder("a.obj"), "precious");
  EXPECT_THAT(file_error_of([&] { write_mesh(in_folder("a.obj"), octahedron()); }), HasSubstr("exists"));
  EXPECT_EQ(content_of(in_folder("a.obj")), "precious");
  write_mesh(in_folder("a.obj"), octahedron(), Existing::replace);
  expect_same(read_mesh(in_folder("a.obj")), octahedron());
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace supple
