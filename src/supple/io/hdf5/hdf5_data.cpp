/// Datasets: whole arrays, and arrays that are put together from the rows of others.
#include <zlib.h>

#include <algorithm>

#include "supple/io/hdf5/hdf5_calls.hpp"

namespace supple::h5 {
namespace {

std::uint64_t product(const Shape& shape, std::size_t from = 0) {
  std::uint64_t n = 1;
  for (std::size_t d = from; d < shape.size(); ++d) n *= shape[d];
  return n;
}

/// An array of at most this many bytes is kept in the header of its dataset, which has a checksum.
constexpr std::uint64_t compact_bytes = 2048;
/// A scalar cannot be in pieces: it is in the header, which takes at most this many bytes.
constexpr std::uint64_t header_bytes = 60000;
/// Bytes of a piece, about: little enough to read a piece for a single frame.
constexpr std::uint64_t piece_bytes = 32768;
constexpr int deflate_level = 1;

/// Bytes of an array that tell whether it is worth compressing, about.
constexpr std::uint64_t sample_bytes = 8192;
/// Whether these values become smaller by a tenth, byte after byte as HDF5 shuffles them.
bool become_smaller(const char* values, std::size_t count, std::size_t value_bytes) {
  std::vector<Bytef> shuffled(count * value_bytes);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t b = 0; b < value_bytes; ++b)
      shuffled[b * count + k] = static_cast<Bytef>(values[k * value_bytes + b]);
  uLongf size = compressBound(static_cast<uLong>(shuffled.size()));
  std::vector<Bytef> compressed(size);
  return compress2(compressed.data(), &size, shuffled.data(), static_cast<uLong>(shuffled.size()),
                   deflate_level) == Z_OK &&
         static_cast<double>(size) < 0.9 * static_cast<double>(shuffled.size());
}

/// How to keep an array of so many bytes that may be compressed.
template <class IsWorthIt>
Storage storage_for(std::uint64_t bytes, Storage allowed, const IsWorthIt& is_worth_it) {
  if (allowed == Storage::plain || bytes <= compact_bytes) return allowed;
  return is_worth_it() ? Storage::compressed : Storage::plain;
}

/// How an array of this shape is kept. An empty one may grow: programs that copy files fail on a layout
/// without pieces.
Object layout_of(const Shape& shape, std::uint64_t value_bytes, Storage storage) {
  Object list(H5Pcreate(H5P_DATASET_CREATE));
  const std::uint64_t bytes = product(shape) * value_bytes;
  if (bytes > 0 && bytes <= compact_bytes) {
    H5Pset_layout(list.id(), H5D_COMPACT);
    return list;
  }
  Shape piece = shape;
  for (std::uint64_t& length : piece) length = std::max<std::uint64_t>(1, length);
  const std::uint64_t row = std::max<std::uint64_t>(1, product(piece, 1) * value_bytes);
  piece[0] = std::clamp<std::uint64_t>(piece_bytes / row, 1, piece[0]);
  // A row of more than 64 MiB is cut, as pieces must stay below 4 GiB.
  for (std::size_t d = 1; d < piece.size(); ++d)
    while (product(piece, d) * value_bytes > std::uint64_t{1} << 26 && piece[d] > 1)
      piece[d] = (piece[d] + 1) / 2;
  H5Pset_chunk(list.id(), static_cast<int>(piece.size()), reinterpret_cast<const hsize_t*>(piece.data()));
  if (storage == Storage::compressed) {
    H5Pset_shuffle(list.id());
    H5Pset_deflate(list.id(), deflate_level);
  }
  H5Pset_fletcher32(list.id());
  return list;
}

Object create_dataset(hid_t group, const std::string& name, hid_t type, const Shape& shape, Storage storage,
                      const std::string& where) {
  Shape limit = shape;
  for (std::uint64_t& length : limit) length = length ? length : H5S_UNLIMITED;
  const Object space(H5Screate_simple(static_cast<int>(shape.size()),
                                      reinterpret_cast<const hsize_t*>(shape.data()),
                                      reinterpret_cast<const hsize_t*>(limit.data())));
  const Object list = layout_of(shape, H5Tget_size(type), storage);
  return own(H5Dcreate2(group, name.c_str(), type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
             "create " + name + " in", where);
}

/// Selects rows [first, first + count) of a space.
void select_rows(hid_t space, Shape shape, std::uint64_t first, std::uint64_t count) {
  Shape start(shape.size(), 0);
  start[0] = first;
  shape[0] = count;
  H5Sselect_hyperslab(space, H5S_SELECT_SET, reinterpret_cast<const hsize_t*>(start.data()), nullptr,
                      reinterpret_cast<const hsize_t*>(shape.data()), nullptr);
}

}  // namespace

template <class T>
Object Group::write(const std::string& name, std::span<const T> values, const Shape& shape) {
  const Quiet quiet;
  const Buffer<T> buffer(values);
  const std::size_t size = H5Tget_size(buffer.type.id());
  const auto is_worth_it = [&] {
    const std::size_t count = std::min<std::size_t>(values.size(), 1 + sample_bytes / size);
    return become_smaller(static_cast<const char*>(buffer.data) + (values.size() - count) / 2 * size, count,
                          size);
  };
  Object dataset = create_dataset(id(), name, buffer.type.id(), shape.empty() ? Shape{values.size()} : shape,
                                  storage_for(values.size() * size, storage_, is_worth_it), where());
  if (!values.empty())
    checked(H5Dwrite(dataset.id(), buffer.type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data), "write",
            dataset);
  return dataset;
}

template <class T>
Object Group::write_scalar(const std::string& name, const T& value) {
  const Quiet quiet;
  const Buffer<T> buffer(std::span<const T>(&value, 1));
  const Object list(H5Pcreate(H5P_DATASET_CREATE));
  if (H5Tget_size(buffer.type.id()) <= header_bytes) H5Pset_layout(list.id(), H5D_COMPACT);
  const Object space = space_of({});
  Object dataset =
      own(H5Dcreate2(id(), name.c_str(), buffer.type.id(), space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
          "create " + name + " in", *this);
  checked(H5Dwrite(dataset.id(), buffer.type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data), "write",
          dataset);
  return dataset;
}

Object Group::create_like(const Group& from, const std::string& name, std::uint64_t rows) {
  const Quiet quiet;
  const Object source = from.open_dataset(name);
  const Object type(H5Dget_type(source.id()));
  Shape shape = from.shape(name);
  const std::uint64_t size = H5Tget_size(type.id()), row = product(shape, 1) * size;
  const auto is_worth_it = [&, there = shape] {
    if (H5Tis_variable_str(type.id()) > 0) return true;
    Shape some = there;
    some[0] = std::min(there[0], 1 + sample_bytes / std::max<std::uint64_t>(1, row));
    std::vector<char> sample(some[0] * row);
    const Object space(H5Dget_space(source.id())), memory_space = space_of(some);
    select_rows(space.id(), there, (there[0] - some[0]) / 2, some[0]);
    checked(H5Dread(source.id(), type.id(), memory_space.id(), space.id(), H5P_DEFAULT, sample.data()),
            "read", source);
    return become_smaller(sample.data(), sample.size() / size, size);
  };
  const Storage storage = storage_for(product(shape) * size, storage_, is_worth_it);
  shape.at(0) = rows;
  Object made = create_dataset(id(), name, type.id(), shape, storage, where());
  copy_all_attributes(source.id(), made.id(), source.where());
  return made;
}

void Group::copy_rows(const std::string& name, const Object& to, std::uint64_t first) const {
  const Quiet quiet;
  const Object source = open_dataset(name), file_space(H5Dget_space(to.id()));
  const Object type(H5Dget_type(source.id()));
  const Shape rows = shape(name), all = h5::shape_of(file_space.id(), to.where());
  const std::size_t count = believable_count(source, type.id(), rows, source.where());
  if (count == 0) return;
  if (rows.size() != all.size() || !std::equal(rows.begin() + 1, rows.end(), all.begin() + 1) ||
      first > all[0] || rows[0] > all[0] - first)
    throw file_error("cannot write " + to.where(), source.where() + " has another shape");
  std::vector<char> bytes(count * H5Tget_size(type.id()));
  checked(H5Dread(source.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), "read", source);
  const Object memory_space = space_of(rows);
  select_rows(file_space.id(), all, first, rows[0]);
  checked(H5Dwrite(to.id(), type.id(), memory_space.id(), file_space.id(), H5P_DEFAULT, bytes.data()),
          "write", to);
}

Shape Group::shape(const std::string& name) const {
  const Quiet quiet;
  const Object dataset = open_dataset(name);
  const Object space(H5Dget_space(dataset.id()));
  return shape_of(space.id(), dataset.where());
}

template <class T>
std::vector<T> Group::read(const std::string& name) const {
  const Quiet quiet;
  const Object dataset = open_dataset(name);
  const Object type(H5Dget_type(dataset.id())), space(H5Dget_space(dataset.id()));
  const std::string where = dataset.where();
  return read_values<T>(dataset, type, shape_of(space.id(), where), where, [&](hid_t memory_type, void* out) {
    checked(H5Dread(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out), "read", where);
  });
}

template <class T>
T Group::read_scalar(const std::string& name) const {
  const Quiet quiet;
  std::vector<T> values = read<T>(name);
  if (values.size() != 1)
    throw file_error("cannot read " + name + " in " + where(), "it is not a single value");
  return std::move(values[0]);
}

template <class T>
std::vector<T> Group::read_rows(const std::string& name, std::uint64_t first, std::uint64_t count) const {
  const Quiet quiet;
  const Object dataset = open_dataset(name);
  const Object type(H5Dget_type(dataset.id())), file_space(H5Dget_space(dataset.id()));
  const std::string where = dataset.where();
  Shape rows = shape_of(file_space.id(), where);
  if (rows.empty() || first > rows[0] || count > rows[0] - first)
    throw file_error("cannot read " + where, "rows are missing");
  rows[0] = count;
  select_rows(file_space.id(), rows, first, count);
  const Object memory_space = space_of(rows);
  return read_values<T>(dataset, type, rows, where, [&](hid_t memory_type, void* out) {
    checked(H5Dread(dataset.id(), memory_type, memory_space.id(), file_space.id(), H5P_DEFAULT, out), "read",
            where);
  });
}

template Object Group::write(const std::string&, std::span<const double>, const Shape&);
template Object Group::write(const std::string&, std::span<const std::int32_t>, const Shape&);
template Object Group::write(const std::string&, std::span<const std::int64_t>, const Shape&);
template Object Group::write(const std::string&, std::span<const std::uint8_t>, const Shape&);
template Object Group::write(const std::string&, std::span<const std::string>, const Shape&);
template Object Group::write_scalar(const std::string&, const double&);
template Object Group::write_scalar(const std::string&, const std::int64_t&);
template Object Group::write_scalar(const std::string&, const std::string&);

#define SUPPLE_H5_ELEMENT(T)                                     \
  template std::vector<T> Group::read(const std::string&) const; \
  template T Group::read_scalar(const std::string&) const;       \
  template std::vector<T> Group::read_rows(const std::string&, std::uint64_t, std::uint64_t) const;
SUPPLE_H5_ELEMENT(double)
SUPPLE_H5_ELEMENT(std::int32_t)
SUPPLE_H5_ELEMENT(std::int64_t)
SUPPLE_H5_ELEMENT(std::uint8_t)
SUPPLE_H5_ELEMENT(std::string)
#undef SUPPLE_H5_ELEMENT

}  // namespace supple::h5
