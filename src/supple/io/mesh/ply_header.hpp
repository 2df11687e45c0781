/// The header of a PLY file: what its elements consist of. For the reader of PLY only.
#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace supple {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a number; whether it is a whole one.
std::size_t size_of(PlyType type);
bool is_whole(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count;  ///< of a list: the type of the number of its values

  /// The fewest bytes that a value takes in a binary file.
  std::size_t least_size() const { return size_of(count.value_or(type)); }
};

struct PlyElement {
  std::string name;
  std::int64_t rows = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::optional<std::endian> order;  ///< of bytes; none where the file is text
  std::vector<PlyElement> elements;
  std::size_t size = 0, lines = 0;  ///< of the header itself
};

/// Reads the header, from `ply` to `end_header`. Throws a file error with the line where it is not one, says
/// nothing of vertices and faces as read_ply needs them, or promises more than the file can hold.
PlyHeader read_ply_header(const std::string& path, std::string_view bytes);

}  // namespace supple
