/// The HDF5 C library, owned: ids that close themselves, and errors that say file, object and reason.
/// Everything here throws a file error (exit code 4); HDF5 itself prints nothing.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "supple/core/new_file.hpp"

namespace supple::h5 {

/// Lengths of an array, outermost first.
using Shape = std::vector<std::uint64_t>;

/// An open file, group or dataset; closed when it goes. Attributes hang on any of them.
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

/// A group. Element types T: double, std::int32_t, std::int64_t, std::uint8_t, std::string (UTF-8; written
/// with a fixed length, which every reader knows; read with any). What is read is checked first: no array
/// larger than its file can hold, no text that is not UTF-8.
class Group : public Object {
 public:
  using Object::Object;

  bool has(const std::string& name) const;
  /// Whether the member is a group; otherwise it is a dataset.
  bool is_group(const std::string& name) const;
  /// Names of members in the order of their creation.
  std::vector<std::string> names() const;
  Group create_group(const std::string& name);
  Group open_group(const std::string& name) const;
  Object open_dataset(const std::string& name) const;
  void remove(const std::string& name);
  /// Copies the member of `from` with everything below it.
  void copy(const Group& from, const std::string& name);
  /// Copies all attributes of `from`.
  void copy_attributes(const Object& from);

  /// An array; an empty shape stands for one dimension with all values. What is small stands compact in the
  /// header of the dataset, the rest in compressed pieces with a checksum each.
  template <class T>
  Object write(const std::string& name, std::span<const T> values, const Shape& shape = {});
  template <class T>
  Object write(const std::string& name, const std::vector<T>& values, const Shape& shape = {}) {
    return write(name, std::span<const T>(values), shape);
  }
  /// One number or text.
  template <class T>
  Object write_scalar(const std::string& name, const T& value);

  /// Creates `name` like that array of numbers in `from`, its attributes too, for `rows` rows, to be filled
  /// by write_rows_of.
  Object create_like(const Group& from, const std::string& name, std::uint64_t rows);
  /// Writes all rows of that array in `from`, whatever their type, from row `first` on.
  void write_rows_of(const Group& from, const std::string& name, std::uint64_t first);

  Shape shape(const std::string& name) const;
  /// All values, row after row. The type is converted where the file holds another number type.
  template <class T>
  std::vector<T> read(const std::string& name) const;
  template <class T>
  T read_scalar(const std::string& name) const;
  /// Rows [first, first + count) of the first dimension.
  template <class T>
  std::vector<T> read_rows(const std::string& name, std::uint64_t first, std::uint64_t count) const;
};

/// The root group of a new file in memory, `name` for errors: HDF5 itself does not survive a disk that is
/// full. The file goes with its last open object.
Group create_file(const std::string& name);
/// Writes the whole file that `root` belongs to, complete or not at all.
void save(Group& root, const std::string& path, Existing existing = Existing::refuse);
/// The root group of a file, read only. The error tells a missing, unreadable, foreign and truncated file
/// apart.
Group open_file(const std::string& path);

}  // namespace supple::h5
