#include <fmt/format.h>

#include "supple/io/mesh/mesh_readers.hpp"

namespace supple {

namespace {

/// What stands on the line of a vertex, by the keyword [ST][C][N][4][n]OFF of Geomview's manual.
struct OffKeyword {
  bool textures = false, colours = false, normals = false, other_dimension = false;

  /// How many numbers a line may have: a colour has 3 or, in Geomview, 4.
  std::size_t least() const { return 3u + (textures ? 2 : 0) + (colours ? 3 : 0) + (normals ? 3 : 0); }
  std::size_t most() const { return least() + (colours ? 1 : 0); }
};

/// False where the word is no keyword of OFF.
bool parse_keyword(std::string_view word, OffKeyword& out) {
  if (!word.ends_with("OFF")) return false;
  word.remove_suffix(3);
  const auto take = [&](std::string_view letters, bool& flag) {
    if (flag || !word.starts_with(letters)) return false;
    word.remove_prefix(letters.size());
    return flag = true;
  };
  while (take("ST", out.textures) || take("C", out.colours) || take("N", out.normals) ||
         take("4", out.other_dimension) || take("n", out.other_dimension)) {
  }
  return word.empty();
}

class OffReader {
 public:
  OffReader(const std::string& path, std::string_view bytes)
      : lines_(path, bytes, '#'), size_(bytes.size()) {}

  PlacedMesh read() {
    read_header();
    for (std::int64_t k = 0; k < vertices_; ++k) read_vertex(k);
    for (std::int64_t k = 0; k < faces_; ++k) read_face(k);
    if (lines_.next())
      throw lines_.place().fault("there is a line behind the last face",
                                 fmt::format("the header says {} vertices and {} faces", vertices_, faces_),
                                 "correct the numbers of the header, or remove the line");
    return std::move(out_);
  }

 private:
  void read_header() {
    lines_.next();
    std::vector<std::string_view> words = lines_.words();
    if (words.empty() || !parse_keyword(words[0], keyword_))
      throw lines_.place().fault(
          words.empty() ? "there is no line" : fmt::format("the first word is {}", quoted(words[0])),
          "an OFF file begins with OFF, or COFF, NOFF, STOFF", "write OFF in the first line");
    if (keyword_.other_dimension)
      throw lines_.place().fault(fmt::format("the file is {}", quoted(words[0])),
                                 "its points are not of three dimensions", "export it as OFF");
    if (words.size() > 1 && words[1] == "BINARY")
      throw lines_.place().fault("the file is a binary OFF file", "only OFF files of text are read",
                                 "export it as text, or as binary PLY");
    words.erase(words.begin());
    if (words.empty() && lines_.next()) words = lines_.words();
    const MeshPlace place = lines_.place();
    if (words.size() != 2 && words.size() != 3)
      throw place.fault(fmt::format("{} numbers stand behind the word OFF", words.size()),
                        "these must be the numbers of vertices, faces and, optionally, edges",
                        "correct the header");
    const auto count = [&](std::size_t k, const char* what) {
      return whole_number_in(words[k], 0, INT32_MAX, what, place);
    };
    vertices_ = count(0, "the number of vertices");
    faces_ = count(1, "the number of faces");
    if (words.size() == 3) whole_number_in(words[2], 0, INT64_MAX, "the number of edges", place);
    // A vertex takes 6 bytes at least ("0 0 0" and a line end), a face 8.
    if (const std::int64_t least = 6 * vertices_ + 8 * faces_ - 1; least > static_cast<std::int64_t>(size_))
      throw place.fault(fmt::format("the header says {} vertices and {} faces", vertices_, faces_),
                        fmt::format("these take {} bytes or more, and the file has {}", least, size_),
                        "the file may be cut off, or the header damaged");
    out_.mesh.vertex.reserve(static_cast<std::size_t>(vertices_));
    out_.mesh.face.reserve(static_cast<std::size_t>(faces_));
  }

  void go_to_next(const char* what, std::int64_t k, std::int64_t count) {
    if (lines_.next()) return;
    throw lines_.place().fault(fmt::format("the file ends before {} {} of {}", what, k + 1, count),
                               "the header says how many there are", "the file may be cut off");
  }

  void read_vertex(std::int64_t k) {
    go_to_next("vertex", k, vertices_);
    const auto& words = lines_.words();
    const MeshPlace place = lines_.place();
    if (k == 0) columns_ = words.size();
    if (columns_ < keyword_.least() || columns_ > keyword_.most() || words.size() != columns_)
      throw place.fault(fmt::format("the line of a vertex has {} numbers", words.size()),
                        keyword_.least() == keyword_.most()
                            ? fmt::format("each has {} in a file of this kind", keyword_.least())
                            : fmt::format("each has {} or {}, all the same, in a file of this kind",
                                          keyword_.least(), keyword_.most()),
                        "write one vertex on each line; colours need COFF, normals NOFF");
    for (std::size_t d = 3; d < words.size(); ++d) number_in(words[d], place);
    out_.add_vertex({number_in(words[0], place), number_in(words[1], place), number_in(words[2], place)},
                    place.at);
  }

  void read_face(std::int64_t k) {
    go_to_next("face", k, faces_);
    const auto& words = lines_.words();
    const MeshPlace place = lines_.place();
    const std::int64_t corners = whole_number_in(words[0], 0, INT64_MAX, "the number of corners", place);
    if (corners != 3) throw place.not_a_triangle(corners);
    const std::size_t behind = words.size() < 4 ? 2 : words.size() - 4;
    if (behind == 2 || behind > 4)
      throw place.fault(fmt::format("the line of a triangle has {} numbers", words.size()),
                        "it has 4, the number 3 and its corners; 1, 3 or 4 of a colour may follow",
                        "write one face on each line");
    for (std::size_t d = 4; d < words.size(); ++d) number_in(words[d], place);
    const auto corner = [&](std::size_t d) {
      return static_cast<std::int32_t>(
          whole_number_in(words[d], 0, vertices_ - 1, "the number of a corner", place));
    };
    out_.add_face({corner(1), corner(2), corner(3)}, place.at);
  }

  MeshLines lines_;
  std::size_t size_;
  OffKeyword keyword_;
  std::int64_t vertices_ = 0, faces_ = 0;
  std::size_t columns_ = 0;
  PlacedMesh out_;
};

}  // namespace

bool is_off_keyword(std::string_view word) {
  OffKeyword any;
  return parse_keyword(word, any);
}

PlacedMesh read_off(const std::string& path, std::string_view bytes) { return OffReader(path, bytes).read(); }

}  // namespace supple
