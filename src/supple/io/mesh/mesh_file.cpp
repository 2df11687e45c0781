#include "supple/io/mesh/mesh_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "supple/core/path_kind.hpp"
#include "supple/geometry/mesh_fault.hpp"
#include "supple/io/mesh/mesh_format.hpp"
#include "supple/io/mesh/mesh_readers.hpp"

namespace supple {

namespace {

/// Before OFF can be a word of text: marks that some editors put at the beginning.
void refuse_byte_order_mark(const std::string& path, std::string_view bytes) {
  for (const std::string_view mark : {"\xef\xbb\xbf", "\xff\xfe", "\xfe\xff"})
    if (bytes.starts_with(mark) && !has_size_of_binary_stl(bytes))
      throw MeshPlace{path, "byte", 0}.fault("the file begins with a byte order mark",
                                             "mesh files are plain text without one",
                                             "save it as UTF-8 without a byte order mark");
}

/// The first word of the text that is not in a comment.
std::string_view first_word(const std::string& path, std::string_view bytes) {
  MeshLines lines(path, bytes, '#');
  return lines.next() ? lines.words()[0] : std::string_view();
}

/// What only one of the formats begins with.
std::optional<MeshFormat> format_of_content(const std::string& path, std::string_view bytes) {
  if (has_size_of_binary_stl(bytes)) return MeshFormat::stl;
  std::string_view word = first_word(path, bytes);
  word = word.substr(0, word.find('\0'));           // as binary STL fills its header
  if (word.ends_with('\\')) word.remove_suffix(1);  // a line of OBJ that goes on
  if (word == "ply") return MeshFormat::ply;
  if (is_off_keyword(word)) return MeshFormat::off;
  if (is_stl_keyword(word)) return MeshFormat::stl;
  const bool text = bytes.find('\0') == std::string_view::npos;
  if (text && is_obj_statement(word)) return MeshFormat::obj;
  return std::nullopt;
}

PlacedMesh read_placed(const std::string& path) {
  const std::string what = "cannot read the mesh '" + path + "'";
  std::error_code none;  // where nothing is there, or a pipe
  if (const auto size = std::filesystem::file_size(path, none); !none && size > longest_mesh_file)
    throw file_error(what, fmt::format("it is longer than {} bytes", longest_mesh_file),
                     "make the mesh coarser: a particle has fewer triangles");
  const std::string bytes = read_whole_file(path, "the mesh", longest_mesh_file);
  if (bytes.empty()) throw file_error(what, "it is empty");
  refuse_byte_order_mark(path, bytes);
  auto format = format_of_content(path, bytes);
  if (!format) format = format_of_ending(path);
  if (!format)
    throw file_error(what, "neither its first word nor its ending is of a format that is known",
                     "export it as OBJ, STL, PLY or OFF");
  switch (*format) {
    case MeshFormat::obj: return read_obj(path, bytes);
    case MeshFormat::off: return read_off(path, bytes);
    case MeshFormat::ply: return read_ply(path, bytes);
    case MeshFormat::stl: return read_stl(path, bytes);
  }
  return {};
}

/// " [triangle 4: line 17, vertex 3: line 5; ...]", of those few that the words of a fault name.
std::string places_of(const MeshFault& fault, const PlacedMesh& placed) {
  constexpr std::size_t most = 4;
  std::string out;
  const auto append = [&](const char* name, const std::vector<std::int32_t>& numbers,
                          const std::vector<std::uint32_t>& at) {
    for (std::size_t k = 0; k < std::min(numbers.size(), most); ++k)
      out += fmt::format("{}{} {}: {} {}", out.empty() ? " [counted from 0; " : ", ", name, numbers[k],
                         placed.unit, at.at(static_cast<std::size_t>(numbers[k])));
  };
  append("triangle", fault.triangles, placed.face_at);
  append("vertex", fault.vertices, placed.vertex_at);
  return out.empty() ? out : out + "]";
}

}  // namespace

TriangleMesh read_mesh(const std::string& path) {
  PlacedMesh placed = read_placed(path);
  if (const auto fault = find_fault(placed.mesh))
    throw input_error(fmt::format("the mesh of '{}': {}{}", path, fault->what, places_of(*fault, placed)),
                      fault->why, fault->to_do);
  return std::move(placed.mesh);
}

}  // namespace supple
