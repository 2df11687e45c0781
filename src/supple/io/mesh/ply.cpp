#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "supple/io/mesh/mesh_bytes.hpp"
#include "supple/io/mesh/mesh_readers.hpp"
#include "supple/io/mesh/ply_header.hpp"

namespace supple {

namespace {

/// Calls of(T{}) with T the C++ type of a PLY number.
template <class Function>
auto with_type(PlyType type, Function&& of) {
  switch (type) {
    case PlyType::int8: return of(std::int8_t{});
    case PlyType::uint8: return of(std::uint8_t{});
    case PlyType::int16: return of(std::int16_t{});
    case PlyType::uint16: return of(std::uint16_t{});
    case PlyType::int32: return of(std::int32_t{});
    case PlyType::uint32: return of(std::uint32_t{});
    case PlyType::float32: return of(float{});
    case PlyType::float64: return of(double{});
  }
  return of(double{});
}

/// The rows of a text: each on one line.
class TextRows {
 public:
  TextRows(const std::string& path, std::string_view bytes, const PlyHeader& header)
      : lines_(path, bytes.substr(header.size), '\0', Continuation::none, header.lines + 1) {}

  static constexpr const char* unit = "line";
  MeshPlace place() const { return lines_.place(); }

  void begin_row(const PlyElement& element) {
    if (!lines_.next())
      throw place().fault(fmt::format("the file ends before the last row of '{}'", element.name),
                          fmt::format("the header says {} rows", element.rows), "the file may be cut off");
    at_ = 0;
  }
  /// A number; whole numbers of all types are exact in a double.
  double take(PlyType type) {
    const std::string_view word = take_word();
    return with_type(type, [&](auto of_type) -> double {
      using T = decltype(of_type);
      if constexpr (std::is_floating_point_v<T>) return number_in(word, place());
      else
        return static_cast<double>(whole_number_in(word, std::numeric_limits<T>::min(),
                                                   std::numeric_limits<T>::max(), "a number of the row",
                                                   place()));
    });
  }
  void skip(PlyType, std::int64_t count) {
    for (std::int64_t k = 0; k < count; ++k) take_word();
  }
  void end_row() {
    if (at_ != lines_.words().size())
      throw place().fault(fmt::format("the line has {} words", lines_.words().size()),
                          fmt::format("the properties of the header make {}", at_),
                          "write one row on each line");
  }
  /// A number at the very end of a file may have lost its last digits.
  void end_vertices() {
    if (!lines_.is_complete())
      throw place().fault("the last vertex has no line end", "digits may be missing",
                          "end the line if it is whole");
  }
  void end() {
    if (lines_.next())
      throw place().fault("there is a line behind the last row", "the header says how many rows there are",
                          "correct the header, or remove the line");
  }

 private:
  std::string_view take_word() {
    if (at_ == lines_.words().size())
      throw place().fault(fmt::format("the line has only {} words", at_),
                          "the properties of the header make more", "write one row on each line");
    return lines_.words()[at_++];
  }
  MeshLines lines_;
  std::size_t at_ = 0;
};

class BinaryRows {
 public:
  BinaryRows(const std::string& path, std::string_view bytes, const PlyHeader& header)
      : path_(path), bytes_(bytes), order_(*header.order), at_(header.size) {}

  static constexpr const char* unit = "byte";
  MeshPlace place() const { return {path_, unit, row_}; }

  void begin_row(const PlyElement&) { row_ = at_; }
  double take(PlyType type) {
    require(size_of(type), 1);
    return with_type(type, [&](auto of_type) -> double {
      using T = decltype(of_type);
      const T x = number_at<T>(bytes_, at_, order_);
      if constexpr (std::is_floating_point_v<T>)
        if (!std::isfinite(x))
          throw MeshPlace{path_, unit, at_}.fault(fmt::format("a number is {}", x), "it must be finite",
                                                  "correct it, or export the mesh again");
      at_ += sizeof(T);
      return static_cast<double>(x);
    });
  }
  void skip(PlyType type, std::int64_t count) {
    require(size_of(type), count);
    at_ += size_of(type) * static_cast<std::size_t>(count);
  }
  void end_row() {}
  void end_vertices() {}
  void end() const {
    if (at_ != bytes_.size())
      throw MeshPlace{path_, unit, at_}.fault(
          fmt::format("{} bytes are behind the last row", bytes_.size() - at_),
          "the header says how many rows there are", "the file may be damaged; export the mesh again");
  }

 private:
  void require(std::size_t size, std::int64_t count) const {
    if ((bytes_.size() - at_) / size >= static_cast<std::uint64_t>(count)) return;
    throw place().fault(
        "the file ends within the row that begins here",
        fmt::format("{} more numbers of {} bytes should stand from byte {} on", count, size, at_),
        "the file may be cut off, or damaged");
  }
  const std::string& path_;
  std::string_view bytes_;
  std::endian order_;
  std::size_t at_, row_ = 0;
};

/// What a property is to a mesh.
enum class Meaning { ignored, x, y, z, corners };

class PlyReader {
 public:
  PlyReader(const std::string& path, std::string_view bytes)
      : path_(path), bytes_(bytes), header_(read_ply_header(path, bytes)) {}

