/// The HDF5 C library, owned: ids that close themselves, and errors that say file, object and reason.
/// Everything here throws a file error (exit code 4); HDF5 itself prints nothing.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace supple::h5 {

/// Lengths of an array, outermost first.
using Shape = std::vector<std::uint64_t>;

/// An open file, group or dataset; closed when it goes. Attributes hang on any of them.
class Object {
 public:
  Object() = default;
  explicit Object(std::int64_t id) : id_(id) {}
  Object(Object&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Object& operator=(Object&& other) noexcept { std::swap(id_, other.id_); return *this; }
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

/// A group. Element types T: double, std::int32_t, std::int64_t, std::uint8_t, std::string (UTF-8, any length).
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
  /// Writes what HDF5 still holds in memory: the place where a full disk shows.
  void flush();
  void remove(const std::string& name);
  /// Copies the member of `from` with everything below it.
  void copy(const Group& from, const std::string& name);

  /// An array of fixed size; an empty shape stands for one dimension with all values.
  template <class T>
  Object write(const std::string& name, std::span<const T> values, const Shape& shape = {});
  template <class T>
  Object write(const std::string& name, const std::vector<T>& values, const Shape& shape = {}) {
    return write(name, std::span<const T>(values), shape);
  }
  /// One number or text.
  template <class T>
  Object write_scalar(const std::string& name, const T& value);

  /// An array that grows along its first dimension; `row` holds the other lengths.
  template <class T>
  Object create_rows(const std::string& name, const Shape& row = {});
  template <class T>
  void append_rows(const std::string& name, std::span<const T> values);
  template <class T>
  void append_rows(const std::string& name, const std::vector<T>& values) {
    append_rows(name, std::span<const T>(values));
  }
  /// Creates `name` like the growing dataset of that name in `from`, its text attributes too, with no rows.
  void create_rows_like(const Group& from, const std::string& name);
  /// Appends all rows of `from`, whatever their type.
  void append_rows_of(const Group& from, const std::string& name);

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

/// The root group of a new file; the file closes with its last open object. A file of that name goes.
Group create_file(const std::string& path);
/// The root group of a file, read only. The error tells a missing, unreadable, foreign and truncated file apart.
Group open_file(const std::string& path);

}  // namespace supple::h5
