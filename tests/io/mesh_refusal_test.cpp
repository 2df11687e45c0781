/// What a mesh file must not be, each with its error.
#include <gmock/gmock.h>

#include <cmath>

#include "supple/io/mesh/mesh_file.hpp"
#include "tests/io/mesh_texts.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/support/meshes.hpp"

namespace supple {
namespace {

using namespace testing;
using ::testing::HasSubstr;

class RefusedMesh : public TemporaryFolder {
 protected:
  /// The error that reading this gives: a file error that names the file.
  std::string error_of(const std::string& content, const std::string& name) {
    const std::string path = in_folder(name);
    write_content(path, content);
    std::string error = file_error_of([&] { read_mesh(path); });
    EXPECT_THAT(error, HasSubstr(path)) << content;
    return error;
  }
  /// Each of these parts of a sound text, replaced, gives an error with these words in it.
  struct Change {
    std::string part, by, words;
  };
  void expect_refusals(const std::string& sound, const std::string& name,
                       const std::vector<Change>& changes) {
    for (const auto& [part, by, words] : changes) {
      const std::size_t at = sound.find(part);
      ASSERT_NE(at, std::string::npos) << part;
      const std::string text = std::string(sound).replace(at, part.size(), by);
      EXPECT_THAT(error_of(text, name), HasSubstr(words)) << text;
    }
  }
};

TEST_F(RefusedMesh, Obj) {
  expect_refusals(
      tetrahedron_obj, "a.obj",
      {{"f 1 2 3", "f 0 2 3", "line 5: a face names vertex 0 (OBJ files count from 1 on)"},
       {"f 1 2 3", "f 1 2 5", "line 5: a face names vertex 5 (4 of them stand before this line)"},
       {"f 1 2 3", "f 1 2 -5", "line 5: a face names vertex -5"},
       {"v -1 -1 1\nf 1 2 3\nf 1 4 2", "f 1 2 3\nf 1 4 2\nv -1 -1 1",
        "line 5: a face names vertex 4 (3 of them"},
       {"f 1 2 3", "f 1 2 99999999999999999999", "line 5: the number of a corner is '99999999999999999999'"},
       {"f 1 2 3", "f 1 2 3.0", "line 5: '3.0' is no whole number"},
       {"f 1 2 3", "f 1 2 3/", "line 5: '' is no whole number"},
       {"f 1 2 3", "f 1 2 /3", "line 5: '' is no whole number"},
       {"f 1 2 3", "f 1/1 2 3", "line 5: a face names texture coordinate 1 (0 of them"},
       {"f 1 2 3", "f 1//1 2 3", "line 5: a face names normal 1 (0 of them"},
       {"f 1 2 3", "f 1/1/1/1 2 3", "line 5: a face names texture"},
       {"f 1 2 3", "f 1//1/1 2 3", "line 5: '1/1' is no whole number"},
       {"f 1 2 3", "f 1 2 3 4",
        "line 5: a face has 4 corners (the surface must consist of triangles); triangulate"},
       {"f 1 2 3", "f 1 2", "line 5: a face has 2 corners"},
       {"f 1 2 3", "f 1 \\\n2 3 4", "line 5: a face has 4 corners"},
       {"f 1 2 3", "f 1 2\\\n3", "line 5: the line ends with a backslash within a word"},
       {"f 2 4 3\n", "f 2 4 3 \\\n", "line 8: the line ends with a backslash (no line follows"},
       {"v 1 1 1", "v 1 1", "line 1: a vertex has 2 numbers"},
       {"v 1 1 1", "v 1 1 1 1 1", "line 1: a vertex has 5 numbers"},
       {"v 1 1 1", "v 1 1 1 0.5", "line 1: a vertex has the weight '0.5'"},
       {"v 1 1 1", "v 1 1 nan", "line 1: 'nan' is not finite"},
       {"v 1 1 1", "v 1 1 -inf", "line 1: '-inf' is not finite"},
       {"v 1 1 1", "v 1 1 1e999", "line 1: '1e999' is too large"},
       {"v 1 1 1", "v 1 1 1,5", "line 1: '1,5' is no number (a number was expected here); did you mean 1.5?"},
       {"v 1 1 1", "v 1 1 0x1", "line 1: '0x1' is no number"},
       {"v 1 1 1", "v 1 1 1x", "line 1: '1x' is no number"},
       {"v 1 1 1", "v 1 1 +-1", "line 1: '+-1' is no number"},
       {"v 1 1 1", "v 1 1 \x01\xc3\xa4", "line 1: '\\x01\\xc3\\xa4' is no number"},
       {"f 1 2 3", "vv 1 2 3", "line 5: unknown statement 'vv'"},
       {"f 1 2 3", "usemlt a",
        "line 5: unknown statement 'usemlt' (a mesh has v for vertices and f for faces); did you mean "
        "'usemtl'?"},
       {"f 1 2 3", "curv2 1 2", "line 5: the statement 'curv2' is of a curve"}});
}

TEST_F(RefusedMesh, LinesAreCountedWhateverEndsThem) {
  const std::string text = replaced("# one\n\n" + tetrahedron_obj, "f 1 2 3", "f 0 2 3");
  for (const char* line_end : {"\n", "\r\n", "\r"})
    EXPECT_THAT(error_of(replaced(text, "\n", line_end), "a"), HasSubstr("a, line 7: a face names vertex 0"));
}

TEST_F(RefusedMesh, Off) {
  expect_refusals(
      tetrahedron_off, "a.off",
      {{"OFF", "4OFF", "line 1: the file is '4OFF' (its points are not of three dimensions)"},
       {"OFF", "OFF BINARY", "line 1: the file is a binary OFF file"},
       {"OFF\n", "", "line 1: the first word is '4'"},
       {"OFF", "off", "line 1: the first word is 'off'"},
       {"4 4 6", "4", "line 2: 1 numbers stand behind the word OFF"},
       {"4 4 6", "4 4 -1", "line 2: the number of edges is '-1'"},
       {"4 4 6", "4 3 6",
        "line 10: there is a line behind the last face (the header says 4 vertices and 3 faces)"},
       {"4 4 6", "4 5 6", "line 11: the file ends before face 5 of 5"},
       {"4 4 6", "5 4 6", "line 7: the line of a vertex has 4 numbers"},
       {"4 4 6", "3 4 6", "line 6: the number of corners is '-1'"},
       {"4 4 6", "2000000000 4 6",
        "line 2: the header says 2000000000 vertices and 4 faces (these take 12000000031 bytes"},
       {"4 4 6", "4 99999999999 6", "line 2: the number of faces is '99999999999'"},
       {"1 1 1", "1 1 1 1", "line 3: the line of a vertex has 4 numbers (each has 3 in a file of this kind)"},
       {"1 -1 -1", "1 -1", "line 4: the line of a vertex has 2 numbers"},
       {"1 -1 -1", "1 -1 -1 1 1 1", "line 4: the line of a vertex has 6 numbers"},
       {"OFF\n4 4 6\n1 1 1\n", "COFF\n4 4 6\n1 1 1 0 0 0\n",
        "line 4: the line of a vertex has 3 numbers (each has 6 or 7, all the same"},
       {"1 -1 -1", "1 -1 nan", "line 4: 'nan' is not finite"},
       {"3 0 1 2", "4 0 1 2 3",
        "line 7: a face has 4 corners (the surface must consist of triangles); triangulate"},
       {"3 0 1 2", "2 0 1", "line 7: a face has 2 corners"},
       {"3 0 1 2", "3 0 1", "line 7: the line of a triangle has 3 numbers"},
       {"3 0 1 2", "3 0 1 2 0.5 0.5", "line 7: the line of a triangle has 6 numbers"},
       {"3 0 1 2", "3 0 1 2 red", "line 7: 'red' is no number"},
       {"3 0 1 2", "3 0 1 4", "line 7: the number of a corner is '4' (it can be 0 to 3)"},
       {"3 0 1 2", "3 -1 1 2", "line 7: the number of a corner is '-1'"},
       {"3 1 3 2\n", "3 1 3 2\n3", "line 11: there is a line behind the last face"}});
}

TEST_F(RefusedMesh, PlyHeaders) {
  const std::string vertex = "element vertex 4", face = "element face 4";
  expect_refusals(
      tetrahedron_ply, "a.ply",
      {{"format ascii 1.0\n", "", "the header has no format"},
       {"format ascii 1.0", "format ascii 1.0\nformat ascii 1.0", "line 3: the format is said twice"},
       {"ascii 1.0", "ascii 2.0", "line 2: the version is '2.0'"},
       {"ascii 1.0", "ascii", "line 2: the line has 2 words (it should be 'format ascii 1.0')"},
       {"ascii", "text", "line 2: unknown format 'text'"},
       {"end_header", "end_headr", "line 1: the header has no end"},
       {face, "end_header all\n" + face, "line 7: the line has 2 words (it should be 'end_header')"},
       {vertex, vertex + "\n" + vertex, "line 4: there is a second element 'vertex'"},
       {vertex, "property int a\n" + vertex, "line 3: a property stands before the first element"},
       {vertex, "elemnt vertex 4",
        "line 3: unknown statement 'elemnt' in the header (a header has format, element, property, comment "
        "and obj_info); did you mean 'element'?"},
       {vertex, "element vertex -4", "line 3: the number of rows is '-4'"},
       {vertex, "element vertex 4000000000000000000",
        "line 3: there would be 4000000000000000000 rows of 'vertex' (each takes 6 bytes"},
       {face, "element face 4000", "line 7: there would be 4000 rows of 'face'"},
       {face, "element empty 1\n" + face, "line 7: the element 'empty' has no properties"},
       {face, "element tristrips 1\nproperty list int int a\n" + face, "the file has triangle strips"},
       {vertex, "element vertices 4", "the header has no element 'vertex'"},
       {face, "element faces 4", "the header has no element 'face'"},
       {"float x", "flaot x", "line 4: unknown type 'flaot'"},
       {"float x", "float y", "line 5: there is a second property 'y'"},
       {"float x", "float u", "a vertex has no property 'x'"},
       {"property float x", "property list char float x", "a vertex has no property 'x'"},
       {"uchar int", "float int", "line 8: the number of values of a list is a float"},
       {"uchar int", "uchar float", "'vertex_indices' is no list of whole numbers"},
       {"property list uchar int vertex_indices", "property int vertex_indices",
        "'vertex_indices' is no list"},
       {"vertex_indices", "vertices", "a face has 0 lists of corners"},
       {"vertex_indices", "vertex_indices\nproperty list uchar int vertex_index",
        "a face has 2 lists of corners"}});
}

TEST_F(RefusedMesh, PlyRows) {
  expect_refusals(
      tetrahedron_ply, "a.ply",
      {{"element face 4", "element face 3", "line 17: there is a line behind the last row"},
       {"element face 4", "element face 5", "line 18: the file ends before the last row of 'face'"},
       {"element vertex 4", "element vertex 3", "line 13: a number of the row is '-1' (it can be 0 to 255)"},
       {"1 1 1", "1 1", "line 10: the line has only 2 words"},
       {"1 1 1", "1 1 1 1", "line 10: the line has 4 words (the properties of the header make 3)"},
       {"1 1 1", "1 1 inf", "line 10: 'inf' is not finite"},
       {"3 0 1 2", "4 0 1 2 3", "line 14: a face has 4 corners"},
       {"3 0 1 2", "2 0 1", "line 14: a face has 2 corners"},
       {"3 0 1 2", "3 0 1", "line 14: the line has only 3 words"},
       {"3 0 1 2", "3 0 1 4", "line 14: a face names vertex 4 (there are 4, counted from 0 on)"},
       {"3 0 1 2", "3 0 1 -1", "line 14: a face names vertex -1"},
       {"3 0 1 2", "3 0 1 1.5", "line 14: '1.5' is no whole number"},
       {"3 0 1 2", "300 0 1 2", "line 14: a number of the row is '300' (it can be 0 to 255)"},
       {"3 1 3 2\n", "3 1 3 2\n3 1 3 2\n", "line 18: there is a line behind the last row"}});
  const std::string upside =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "3 0 1 2\n0 0 0\n1 0 0\n0 1 12.5";
  EXPECT_THAT(error_of(upside, "a.ply"),
              HasSubstr("line 13: the last vertex has no line end (digits may be missing)"));
}

TEST_F(RefusedMesh, PlyInBinary) {
  const std::string sound = as_binary_ply<double>(octahedron(), "double", std::endian::little);
  const std::size_t lamp = sound.find("end_header\n") + 11, first_vertex = lamp + 22, row = 8 * 3 + 1 + 4 + 6;
  const std::size_t first_face = first_vertex + 6 * row;
  const auto with = [&](std::size_t at, const std::string& bytes) {
    return std::string(sound).replace(at, bytes.size(), bytes);
  };
  const auto at = [](std::size_t byte) { return "byte " + std::to_string(byte) + ": "; };
  EXPECT_EQ(sound.size(), first_face + 8 * 19);
  EXPECT_THAT(error_of(with(lamp, "\xff\xff"), "a"), HasSubstr(at(lamp) + "the file ends within the row"));
  EXPECT_THAT(error_of(with(first_vertex, bytes_of(std::nan(""))), "a"),
              HasSubstr(at(first_vertex) + "a number is nan"));
  EXPECT_THAT(error_of(with(first_vertex + row - 6, bytes_of(-1)), "a"),
              HasSubstr(at(first_vertex) + "a list has -1 values"));
  EXPECT_THAT(error_of(with(first_face + 8, bytes_of(4)), "a"),
              HasSubstr(at(first_face) + "a face has 4 corners"));
  EXPECT_THAT(error_of(with(first_face + 12, "\x06"), "a"),
              HasSubstr(at(first_face) + "a face names vertex 6"));
  EXPECT_THAT(error_of(sound + "x", "a"), HasSubstr(at(sound.size()) + "1 bytes are behind the last row"));
  EXPECT_THAT(error_of(sound.substr(0, sound.size() - 1), "a"),
              HasSubstr(at(first_face + 7 * 19) + "the file ends within the row"));
  EXPECT_THAT(error_of(replaced(sound, "face 8", "face 8000000000"), "a"),
              HasSubstr("there would be 8000000000 rows"));
}

TEST_F(RefusedMesh, StlOfText) {
  const std::string facet = "facet normal 0 0 0", first = "vertex 1 0 0", corner = "\n      " + first;
  expect_refusals(as_stl_text(octahedron()), "a.stl",
                  {{"solid", "sold", "line 1: 'sold' stands where 'solid' should be"},
                   {"endsolid a name of words\n", "",
                    "the file ends where 'facet' should be (a solid ends with 'endsolid')"},
                   {"endsolid a name of words\n", "endsolid\nmore", "'more' stands where 'solid' should be"},
                   {facet, "facet normal 0 0", "line 3: 'outer' is no number"},
                   {facet, "facet normal 0 0 nan", "line 2: 'nan' is not finite"},
                   {facet, "facet normal 0 0 0 0", "line 2: '0' stands where 'outer' should be"},
                   {facet, "facet 0 0 0", "line 2: '0' stands where 'normal' should be"},
                   {facet, "facet normal -1 -1 -1",
                    "line 2: the normal of facet 0 points the other way than its corners"},
                   {corner, "", "line 6: a face has 2 corners"},
                   {corner, corner + corner,
                    "line 2: a face has 4 corners (the surface must consist of triangles); triangulate"},
                   {first, "vertex 1 0", "line 5: 'vertex' is no number"},
                   {first, "vertex 1 0 O", "line 4: 'O' is no number"},
                   {first, std::string("vertex 1 0 0\0", 13), "line 4: '0\\x00' is no number"},
                   {"endloop", "end loop", "'end' stands where 'endloop' should be"},
                   {"  endfacet\n", "", "'facet' stands where 'endfacet' should be"}});
}

TEST_F(RefusedMesh, StlInBinary) {
  const std::string sound = as_binary_stl(octahedron(), "solid");
  const auto with = [&](std::size_t at, const std::string& bytes) {
    return std::string(sound).replace(at, bytes.size(), bytes);
  };
  for (const char* name : {"a.stl", "a"}) {
    EXPECT_THAT(
        error_of(sound.substr(0, 300), name),
        HasSubstr("byte 300: the file has 300 bytes (bytes 80 to 83 say that there are 8 facets, and a "
                  "binary STL file of these has 484); the file may be cut off"));
    EXPECT_THAT(error_of(sound + '\0', name), HasSubstr("the file has 485 bytes"));
    EXPECT_THAT(error_of(with(83, "\x7f"), name), HasSubstr("2130706440 facets"));
    EXPECT_THAT(error_of(sound.substr(0, 50), name), HasSubstr("the file ends after 50 bytes"));
    EXPECT_THAT(error_of(with(96, bytes_of(std::nanf(""))), name),
                HasSubstr("byte 96: a number of a facet is nan"));
    EXPECT_THAT(error_of(with(84, bytes_of(-1.0f)), name),
                HasSubstr("byte 84: the normal of facet 0 points the other way"));
  }
}

TEST_F(RefusedMesh, WhatIsNoMeshFile) {
  EXPECT_THAT(error_of("", "a.obj"), HasSubstr("it is empty"));
  EXPECT_THAT(error_of("hello\n", "a.txt"), HasSubstr("export it as OBJ, STL, PLY or OFF"));
  EXPECT_THAT(error_of("# nothing\n", "a"), HasSubstr("export it as OBJ, STL, PLY or OFF"));
  EXPECT_THAT(error_of("hello\n", "a.obj"), HasSubstr("line 1: unknown statement 'hello'"));
  EXPECT_THAT(error_of("hello\n", "a.ply"),
              HasSubstr("line 1: the first word is 'hello' (a PLY file begins with 'ply')"));
  EXPECT_THAT(error_of("\xef\xbb\xbf" + tetrahedron_off, "a.off"), HasSubstr("byte order mark"));
  EXPECT_THAT(error_of("OFF", "a"), HasSubstr("0 numbers stand behind the word OFF"));
  EXPECT_THAT(error_of("ply", "a"), HasSubstr("the header has no end"));
  EXPECT_THAT(file_error_of([&] { read_mesh(in_folder("none.obj")); }), HasSubstr("No such file"));
  EXPECT_THAT(file_error_of([&] { read_mesh(folder()); }), HasSubstr("it is a folder"));
}

/// The hole of a file takes no place on the disk; it is refused before it is read, which would take memory.
TEST_F(RefusedMesh, AFileThatIsTooLong) {
  write_content(in_folder("a.stl"), "");
  std::filesystem::resize_file(in_folder("a.stl"), (std::uintmax_t{1} << 28) + 1);
  EXPECT_THAT(file_error_of([&] { read_mesh(in_folder("a.stl")); }),
              HasSubstr("longer than 268435456 bytes); make"));
}

}  // namespace
}  // namespace supple
