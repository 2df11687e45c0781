#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <tuple>

#include "supple/io/mesh/mesh_bytes.hpp"
#include "supple/io/mesh/mesh_readers.hpp"

namespace supple {

namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

bool is_word(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// The facets of a file one after the other, three corners each, with the lines or bytes where they stand.
class FacetSoup {
 public:
  FacetSoup(const std::string& path, const char* unit) : path_(path) { out_.unit = unit; }

  MeshPlace place(std::size_t at) const { return out_.place(path_, at); }

  void add(const Vec3& normal, const std::array<Vec3, 3>& corner, const std::array<std::size_t, 3>& corner_at,
           std::size_t at) {
    if (dot(normal, cross(corner[1] - corner[0], corner[2] - corner[0])) < 0)
      throw place(at).fault(
          fmt::format("the normal of facet {} points the other way than its corners", out_.mesh.face.size()),
          "its corners must go counter-clockwise as seen from where it points, and both must say where "
          "outside is",
          "turn the corners or the normal round");
    for (std::size_t k = 0; k < 3; ++k) {
      corner_.push_back(corner[k]);
      corner_at_.push_back(corner_at[k]);
    }
    out_.add_face({}, at);
  }

  /// Equal corners become one vertex.
  PlacedMesh joined() && {
    const auto key = [&](std::uint32_t c) { return std::tie(corner_[c][0], corner_[c][1], corner_[c][2]); };
    std::vector<std::uint32_t> order(corner_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tuple_cat(key(a), std::tie(a)) < std::tuple_cat(key(b), std::tie(b));
    });
    std::vector<std::uint32_t> first(corner_.size());  // the first corner at this place
    for (std::size_t k = 0; k < order.size(); ++k)
      first[order[k]] = k > 0 && key(order[k - 1]) == key(order[k]) ? first[order[k - 1]] : order[k];
    std::vector<std::int32_t> vertex(corner_.size());
    for (std::uint32_t c = 0; c < corner_.size(); ++c) {
      if (first[c] == c) {
        vertex[c] = static_cast<std::int32_t>(out_.mesh.vertex.size());
        out_.add_vertex(corner_[c], corner_at_[c]);
      }
      out_.mesh.face[c / 3][c % 3] = vertex[first[c]];
    }
    return std::move(out_);
  }

 private:
  const std::string& path_;
  PlacedMesh out_;
  std::vector<Vec3> corner_;
  std::vector<std::size_t> corner_at_;
};

/// "solid [name]", "facet normal", "outer loop", three of "vertex", "endloop", "endfacet", ..., "endsolid
/// [name]". Words in lower or upper case, anywhere on lines but for solid and endsolid, whose lines end with
/// any name.
class StlText {
 public:
  StlText(const std::string& path, std::string_view bytes) : lines_(path, bytes, '\0'), soup_(path, "line") {}

  PlacedMesh read() {
    while (lines_.next()) {
      at_ = 0;
      expect("solid");
      at_ = lines_.words().size();  // a name
      while (!is_word(peek("facet"), "endsolid")) read_facet();
      at_ = lines_.words().size();
    }
    return std::move(soup_).joined();
  }

