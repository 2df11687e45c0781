/// The HDF5 C library with ids that close themselves, and errors that name file, object and reason.
/// Everything here may throw a file error (exit code 4); HDF5 itself prints nothing.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "supple/core/new_file.hpp"

namespace supple::h5 {

/// Lengths of an array, outermost first.
using Shape = std::vector<std::uint64_t>;

/// An open object of HDF5 (group, dataset, type, ...), closed by the destructor. Groups and datasets may have
/// attributes.
class Object {
 public:
  Object() = default;
  explicit Object(std::int64_t id) : id_(id) {}
  Object(Object&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Object();

  std::int64_t id() const { return id_; }
  /// "file:/path/in/file", for errors.
  std::string where() const;

  bool has_attribute(const std::string& name) const;
  void set(const std::string& name, double value);
  void set(const std::string& name, std::int64_t value);
  void set(const std::string& name, const std::string& text);
  void set(const std::string& name, const std::vector<std::string>& texts);
  double number(const std::string& name) const;
  std::int64_t integer(const std::string& name) const;
  std::string text(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;

 private:
  std::int64_t id_ = -1;
};

/// How the arrays of a file that are larger than a header are kept: in pieces with a checksum each,
/// compressed where a sample of them becomes smaller by a tenth, or as they are. Many numbers of a simulation
/// become little smaller, and compressing them takes longer than writing them.
enum class Storage { compressed, plain };

/// A group. Element types T are double, std::int32_t, std::int64_t, std::uint8_t and std::string (UTF-8;
/// written with a fixed length, which every reader knows; read with any). What is read is checked: no array
/// is larger than its file can hold, every text is UTF-8.
class Group : public Object {
 public:
  Group() = default;
  explicit Group(std::int64_t id, Storage storage = Storage::compressed) : Object(id), storage_(storage) {}

  bool has(const std::string& name) const;
  /// Whether the member is a group; otherwise it is a dataset.
  bool is_group(const std::string& name) const;
  /// Names of members in the order of their creation.
  std::vector<std::string> names() const;
  Group create_group(const std::string& name);
  Group open_group(const std::string& name) const;
  Object open_dataset(const std::string& name) const;
  void remove(const std::string& name);
  /// Copies the member `name` of `from` with everything below it; arrays are kept as those of this group are.
  void copy(const Group& from, const std::string& name);
  /// Copies everything in `from`; an array that is equal, bit for bit, to that of the same path in one of
  /// `likes`, groups of this file, becomes another name of it.
  void copy_or_share(const Group& from, const std::vector<Group>& likes);
  /// Copies all attributes of `from`.
  void copy_attributes(const Object& from);

  /// Writes an array; an empty shape means one dimension with all values. A small array is kept in the header
  /// of its dataset, a larger one in pieces (see Storage).
  template <class T>
  Object write(const std::string& name, std::span<const T> values, const Shape& shape = {});
  template <class T>
  Object write(const std::string& name, const std::vector<T>& values, const Shape& shape = {}) {
    return write(name, std::span<const T>(values), shape);
  }
  /// Writes one number or text.
  template <class T>
  Object write_scalar(const std::string& name, const T& value);

  /// Creates the array `name` with the type, row shape and attributes of that in `from`, for `rows` rows,
  /// which copy_rows() fills.
  Object create_like(const Group& from, const std::string& name, std::uint64_t rows);
  /// Writes all rows of the array `name` into the array `to` of another file, from row `first` on. A piece of
  /// `to` that is filled in parts is compressed once if `to` stays open between them.
  void copy_rows(const std::string& name, const Object& to, std::uint64_t first) const;

  Shape shape(const std::string& name) const;
  /// All values, row after row, converted where the file holds another type of number.
  template <class T>
  std::vector<T> read(const std::string& name) const;
  template <class T>
  T read_scalar(const std::string& name) const;
  /// The values in rows [first, first + count) of the first dimension.
  template <class T>
  std::vector<T> read_rows(const std::string& name, std::uint64_t first, std::uint64_t count) const;

 private:
  Storage storage_ = Storage::compressed;  ///< of what is written
};

/// The root group of a new file in memory; errors call it `name`. It is in memory because HDF5 does not
/// survive a full disk. The file is gone with its last open object.
Group create_file(const std::string& name, Storage storage = Storage::compressed);
/// The bytes of the file in memory that `root` belongs to, until it changes or is gone.
std::string_view bytes_of(const Group& root);
/// Writes the file that `root` belongs to, completely or not at all. Throws a file error as NewFile does.
void save(Group& root, const std::string& path, Existing existing = Existing::refuse);
/// The root group of a file, read only. The error tells a missing, unreadable, foreign and truncated file
/// apart.
Group open_file(const std::string& path);

}  // namespace supple::h5
