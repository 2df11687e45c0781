/// Small mesh files, written by hand.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>

#include "supple/model/triangle_mesh.hpp"

namespace supple::testing {

inline TriangleMesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

inline const std::string octahedron_obj =
    "# an octahedron\nv 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
    "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";

// The tetrahedron of tests/support/meshes.hpp.
inline const std::string tetrahedron_obj =
    "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
inline const std::string tetrahedron_off =
    "OFF\n4 4 6\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
inline const std::string tetrahedron_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
/// A text with one of its parts, which must be there, replaced wherever it stands.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
    text.replace(at, part.size(), by);
  return text;
}

/// The bytes of a number in this order.
template <class T>
std::string bytes_of(T x, std::endian order = std::endian::little) {
  std::string raw(sizeof x, '\0');
  std::memcpy(raw.data(), &x, sizeof x);
  return order == std::endian::native ? raw : std::string(raw.rbegin(), raw.rend());
}

/// The facets of a mesh as STL of text; the normal is 0, which says nothing.
inline std::string as_stl_text(const TriangleMesh& mesh) {
  std::string text = "solid a name of words\n";
  const auto number = [](double x) {
    char digits[32];
    std::snprintf(digits, sizeof digits, " %.17g", x);
    return std::string(digits);
  };
  for (const auto& face : mesh.face) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const int v : face) {
      text += "      vertex";
      for (int d = 0; d < 3; ++d) text += number(mesh.vertex[v][d]);
      text += "\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a name of words\n";
}

/// The facets as binary STL with this beginning of its header.
inline std::string as_binary_stl(const TriangleMesh& mesh, std::string header = "") {
  header.resize(80, '\0');
  std::string bytes = header + bytes_of(static_cast<std::uint32_t>(mesh.face.size()));
  for (const auto& face : mesh.face) {
    bytes.append(12, '\0');
    for (const int v : face)
      for (int d = 0; d < 3; ++d) bytes += bytes_of(static_cast<float>(mesh.vertex[v][d]));
    bytes += "ab";
  }
  return bytes;
}

/// Binary PLY with coordinates of type Number, called `number`, and much that is to be ignored.
template <class Number>
std::string as_binary_ply(const TriangleMesh& mesh, const char* number, std::endian order) {
  const std::string type = number, line = "property " + type + " ";
  std::string bytes =
      std::string("ply\nformat binary_") + (order == std::endian::little ? "little" : "big") +
      "_endian 1.0\ncomment end_header is not here\nobj_info any\nelement lamp 2\nproperty list ushort "
      "double a\n"
      "property char b\nelement vertex " +
      std::to_string(mesh.vertex.size()) + "\n" + line + "z\nproperty uchar red\n" + line +
      "x\nproperty float nx\n" + line + "y\nproperty list int short extra\nelement face " +
      std::to_string(mesh.face.size()) +
      "\nproperty double quality\nproperty list int32 uint16 vertex_index\nproperty int8 flag\nend_header\n";
  for (const int values : {0, 2}) {
    bytes += bytes_of(static_cast<std::uint16_t>(values), order);
    for (int k = 0; k < values; ++k) bytes += bytes_of(0.5, order);
    bytes += '\n';
  }
  const auto coordinate = [&](double x) { return bytes_of(static_cast<Number>(x), order); };
  for (const Vec3& x : mesh.vertex) {
    bytes += coordinate(x[2]) + '\r' + coordinate(x[0]) + bytes_of(std::nanf(""), order) + coordinate(x[1]);
    bytes += bytes_of(std::int32_t{1}, order) + bytes_of(std::int16_t{7}, order);
  }
  for (const auto& face : mesh.face) {
    bytes += bytes_of(0.25, order) + bytes_of(std::int32_t{3}, order);
    for (const int v : face) bytes += bytes_of(static_cast<std::uint16_t>(v), order);
    bytes += '\xff';
  }
  return bytes;
}

}  // namespace supple::testing
