#include "supple/io/mesh/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "supple/core/nearest_name.hpp"
#include "supple/io/mesh/mesh_text.hpp"

namespace supple {

namespace {

// The names of 1994 (Turk, "The PLY polygon file format") and those with sizes that came later.
struct TypeName {
  const char* name;
  PlyType type;
};
constexpr TypeName type_names[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

/// Where a header ends, and the place behind it: a binary body may begin with any byte, so that its line end
/// is the one of the first line.
std::size_t end_of_header(std::string_view bytes, std::string_view end_word) {
  const std::size_t first = bytes.find_first_of("\r\n");
  if (first == std::string_view::npos) return first;
  const std::string line_end(bytes.substr(first, bytes.substr(first).starts_with("\r\n") ? 2 : 1));
  const std::string last = line_end + std::string(end_word) + line_end;
  const std::size_t at = bytes.find(last);
  return at == std::string_view::npos ? at : at + last.size();
}

class HeaderReader {
 public:
  HeaderReader(const std::string& path, std::string_view bytes)
      : path_(path),
        size_(bytes.size()),
        end_(end_of_header(bytes, end_word)),
        lines_(path, bytes.substr(0, end_), '\0') {}

  PlyHeader read() {
    if (!lines_.next() || lines_.words()[0] != "ply")
      throw lines_.place().fault(lines_.words().empty()
                                     ? "there is no line"
                                     : fmt::format("the first word is {}", quoted(lines_.words()[0])),
                                 "a PLY file begins with 'ply'", "give the file the ending of its format");
    expect_words(1, "ply");
    if (end_ == std::string_view::npos)
      throw MeshPlace{path_, "line", 1}.fault(
          "the header has no end", "it ends with a line 'end_header', with the line end of the line 'ply'",
          "the file may be cut off");
    while (lines_.next() && lines_.words()[0] != end_word) read_line();
    expect_words(1, "end_header");
    if (!format_)
      throw lines_.place().fault("the header has no format", "it says how numbers stand in the file",
                                 "write 'format ascii 1.0' behind the first line, if it is text");
    out_.size = end_;
    out_.lines = lines_.place().at;
    check_elements();
    return std::move(out_);
  }

 private:
  static constexpr std::string_view end_word = "end_header";

  Error fault(const std::string& what, const std::string& why, const std::string& to_do) const {
    return lines_.place().fault(what, why, to_do);
  }
  void expect_words(std::size_t count, const char* form) const {
    if (lines_.words().size() != count)
      throw fault(fmt::format("the line has {} words", lines_.words().size()),
                  fmt::format("it should be '{}'", form), "correct the line");
  }

  void read_line() {
    const std::string_view name = lines_.words()[0];
    if (name == "comment" || name == "obj_info") return;
    if (name == "format") return read_format();
    if (name == "element") return read_element();
    if (name == "property") return read_property();
    const auto near = nearest_name(name, {"comment", "obj_info", "format", "element", "property"});
    throw fault(fmt::format("unknown statement {} in the header", quoted(name)),
                "a header has format, element, property, comment and obj_info",
                near ? "did you mean '" + *near + "'?" : "correct the line");
  }

  void read_format() {
    expect_words(3, "format ascii 1.0");
    const std::string_view name = lines_.words()[1];
    if (format_) throw fault("the format is said twice", "a file has one", "remove one of the lines");
    format_ = true;
    if (lines_.words()[2] != "1.0")
      throw fault(fmt::format("the version is {}", quoted(lines_.words()[2])), "the only one is 1.0",
                  "correct the line");
    if (name == "binary_little_endian") out_.order = std::endian::little;
    else if (name == "binary_big_endian") out_.order = std::endian::big;
    else if (name != "ascii")
      throw fault(fmt::format("unknown format {}", quoted(name)),
                  "it is ascii, binary_little_endian or binary_big_endian", "correct the line");
  }

  void read_element() {
    expect_words(3, "element vertex 12");
    const std::string name(lines_.words()[1]);
    for (const PlyElement& other : out_.elements)
      if (other.name == name)
        throw fault(fmt::format("there is a second element {}", quoted(name)), "each has one line",
                    "remove or rename one");
    out_.elements.push_back(
        {name, whole_number_in(lines_.words()[2], 0, INT64_MAX, "the number of rows", lines_.place()), {}});
    element_line_.push_back(lines_.place().at);
  }

  PlyType type_in(std::string_view word) const {
    std::vector<std::string> names;
    for (const auto& [name, type] : type_names) {
      if (word == name) return type;
      names.emplace_back(name);
    }
    const auto near = nearest_name(word, names);
    throw fault(fmt::format("unknown type {}", quoted(word)), "the types are " + join_names(names),
                near ? "did you mean '" + *near + "'?" : "take one of these");
  }

  void read_property() {
    const auto& words = lines_.words();
    const bool list = words.size() > 1 && words[1] == "list";
    expect_words(list ? 5 : 3, list ? "property list uchar int vertex_indices" : "property double x");
    if (out_.elements.empty())
      throw fault("a property stands before the first element", "it must belong to one",
                  "put the line behind its element");
    PlyProperty property{std::string(words.back()), type_in(words[words.size() - 2]), std::nullopt};
    if (list) {
      property.count = type_in(words[2]);
      if (!is_whole(*property.count))
        throw fault(fmt::format("the number of values of a list is a {}", words[2]), "it must be whole",
                    "take uchar or int");
    }
    std::vector<PlyProperty>& properties = out_.elements.back().properties;
    for (const PlyProperty& other : properties)
      if (other.name == property.name)
        throw fault(fmt::format("there is a second property {}", quoted(property.name)),
                    "each of an element has a name of its own", "remove or rename one");
    properties.push_back(property);
  }

  /// That the body can hold what the header says: in text a value takes two bytes, with what separates it
  /// from the next.
  void check_elements() const {
    const std::size_t body = size_ - end_ + (out_.order ? 0 : 1);
    std::size_t left = body;
    for (std::size_t e = 0; e < out_.elements.size(); ++e) {
      const PlyElement& element = out_.elements[e];
      const MeshPlace place{path_, "line", element_line_[e]};
      std::size_t row = 0;
      for (const PlyProperty& property : element.properties) row += out_.order ? property.least_size() : 2;
      if (element.rows > 0 && row == 0)
        throw place.fault(fmt::format("the element {} has no properties", quoted(element.name)),
                          "its rows would be empty", "remove it, or add its properties");
      if (element.rows > 0 && static_cast<std::uint64_t>(element.rows) > left / row)
        throw place.fault(
            fmt::format("there would be {} rows of {}", element.rows, quoted(element.name)),
            fmt::format("each takes {} bytes or more, and {} bytes follow the header", row, body),
            "the file may be cut off, or the number damaged");
      left -= static_cast<std::size_t>(element.rows) * row;
    }
  }

  const std::string& path_;
  std::size_t size_, end_;  ///< of the file, of its header
  MeshLines lines_;
  PlyHeader out_;
  bool format_ = false;
  std::vector<std::size_t> element_line_;
};

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::float64: return 8;
    default: return 4;
  }
}

bool is_whole(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

PlyHeader read_ply_header(const std::string& path, std::string_view bytes) {
  return HeaderReader(path, bytes).read();
}

}  // namespace supple