  PlacedMesh read() {
    const std::size_t vertices = find_element("vertex"), faces = find_element("face");
    for (std::size_t e = 0; e < header_.elements.size(); ++e)
      meanings_.push_back(e == vertices ? meanings_of_vertex()
                          : e == faces  ? meanings_of_face()
                                        : none_of(e));
    vertices_ = header_.elements[vertices].rows;
    out_.mesh.vertex.reserve(static_cast<std::size_t>(vertices_));
    out_.mesh.face.reserve(static_cast<std::size_t>(header_.elements[faces].rows));
    if (header_.order) read_rows(BinaryRows(path_, bytes_, header_));
    else read_rows(TextRows(path_, bytes_, header_));
    return std::move(out_);
  }

 private:
  MeshPlace header_place() const { return {path_, "line", header_.lines}; }
  std::size_t find_element(std::string_view name) const {
    for (std::size_t e = 0; e < header_.elements.size(); ++e)
      if (header_.elements[e].name == name) return e;
    throw header_place().fault(fmt::format("the header has no element '{}'", name),
                               "a mesh has the elements vertex and face",
                               "export the mesh again, with faces");
  }
  const std::vector<PlyProperty>& properties(std::string_view element) const {
    return header_.elements[find_element(element)].properties;
  }

  std::vector<Meaning> meanings_of_vertex() const {
    const std::vector<PlyProperty>& all = properties("vertex");
    std::vector<Meaning> out(all.size(), Meaning::ignored);
    for (const auto& [name, meaning] : {std::pair{"x", Meaning::x}, {"y", Meaning::y}, {"z", Meaning::z}}) {
      bool found = false;
      for (std::size_t p = 0; p < all.size(); ++p)
        if (all[p].name == name && !all[p].count) {
          out[p] = meaning;
          found = true;
        }
      if (!found)
        throw header_place().fault(fmt::format("a vertex has no property '{}'", name),
                                   "each has the numbers x, y and z", "export the mesh in three dimensions");
    }
    return out;
  }

  std::vector<Meaning> meanings_of_face() const {
    const std::vector<PlyProperty>& all = properties("face");
    std::vector<Meaning> out(all.size(), Meaning::ignored);
    int found = 0;
    for (std::size_t p = 0; p < all.size(); ++p)
      if (all[p].name == "vertex_indices" || all[p].name == "vertex_index") {
        if (!all[p].count || !is_whole(all[p].type))
          throw header_place().fault(fmt::format("'{}' is no list of whole numbers", all[p].name),
                                     "it names the corners of a face",
                                     "write 'property list uchar int vertex_indices'");
        out[p] = Meaning::corners;
        ++found;
      }
    if (found != 1)
      throw header_place().fault(fmt::format("a face has {} lists of corners", found),
                                 "each has one, vertex_indices or vertex_index",
                                 "write 'property list uchar int vertex_indices'");
    return out;
  }

  std::vector<Meaning> none_of(std::size_t e) const {
    const PlyElement& element = header_.elements[e];
    if (element.name == "tristrips" && element.rows > 0)
      throw header_place().fault("the file has triangle strips", "only the element 'face' is read",
                                 "export the mesh as triangles");
    return std::vector<Meaning>(element.properties.size(), Meaning::ignored);
  }

  template <class Rows>
  void read_rows(Rows rows) {
    out_.unit = Rows::unit;
    for (std::size_t e = 0; e < header_.elements.size(); ++e) {
      const PlyElement& element = header_.elements[e];
      for (std::int64_t row = 0; row < element.rows; ++row) {
        rows.begin_row(element);
        read_row(rows, element, meanings_[e]);
        rows.end_row();
        if (element.name == "vertex") out_.add_vertex(present_vertex_, rows.place().at);
        if (element.name == "face") out_.add_face(present_corners_, rows.place().at);
      }
      if (element.name == "vertex") rows.end_vertices();
    }
    rows.end();
  }

  template <class Rows>
  void read_row(Rows& rows, const PlyElement& element, const std::vector<Meaning>& meanings) {
    for (std::size_t p = 0; p < meanings.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const std::int64_t count = property.count ? take_count(rows, *property.count) : 1;
      if (meanings[p] == Meaning::ignored) rows.skip(property.type, count);
      else if (meanings[p] == Meaning::corners) take_corners(rows, property.type, count);
      else
        present_vertex_[static_cast<int>(meanings[p]) - static_cast<int>(Meaning::x)] =
            rows.take(property.type);
    }
  }

  template <class Rows>
  std::int64_t take_count(Rows& rows, PlyType type) {
    const double count = rows.take(type);
    if (count < 0)
      throw rows.place().fault(fmt::format("a list has {} values", count), "it cannot have fewer than 0",
                               "the file may be damaged");
    return static_cast<std::int64_t>(count);
  }

  template <class Rows>
  void take_corners(Rows& rows, PlyType type, std::int64_t count) {
    if (count != 3) throw rows.place().not_a_triangle(count);
    for (std::int32_t& corner : present_corners_) {
      const double vertex = rows.take(type);
      if (vertex < 0 || vertex >= static_cast<double>(vertices_))
        throw rows.place().fault(fmt::format("a face names vertex {}", vertex),
                                 fmt::format("there are {}, counted from 0 on", vertices_),
                                 "correct the number, or count from 0 on");
      corner = static_cast<std::int32_t>(vertex);
    }
  }

  const std::string& path_;
  std::string_view bytes_;
  PlyHeader header_;
  std::vector<std::vector<Meaning>> meanings_;  ///< of the properties of each element
  std::int64_t vertices_ = 0;
  Vec3 present_vertex_;
  std::array<std::int32_t, 3> present_corners_{};
  PlacedMesh out_;
};

}  // namespace

PlacedMesh read_ply(const std::string& path, std::string_view bytes) { return PlyReader(path, bytes).read(); }

}  // namespace supple
