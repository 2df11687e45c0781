/// Datasets: whole arrays, and arrays that grow by rows.
#include "supple/io/hdf5_calls.hpp"

namespace supple::h5 {
namespace {

std::uint64_t product(const Shape& shape, std::size_t from = 0) {
  std::uint64_t n = 1;
  for (std::size_t d = from; d < shape.size(); ++d) n *= shape[d];
  return n;
}

/// Rows a chunk holds: about 64 KiB, so that a table of few columns and a trajectory both read fast.
std::uint64_t rows_per_chunk(std::uint64_t row_bytes) {
  const std::uint64_t rows = 65536 / (row_bytes ? row_bytes : 1);
  return rows < 1 ? 1 : rows;
}

/// Reads the rows selected by `file_space` (all where it is H5S_ALL) into `count` values.
template <class T>
std::vector<T> read_selection(const Object& dataset, hid_t memory_space, hid_t file_space, std::uint64_t count) {
  const Object type = type_of<T>();
  const auto read = [&](void* out) {
    if (count)
      checked(H5Dread(dataset.id(), type.id(), memory_space, file_space, H5P_DEFAULT, out), "read", dataset.where());
  };
  if constexpr (std::is_same_v<T, std::string>) {
    std::vector<char*> pointers(count);
    read(pointers.data());
    const Object space = space_of({count});
    return take_texts(pointers, type.id(), space.id());
  } else {
    std::vector<T> out(count);
    read(out.data());
    return out;
  }
}

/// Makes room for `rows` more rows of a dataset and writes them there; `values` has the memory type `type`.
void extend(const Object& dataset, hid_t type, std::uint64_t rows, const void* values) {
  if (rows == 0) return;
  Shape shape;
  { const Object space(H5Dget_space(dataset.id())); shape = shape_of(space.id()); }
  Shape start(shape.size(), 0), count = shape;
  start[0] = shape[0];
  count[0] = rows;
  shape[0] += rows;
  checked(H5Dset_extent(dataset.id(), reinterpret_cast<const hsize_t*>(shape.data())), "extend", dataset.where());
  const Object file_space(H5Dget_space(dataset.id()));
  H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, reinterpret_cast<const hsize_t*>(start.data()), nullptr,
                      reinterpret_cast<const hsize_t*>(count.data()), nullptr);
  const Object memory_space = space_of(count);
  checked(H5Dwrite(dataset.id(), type, memory_space.id(), file_space.id(), H5P_DEFAULT, values), "write",
          dataset.where());
}

Object create_growing(hid_t group, const std::string& name, hid_t type, const Shape& row, const std::string& where) {
  Shape shape{0}, chunk, limit{H5S_UNLIMITED};
  shape.insert(shape.end(), row.begin(), row.end());
  limit.insert(limit.end(), row.begin(), row.end());
  chunk = shape;
  chunk[0] = rows_per_chunk(product(row) * H5Tget_size(type));
  for (std::uint64_t& length : chunk) length = length ? length : 1;
  const Object space(H5Screate_simple(static_cast<int>(shape.size()), reinterpret_cast<const hsize_t*>(shape.data()),
                                      reinterpret_cast<const hsize_t*>(limit.data())));
  const Object list(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_chunk(list.id(), static_cast<int>(chunk.size()), reinterpret_cast<const hsize_t*>(chunk.data()));
  H5Pset_attr_creation_order(list.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  return own(H5Dcreate2(group, name.c_str(), type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
             "create " + name + " in", where);
}

}  // namespace

template <class T>
Object Group::write(const std::string& name, std::span<const T> values, const Shape& shape) {
  const Shape lengths = shape.empty() ? Shape{values.size()} : shape;
  const Object type = type_of<T>();
  const Object space = space_of(lengths);
  Object dataset = own(H5Dcreate2(id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                       "create " + name + " in", where());
  const Buffer<T> buffer(values);
  if (!values.empty())
    checked(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data), "write", dataset.where());
  return dataset;
}

template <class T>
Object Group::write_scalar(const std::string& name, const T& value) {
  const Object type = type_of<T>();
  const Object space = space_of({});
  Object dataset = own(H5Dcreate2(id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                       "create " + name + " in", where());
  const Buffer<T> buffer(std::span<const T>(&value, 1));
  checked(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data), "write", dataset.where());
  return dataset;
}

template <class T>
Object Group::create_rows(const std::string& name, const Shape& row) {
  const Object type = type_of<T>();
  return create_growing(id(), name, type.id(), row, where());
}

template <class T>
void Group::append_rows(const std::string& name, std::span<const T> values) {
  const Object dataset = open_dataset(name);
  const Object type = type_of<T>();
  const Buffer<T> buffer(values);
  const std::uint64_t row = product(shape(name), 1);
  extend(dataset, type.id(), row ? values.size() / row : 0, buffer.data);
}

void Group::create_rows_like(const Group& from, const std::string& name) {
  const Object source = from.open_dataset(name);
  const Object type(H5Dget_type(source.id()));
  Shape row = from.shape(name);
  row.erase(row.begin());
  const Object made = create_growing(id(), name, type.id(), row, where());
  hid_t made_id = made.id();
  const auto copy_attribute = [](hid_t object, const char* attribute, const H5A_info_t*, void* to) -> herr_t {
    set_attribute<std::string>(*static_cast<const hid_t*>(to), attribute,
                               get_attribute<std::string>(object, attribute, "a dataset"), {}, "a dataset");
    return 0;
  };
  checked(H5Aiterate2(source.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, copy_attribute, &made_id),
          "read the attributes of", source.where());
}

void Group::append_rows_of(const Group& from, const std::string& name) {
  const Object source = from.open_dataset(name);
  const Object type(H5Dget_type(source.id()));
  const Shape size = from.shape(name);
  if (product(size) == 0) return;
  std::vector<char> bytes(product(size) * H5Tget_size(type.id()));
  checked(H5Dread(source.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), "read", source.where());
  extend(open_dataset(name), type.id(), size[0], bytes.data());
  const Object space = space_of(size);
  if (H5Tis_variable_str(type.id()) > 0) H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, bytes.data());
}

Shape Group::shape(const std::string& name) const {
  const Object dataset = open_dataset(name);
  const Object space(H5Dget_space(dataset.id()));
  return shape_of(space.id());
}

template <class T>
std::vector<T> Group::read(const std::string& name) const {
  const Object dataset = open_dataset(name);
  const Object space(H5Dget_space(dataset.id()));
  return read_selection<T>(dataset, H5S_ALL, H5S_ALL,
                           static_cast<std::uint64_t>(H5Sget_simple_extent_npoints(space.id())));
}

template <class T>
T Group::read_scalar(const std::string& name) const {
  std::vector<T> values = read<T>(name);
  if (values.size() != 1) throw file_error("cannot read " + name + " in " + where(), "it is not a single value");
  return std::move(values[0]);
}

template <class T>
std::vector<T> Group::read_rows(const std::string& name, std::uint64_t first, std::uint64_t count) const {
  const Object dataset = open_dataset(name);
  const Object file_space(H5Dget_space(dataset.id()));
  Shape lengths = shape_of(file_space.id());
  if (lengths.empty() || first + count > lengths[0])
    throw file_error("cannot read " + dataset.where(), "rows are missing");
  Shape start(lengths.size(), 0);
  start[0] = first;
  lengths[0] = count;
  H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, reinterpret_cast<const hsize_t*>(start.data()), nullptr,
                      reinterpret_cast<const hsize_t*>(lengths.data()), nullptr);
  const Object memory_space = space_of(lengths);
  return read_selection<T>(dataset, memory_space.id(), file_space.id(), product(lengths));
}

template Object Group::write(const std::string&, std::span<const double>, const Shape&);
template Object Group::write(const std::string&, std::span<const std::int32_t>, const Shape&);
template Object Group::write(const std::string&, std::span<const std::int64_t>, const Shape&);
template Object Group::write(const std::string&, std::span<const std::uint8_t>, const Shape&);
template Object Group::write(const std::string&, std::span<const std::string>, const Shape&);
template Object Group::write_scalar(const std::string&, const double&);
template Object Group::write_scalar(const std::string&, const std::int64_t&);
template Object Group::write_scalar(const std::string&, const std::string&);

#define SUPPLE_H5_ELEMENT(T)                                                   \
  template Object Group::create_rows<T>(const std::string&, const Shape&);     \
  template void Group::append_rows(const std::string&, std::span<const T>);    \
  template std::vector<T> Group::read(const std::string&) const;               \
  template T Group::read_scalar(const std::string&) const;                     \
  template std::vector<T> Group::read_rows(const std::string&, std::uint64_t, std::uint64_t) const;
SUPPLE_H5_ELEMENT(double)
SUPPLE_H5_ELEMENT(std::int32_t)
SUPPLE_H5_ELEMENT(std::int64_t)
SUPPLE_H5_ELEMENT(std::uint8_t)
SUPPLE_H5_ELEMENT(std::string)
#undef SUPPLE_H5_ELEMENT

}  // namespace supple::h5
