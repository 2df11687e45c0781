#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/core/rounded_to_float.hpp"
#include "supple/geometry/mesh_fault.hpp"
#include "supple/io/mesh/mesh_file.hpp"
#include "supple/io/mesh/mesh_format.hpp"
#include "supple/io/text/number_text.hpp"

namespace supple {

namespace {

static_assert(std::endian::native == std::endian::little, "the files are little-endian");

template <class T>
void append_bytes(std::string& out, T x) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(x);
  out.append(raw.data(), raw.size());
}

void append_vertex(std::string& text, const Vec3& x) {
  for (int d = 0; d < 3; ++d) {
    if (d > 0) text += ' ';
    append_shortest(text, x[d]);
  }
  text += '\n';
}

/// The corners of a triangle, counted from `first` on.
void append_face(std::string& text, const std::array<std::int32_t, 3>& face, std::int64_t first) {
  for (std::size_t k = 0; k < 3; ++k) {
    text += ' ';
    append_integer(text, first + face[k]);
  }
  text += '\n';
}

std::string as_obj(const TriangleMesh& mesh) {
  std::string text = "# a surface of triangles\n";
  for (const Vec3& x : mesh.vertex) append_vertex(text += "v ", x);
  for (const auto& face : mesh.face) append_face(text += 'f', face, 1);
  return text;
}

std::string as_off(const TriangleMesh& mesh) {
  std::string text =
      fmt::format("OFF\n{} {} {}\n", mesh.vertex.size(), mesh.face.size(), mesh.face.size() / 2 * 3);
  for (const Vec3& x : mesh.vertex) append_vertex(text, x);
  for (const auto& face : mesh.face) append_face(text += '3', face, 0);
  return text;
}

std::string as_ply(const TriangleMesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertex.size(), mesh.face.size());
  for (const Vec3& x : mesh.vertex)
    for (int d = 0; d < 3; ++d) append_bytes(bytes, x[d]);
  for (const auto& face : mesh.face) {
    bytes += '\3';
    for (const std::int32_t corner : face) append_bytes(bytes, corner);
  }
  return bytes;
}

/// The mesh as floats hold it. Throws an input error where one cannot, or it is then no sound surface.
TriangleMesh rounded_to_floats(const TriangleMesh& mesh, const std::string& path) {
  const auto error = [&](const std::string& why) {
    return input_error("cannot write '" + path + "'", "STL holds floats of 7 digits, and " + why,
                       "write OBJ, OFF or PLY, which hold doubles");
  };
  TriangleMesh out = mesh;
  for (Vec3& x : out.vertex)
    for (int d = 0; d < 3; ++d) {
      if (std::abs(x[d]) > std::numeric_limits<float>::max())
        throw error(fmt::format("a coordinate is {:.6g}", x[d]));
      x[d] = rounded_to_float(x[d]);
    }
  if (const auto fault = find_fault(out)) throw error("then " + fault->what);
  return out;
}

std::string as_stl(const TriangleMesh& exact, const std::string& path) {
  const TriangleMesh mesh = rounded_to_floats(exact, path);
  std::string bytes = "a surface of triangles";  // a header that begins with "solid" would look like text
  bytes.resize(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(mesh.face.size()));
  for (const auto& [a, b, c] : mesh.face) {
    const Vec3 &p = mesh.vertex[a], &q = mesh.vertex[b], &r = mesh.vertex[c];
    const Vec3 across = cross(q - p, r - p), normal = (1 / norm(across)) * across;
    for (const Vec3& x : {normal, p, q, r})
      for (int d = 0; d < 3; ++d) append_bytes(bytes, static_cast<float>(x[d]));
    append_bytes(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace

std::optional<MeshFormat> format_of_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".obj") return MeshFormat::obj;
  if (ending == ".off") return MeshFormat::off;
  if (ending == ".ply") return MeshFormat::ply;
  if (ending == ".stl") return MeshFormat::stl;
  return std::nullopt;
}

void write_mesh(const std::string& path, const TriangleMesh& mesh, Existing existing) {
  const auto format = format_of_ending(path);
  if (!format)
    throw input_error("cannot write the mesh '" + path + "'", "its ending is of no format that is known",
                      "name it .obj, .off, .ply or .stl");
  check_can_create(path, existing);
  require_sound(mesh, "cannot write '" + path + "'");
  std::string bytes;
  switch (*format) {
    case MeshFormat::obj: bytes = as_obj(mesh); break;
    case MeshFormat::off: bytes = as_off(mesh); break;
    case MeshFormat::ply: bytes = as_ply(mesh); break;
    case MeshFormat::stl: bytes = as_stl(mesh, path); break;
  }
  NewFile file(path, existing);
  file.write(bytes);
  file.commit();
}

}  // namespace supple
