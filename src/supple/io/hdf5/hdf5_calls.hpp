/// What the files of the HDF5 wrapper share; the only header that includes HDF5's own.
#pragma once
#include <hdf5.h>

#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/io/hdf5/hdf5.hpp"

namespace supple::h5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// While this lives HDF5 prints nothing: every function of the wrapper begins with one. What prints is a
/// setting of each thread, and the program around Supple may have made its own.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
  bool known_;
};

/// The file error after a call of HDF5 that failed: "cannot <action> <where>", why, what to do, and at the
/// end in brackets the most specific message of HDF5. Of an object, it asks for its name when it knows the
/// message, which each call of HDF5 forgets.
Error fault(const std::string& action, const std::string& where);
Error fault(const std::string& action, const Object& at);

/// Returns a good result; throws fault() for a negative one. `at` is an object, or a text that was made
/// before the call whose result this is: compilers differ in which argument comes first.
template <class Result, class At>
Result checked(Result result, const std::string& action, const At& at) {
  if (result < 0) throw fault(action, at);
  return result;
}

/// Owns an id (of a space, type, property list or attribute); throws fault() where it is negative.
template <class At>
Object own(hid_t id, const std::string& action, const At& at) {
  return Object(checked(id, action, at));
}

/// The HDF5 type of numbers T in memory.
template <class T>
Object type_of() {
  if constexpr (std::is_same_v<T, double>) return Object(H5Tcopy(H5T_NATIVE_DOUBLE));
  else if constexpr (std::is_same_v<T, std::int32_t>) return Object(H5Tcopy(H5T_NATIVE_INT32));
  else if constexpr (std::is_same_v<T, std::int64_t>) return Object(H5Tcopy(H5T_NATIVE_INT64));
  else {
    static_assert(std::is_same_v<T, std::uint8_t>);
    return Object(H5Tcopy(H5T_NATIVE_UINT8));
  }
}

inline Object space_of(const Shape& shape) {
  return Object(shape.empty() ? H5Screate(H5S_SCALAR)
                              : H5Screate_simple(static_cast<int>(shape.size()),
                                                 reinterpret_cast<const hsize_t*>(shape.data()), nullptr));
}

Shape shape_of(hid_t space, const std::string& where);

/// Values as HDF5 takes them: their type and address. Texts become pieces of equal length, filled up with
/// zeros.
template <class T>
struct Buffer {
  explicit Buffer(std::span<const T> values) : type(type_of<T>()), data(values.data()) {}
  Object type;
  const void* data;
};
template <>
struct Buffer<std::string> {
  explicit Buffer(std::span<const std::string> values);
  Object type;
  std::vector<char> lines;
  const void* data;
};

/// Number of values of this shape. Throws a file error where the file of `object` cannot hold that many of
/// this type.
std::size_t believable_count(const Object& object, hid_t type, const Shape& shape, const std::string& where);
/// Reads `count` texts, of the type `file_type` of a file, by `read`.
using ReadTexts = std::function<void(hid_t type, void* to)>;
std::vector<std::string> read_texts(hid_t file_type, std::size_t count, const std::string& where,
                                    const ReadTexts& read);

/// Reads the values of `object`, of this shape and type in the file, by read(type in memory, address).
template <class T, class Read>
std::vector<T> read_values(const Object& object, const Object& file_type, const Shape& shape,
                           const std::string& where, Read&& read) {
  const std::size_t count = believable_count(object, file_type.id(), shape, where);
  if constexpr (std::is_same_v<T, std::string>) {
    return read_texts(file_type.id(), count, where, read);
  } else {
    std::vector<T> out(count);
    const Object type = type_of<T>();
    if (count) read(type.id(), out.data());
    return out;
  }
}

template <class T>
void set_attribute(hid_t object, const std::string& name, std::span<const T> values, const Shape& shape,
                   const std::string& where) {
  const Quiet quiet;
  if (H5Aexists(object, name.c_str()) > 0) H5Adelete(object, name.c_str());
  const Buffer<T> buffer(values);
  const Object space = space_of(shape);
  const Object attribute =
      own(H5Acreate2(object, name.c_str(), buffer.type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
          "create attribute " + name + " of", where);
  if (!values.empty())
    checked(H5Awrite(attribute.id(), buffer.type.id(), buffer.data), "write attribute " + name + " of",
            where);
}

template <class T>
std::vector<T> get_attribute(hid_t object, const std::string& name, const std::string& where) {
  const Quiet quiet;
  const std::string what = "read attribute " + name + " of";
  const Object attribute = own(H5Aopen(object, name.c_str(), H5P_DEFAULT), what, where);
  const Object type = own(H5Aget_type(attribute.id()), what, where);
  const Object space = own(H5Aget_space(attribute.id()), what, where);
  return read_values<T>(
      attribute, type, shape_of(space.id(), where), where,
      [&](hid_t memory_type, void* out) { checked(H5Aread(attribute.id(), memory_type, out), what, where); });
}

/// Copies every attribute, whatever its type.
void copy_all_attributes(hid_t from, hid_t to, const std::string& where);

}  // namespace supple::h5