 private:
  /// The next word; `wanted` is what it should be, for the error where the file ends.
  std::string_view peek(const char* wanted) {
    if (at_ == lines_.words().size()) {
      if (!lines_.next())
        throw lines_.place().fault(fmt::format("the file ends where '{}' should be", wanted),
                                   "a solid ends with 'endsolid'", "the file may be cut off");
      at_ = 0;
    }
    return lines_.words()[at_];
  }
  std::string_view take(const char* wanted) {
    const std::string_view word = peek(wanted);
    ++at_;
    return word;
  }
  void expect(const char* keyword) {
    if (const std::string_view word = take(keyword); !is_word(word, keyword))
      throw lines_.place().fault(fmt::format("{} stands where '{}' should be", quoted(word), keyword),
                                 "an STL file of text has an order of words", "correct the word");
  }
  Vec3 take_vector() {
    Vec3 x;
    for (int d = 0; d < 3; ++d) {
      const std::string_view word = take("a number");
      x[d] = number_in(word, lines_.place());
    }
    return x;
  }
  void read_facet() {
    expect("facet");
    const std::size_t at = lines_.place().at;
    expect("normal");
    const Vec3 normal = take_vector();
    expect("outer");
    expect("loop");
    std::array<Vec3, 3> corner;
    std::array<std::size_t, 3> corner_at{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_word(peek("vertex"), "endloop"))
        throw lines_.place().not_a_triangle(static_cast<std::int64_t>(k));
      expect("vertex");
      corner_at[k] = lines_.place().at;
      corner[k] = take_vector();
    }
    if (is_word(peek("endloop"), "vertex")) refuse_polygon(at);
    expect("endloop");
    expect("endfacet");
    soup_.add(normal, corner, corner_at, at);
  }
  [[noreturn]] void refuse_polygon(std::size_t at) {
    std::int64_t corners = 3;
    for (; is_word(peek("endloop"), "vertex"); ++corners) {
      expect("vertex");
      take_vector();
    }
    throw soup_.place(at).not_a_triangle(corners);
  }

  MeshLines lines_;
  std::size_t at_ = 0;  ///< the next word of the present line
  FacetSoup soup_;
};

std::uint32_t facets_of(std::string_view bytes) {
  return number_at<std::uint32_t>(bytes, header_size - 4, std::endian::little);
}

/// 80 bytes of anything, the number of facets, and for each 12 floats, the normal and the corners, and two
/// bytes of anything.
PlacedMesh read_binary(const std::string& path, std::string_view bytes) {
  if (!has_size_of_binary_stl(bytes)) {
    const MeshPlace place{path, "byte", bytes.size()};
    if (bytes.size() < header_size)
      throw place.fault(fmt::format("the file ends after {} bytes", bytes.size()),
                        "a binary STL file begins with 84, one of text with 'solid'",
                        "the file may be cut off");
    const std::uint32_t facets = facets_of(bytes);
    throw place.fault(
        fmt::format("the file has {} bytes", bytes.size()),
        fmt::format("bytes 80 to 83 say that there are {} facets, and a binary STL file of these has {}",
                    facets, header_size + facet_size * std::uint64_t{facets}),
        "the file may be cut off, or damaged");
  }
  FacetSoup soup(path, "byte");
  for (std::size_t at = header_size; at < bytes.size(); at += facet_size) {
    const auto vector_at = [&](std::size_t where) {
      Vec3 x;
      for (int d = 0; d < 3; ++d) {
        const std::size_t byte = where + 4 * static_cast<std::size_t>(d);
        x[d] = number_at<float>(bytes, byte, std::endian::little);
        if (!std::isfinite(x[d]))
          throw soup.place(byte).fault(fmt::format("a number of a facet is {}", x[d]),
                                       "normals and places must be finite",
                                       "export the mesh again; facets without area may be the reason");
      }
      return x;
    };
    const Vec3 normal = vector_at(at);
    soup.add(normal, {vector_at(at + 12), vector_at(at + 24), vector_at(at + 36)},
             {at + 12, at + 24, at + 36}, at);
  }
  return std::move(soup).joined();
}

}  // namespace

bool is_stl_keyword(std::string_view word) { return is_word(word, "solid"); }

bool has_size_of_binary_stl(std::string_view bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + facet_size * std::uint64_t{facets_of(bytes)};
}

PlacedMesh read_stl(const std::string& path, std::string_view bytes) {
  // A byte of a text may be damaged to be 0; that of a binary file which ends too early is 0 in many places.
  const bool text = !has_size_of_binary_stl(bytes) && (bytes.find('\0') == std::string_view::npos ||
                                                       bytes.find("endloop") != std::string_view::npos);
  return text ? StlText(path, bytes).read() : read_binary(path, bytes);
}

}  // namespace supple
