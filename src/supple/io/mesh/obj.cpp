#include <fmt/format.h>

#include <algorithm>

#include "supple/core/nearest_name.hpp"
#include "supple/io/mesh/mesh_readers.hpp"

namespace supple {

namespace {

// The statements of "Object Files", appendix B1 of the Advanced Visualizer manual (Wavefront).
const std::vector<std::string> ignored = {
    "vt", "vn",    "vp",       "g",        "o",   "s",      "usemtl", "mtllib",     "l",
    "p",  "bevel", "c_interp", "d_interp", "lod", "usemap", "maplib", "shadow_obj", "trace_obj"};
const std::vector<std::string> curved = {"cstype", "deg",  "bmat", "step", "curv",  "curv2", "surf", "parm",
                                         "trim",   "hole", "scrv", "sp",   "ctech", "stech", "con"};

bool is_among(const std::vector<std::string>& names, std::string_view word) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

class ObjReader {
 public:
  ObjReader(const std::string& path, std::string_view bytes)
      : lines_(path, bytes, '#', Continuation::backslash) {}

  PlacedMesh read() {
    while (lines_.next()) read_statement();
    return std::move(out_);
  }

 private:
  void read_statement() {
    const std::string_view name = lines_.words()[0];
    if (name == "v") return read_vertex();
    if (name == "f") return read_face();
    if (name == "vt") ++textures_;
    if (name == "vn") ++normals_;
    if (is_among(ignored, name)) return;
    const MeshPlace place = lines_.place();
    if (is_among(curved, name))
      throw place.fault(fmt::format("the statement {} is of a curve or a free-form surface", quoted(name)),
                        "a particle consists of triangles", "export the surface as triangles");
    std::vector<std::string> known = ignored;
    known.insert(known.end(), {"v", "f"});
    const auto near = nearest_name(name, known);
    throw place.fault(fmt::format("unknown statement {}", quoted(name)),
                      "a mesh has v for vertices and f for faces",
                      near ? "did you mean '" + *near + "'?" : "remove the line, or correct it");
  }

  void read_vertex() {
    const auto& words = lines_.words();
    const MeshPlace place = lines_.place();
    const std::size_t numbers = words.size() - 1;
    if (numbers != 3 && numbers != 4 && numbers != 6)
      throw place.fault(fmt::format("a vertex has {} numbers", numbers),
                        "it has 3 coordinates, and a weight or 3 of a colour may follow", "correct the line");
    if (numbers == 4 && number_in(words[4], place) != 1)
      throw place.fault(fmt::format("a vertex has the weight {}", quoted(words[4])),
                        "corners of triangles have the weight 1", "remove the fourth number");
    for (std::size_t k = 4; k < words.size(); ++k) number_in(words[k], place);
    out_.add_vertex({number_in(words[1], place), number_in(words[2], place), number_in(words[3], place)},
                    place.at);
  }

  void read_face() {
    const auto& words = lines_.words();
    const MeshPlace place = lines_.place();
    if (words.size() != 4) throw place.not_a_triangle(static_cast<std::int64_t>(words.size()) - 1);
    out_.add_face({corner(words[1]), corner(words[2]), corner(words[3])}, place.at);
  }

  /// "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal".
  std::int32_t corner(std::string_view word) const {
    const std::size_t slash = word.find('/');
    const std::int64_t vertex =
        index(word.substr(0, slash), static_cast<std::int64_t>(out_.mesh.vertex.size()), "vertex");
    if (slash == std::string_view::npos) return static_cast<std::int32_t>(vertex);
    const std::string_view others = word.substr(slash + 1);
    const std::size_t second = others.find('/');
    const bool two = second != std::string_view::npos;
    if (!two || second > 0) index(others.substr(0, second), textures_, "texture coordinate");
    if (two) index(others.substr(second + 1), normals_, "normal");
    return static_cast<std::int32_t>(vertex);
  }

  /// From 0 on, of what is numbered from 1 on, or from -1 backwards.
  std::int64_t index(std::string_view word, std::int64_t count, const char* what) const {
    const MeshPlace place = lines_.place();
    const std::int64_t n = whole_number_in(word, INT64_MIN, INT64_MAX, "the number of a corner", place);
    if (n == 0)
      throw place.fault(fmt::format("a face names {} 0", what), "OBJ files count from 1 on",
                        "add 1 to the numbers if the file counts from 0 on");
    if (n > count || n < -count)
      throw place.fault(fmt::format("a face names {} {}", what, n),
                        fmt::format("{} of them stand before this line", count),
                        "correct the number, or put the face behind its vertices");
    return n > 0 ? n - 1 : count + n;
  }

  MeshLines lines_;
  PlacedMesh out_;
  std::int64_t textures_ = 0, normals_ = 0;
};

}  // namespace

bool is_obj_statement(std::string_view word) {
  return word == "v" || word == "f" || is_among(ignored, word) || is_among(curved, word);
}

PlacedMesh read_obj(const std::string& path, std::string_view bytes) { return ObjReader(path, bytes).read(); }

}  // namespace supple
