/// What the files of the HDF5 wrapper share; the only header that includes HDF5's own.
#pragma once
#include <hdf5.h>

#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/io/hdf5.hpp"

namespace supple::h5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// The most specific message of HDF5's error stack.
std::string reason();

/// Passes a good result through; a negative one becomes an error: "cannot <action> <where>".
template <class Result>
Result checked(Result result, const std::string& action, const std::string& where) {
  if (result < 0) throw file_error("cannot " + action + " " + where, reason());
  return result;
}

/// Any id that only lives within a function (space, type, property list, attribute).
inline Object own(hid_t id, const std::string& action, const std::string& where) {
  return Object(checked(id, action, where));
}

template <class T>
Object type_of() {
  if constexpr (std::is_same_v<T, double>) return Object(H5Tcopy(H5T_NATIVE_DOUBLE));
  else if constexpr (std::is_same_v<T, std::int32_t>) return Object(H5Tcopy(H5T_NATIVE_INT32));
  else if constexpr (std::is_same_v<T, std::int64_t>) return Object(H5Tcopy(H5T_NATIVE_INT64));
  else if constexpr (std::is_same_v<T, std::uint8_t>) return Object(H5Tcopy(H5T_NATIVE_UINT8));
  else {
    static_assert(std::is_same_v<T, std::string>);
    const hid_t text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, H5T_VARIABLE);
    H5Tset_cset(text, H5T_CSET_UTF8);
    return Object(text);
  }
}

inline Object space_of(const Shape& shape) {
  return Object(shape.empty() ? H5Screate(H5S_SCALAR)
                              : H5Screate_simple(static_cast<int>(shape.size()),
                                                 reinterpret_cast<const hsize_t*>(shape.data()), nullptr));
}

inline Shape shape_of(hid_t space) {
  Shape shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, reinterpret_cast<hsize_t*>(shape.data()), nullptr);
  return shape;
}

/// Texts are handed to HDF5 as pointers; other values as they are.
template <class T>
struct Buffer {
  explicit Buffer(std::span<const T> values) : data(values.data()) {}
  const void* data;
};
template <>
struct Buffer<std::string> {
  explicit Buffer(std::span<const std::string> values) {
    for (const std::string& text : values) pointers.push_back(text.c_str());
    data = pointers.data();
  }
  std::vector<const char*> pointers;
  const void* data;
};

/// Texts from pointers that HDF5 allocated, which go back to it.
inline std::vector<std::string> take_texts(std::vector<char*>& pointers, hid_t type, hid_t space) {
  std::vector<std::string> out;
  for (const char* text : pointers) out.emplace_back(text ? text : "");
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
  return out;
}

template <class T>
void set_attribute(hid_t object, const std::string& name, std::span<const T> values, const Shape& shape,
                   const std::string& where) {
  if (H5Aexists(object, name.c_str()) > 0) H5Adelete(object, name.c_str());
  const Object type = type_of<T>();
  const Object space = space_of(shape);
  const Object attribute = own(H5Acreate2(object, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
                               "create attribute " + name + " of", where);
  const Buffer<T> buffer(values);
  if (!values.empty())
    checked(H5Awrite(attribute.id(), type.id(), buffer.data), "write attribute " + name + " of", where);
}

template <class T>
std::vector<T> get_attribute(hid_t object, const std::string& name, const std::string& where) {
  const Object attribute = own(H5Aopen(object, name.c_str(), H5P_DEFAULT), "read attribute " + name + " of", where);
  const Object type = type_of<T>();
  const Object space(H5Aget_space(attribute.id()));
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id()));
  const auto read = [&](void* out) {
    if (count) checked(H5Aread(attribute.id(), type.id(), out), "read attribute " + name + " of", where);
  };
  if constexpr (std::is_same_v<T, std::string>) {
    std::vector<char*> pointers(count);
    read(pointers.data());
    return take_texts(pointers, type.id(), space.id());
  } else {
    std::vector<T> out(count);
    read(out.data());
    return out;
  }
}

}  // namespace supple::h5
