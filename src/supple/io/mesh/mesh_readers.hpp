/// The readers of the formats, each in a file of its own; read_mesh chooses among them.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "supple/io/mesh/mesh_text.hpp"
#include "supple/model/triangle_mesh.hpp"

namespace supple {

/// A file of this length holds several million triangles. Numbers of its vertices and bytes fit in 32 bits.
inline constexpr std::size_t longest_mesh_file = std::size_t{1} << 28;

/// What a file says, not yet known to be a surface: every corner is one of the vertices, every coordinate
/// finite. For each vertex and face the line (from 1 on) or byte (from 0 on) where it stands.
struct PlacedMesh {
  TriangleMesh mesh;
  const char* unit = "line";
  std::vector<std::uint32_t> vertex_at, face_at;

  void add_vertex(const Vec3& x, std::size_t at) {
    mesh.vertex.push_back(x);
    vertex_at.push_back(static_cast<std::uint32_t>(at));
  }
  void add_face(const std::array<std::int32_t, 3>& corners, std::size_t at) {
    mesh.face.push_back(corners);
    face_at.push_back(static_cast<std::uint32_t>(at));
  }
  MeshPlace place(const std::string& path, std::size_t at) const { return {path, unit, at}; }
};

/// The bytes of a whole file of at most longest_mesh_file as a mesh; `path` is for errors. Throw file errors
/// as read_mesh does.
PlacedMesh read_obj(const std::string& path, std::string_view bytes);
PlacedMesh read_off(const std::string& path, std::string_view bytes);
PlacedMesh read_ply(const std::string& path, std::string_view bytes);
PlacedMesh read_stl(const std::string& path, std::string_view bytes);

/// Whether a statement of this name may stand in an OBJ file.
bool is_obj_statement(std::string_view word);
/// Whether a word is the first of an OFF file: OFF, with letters of what else it holds before it.
bool is_off_keyword(std::string_view word);
/// Whether a word is "solid", in lower or upper case, with which an STL file of text begins.
bool is_stl_keyword(std::string_view word);
/// Whether the size of a file is that which a binary STL file of its number of facets has. No text of at
/// most longest_mesh_file has it: as a number, four characters would ask for more.
bool has_size_of_binary_stl(std::string_view bytes);

}  // namespace supple
