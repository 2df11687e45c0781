/// Values on their way between memory and HDF5: texts of fixed length, sizes that a file can hold.
#include <algorithm>
#include <optional>

#include "supple/core/utf8.hpp"
#include "supple/io/hdf5/hdf5_calls.hpp"

namespace supple::h5 {
namespace {

/// UTF-8 only where a text needs it: Octave 7.3 reads nothing behind a text that says so.
Object text_type(std::size_t length, std::span<const std::string> values) {
  const bool ascii = std::all_of(values.begin(), values.end(), [](const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
  });
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, length);
  H5Tset_cset(text, ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
  return Object(text);
}

std::string checked_text(std::string text, const std::string& where) {
  if (!is_utf8(text))
    throw file_error("cannot read a text of " + where, "it is not UTF-8", "the file is damaged");
  return text;
}

/// Texts of any length, as older files hold them.
std::vector<std::string> read_variable_texts(hid_t type, std::size_t count, const std::string& where,
                                             const ReadTexts& read) {
  std::vector<char*> pointers(count);
  if (count) read(type, pointers.data());
  std::vector<std::string> out;
  for (const char* text : pointers) out.emplace_back(text ? text : "");
  const Object space = space_of({count});
  H5Dvlen_reclaim(type, space.id(), H5P_DEFAULT, pointers.data());
  for (std::string& text : out) text = checked_text(std::move(text), where);
  return out;
}

/// The number of values, where this file can hold so many: deflate packs at most 1032 bytes into one.
std::optional<std::size_t> count_within(const Object& file, hid_t type, const Shape& shape) {
  hsize_t file_size = 0;
  H5Fget_filesize(file.id(), &file_size);
  const std::uint64_t most = 1032 * file_size / std::max<std::uint64_t>(1, H5Tget_size(type));
  std::uint64_t count = 1;
  for (const std::uint64_t length : shape) {
    if (length != 0 && count > most / length) return std::nullopt;
    count *= length;
  }
  return static_cast<std::size_t>(count);
}

}  // namespace

Shape shape_of(hid_t space, const std::string& where) {
  const int rank = checked(H5Sget_simple_extent_ndims(space), "read the shape of", where);
  Shape shape(static_cast<std::size_t>(rank));
  checked(H5Sget_simple_extent_dims(space, reinterpret_cast<hsize_t*>(shape.data()), nullptr),
          "read the shape of", where);
  return shape;
}

Buffer<std::string>::Buffer(std::span<const std::string> values) {
  std::size_t length = 1;  // and a zero behind the longest, which some readers need
  for (const std::string& text : values) length = std::max(length, text.size() + 1);
  type = text_type(length, values);
  lines.assign(length * values.size(), '\0');
  for (std::size_t k = 0; k < values.size(); ++k)
    std::copy(values[k].begin(), values[k].end(), lines.begin() + static_cast<std::ptrdiff_t>(length * k));
  data = lines.data();
}

std::size_t believable_count(const Object& object, hid_t type, const Shape& shape, const std::string& where) {
  const Object file(checked(H5Iget_file_id(object.id()), "read", where));
  if (const auto count = count_within(file, type, shape)) return *count;
  H5Fflush(file.id(), H5F_SCOPE_LOCAL);  // a file that is being written may not have its size yet
  if (const auto count = count_within(file, type, shape)) return *count;
  throw file_error("cannot read " + where, "it says that it is larger than the file", "the file is damaged");
}

std::vector<std::string> read_texts(hid_t file_type, std::size_t count, const std::string& where,
                                    const ReadTexts& read) {
  if (H5Tget_class(file_type) != H5T_STRING) throw file_error("cannot read " + where, "it is not a text");
  if (H5Tis_variable_str(file_type) > 0) return read_variable_texts(file_type, count, where, read);
  const std::size_t length = H5Tget_size(file_type);
  const Object type(H5Tcopy(file_type));
  std::vector<char> lines(length * count);
  if (count) read(type.id(), lines.data());
  std::vector<std::string> out;
  for (std::size_t k = 0; k < count; ++k) {
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(length * k);
    const auto end = begin + static_cast<std::ptrdiff_t>(length);
    out.push_back(checked_text(std::string(begin, std::find(begin, end, '\0')), where));
  }
  return out;
}

void copy_all_attributes(hid_t from, hid_t to, const std::string& where) {
  const auto copy = [](hid_t object, const char* name, const H5A_info_t*, void* target) -> herr_t {
    const Object source(H5Aopen(object, name, H5P_DEFAULT));
    const Object type(H5Aget_type(source.id())), space(H5Aget_space(source.id()));
    std::vector<char> bytes(std::max<hsize_t>(1, H5Aget_storage_size(source.id())));
    if (H5Aread(source.id(), type.id(), bytes.data()) < 0) return -1;
    const Object made(H5Acreate2(*static_cast<const hid_t*>(target), name, type.id(), space.id(), H5P_DEFAULT,
                                 H5P_DEFAULT));
    return made.id() < 0 ? -1 : H5Awrite(made.id(), type.id(), bytes.data());
  };
  // In the order of the file: for any other HDF5 gathers them first, which it does not survive where one of
  // many cannot be read.
  checked(H5Aiterate2(from, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, copy, &to), "copy the attributes of",
          where);
}

}  // namespace supple::h5
