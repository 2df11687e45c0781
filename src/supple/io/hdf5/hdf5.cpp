#include "supple/io/hdf5/hdf5.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "supple/core/path_kind.hpp"
#include "supple/io/hdf5/hdf5_calls.hpp"

namespace supple::h5 {
namespace {

template <class T>
T first_of(const std::vector<T>& values, const std::string& name, const std::string& where) {
  if (values.empty()) throw file_error("attribute " + name + " of " + where + " is empty");
  return values[0];
}

/// The members of a group in creation order where the file keeps it, else by name.
H5_index_t order_of(hid_t group) {
  const Object list(H5Gget_create_plist(group));
  unsigned flags = 0;
  return H5Pget_link_creation_order(list.id(), &flags) >= 0 && (flags & H5P_CRT_ORDER_INDEXED)
             ? H5_INDEX_CRT_ORDER
             : H5_INDEX_NAME;
}

std::vector<char> bytes_in(const Object& dataset, hid_t type, const Shape& shape) {
  std::vector<char> bytes(H5Tget_size(type) * believable_count(dataset, type, shape, dataset.where()));
  checked(H5Dread(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), "read", dataset);
  return bytes;
}

/// Of numbers and texts of fixed length.
bool same_values(const Object& a, const Object& b) {
  const Object type(H5Dget_type(a.id())), other_type(H5Dget_type(b.id()));
  const Object space(H5Dget_space(a.id())), other_space(H5Dget_space(b.id()));
  const Shape shape = shape_of(space.id(), a.where());
  if (H5Tequal(type.id(), other_type.id()) <= 0 || shape != shape_of(other_space.id(), b.where()))
    return false;
  return bytes_in(a, type.id(), shape) == bytes_in(b, type.id(), shape);
}

std::string name_of_member(hid_t group, H5_index_t order, hsize_t k, const std::string& where) {
  const auto get = [&](char* to, std::size_t size) {
    return checked(H5Lget_name_by_idx(group, ".", order, H5_ITER_INC, k, to, size, H5P_DEFAULT), "list",
                   where);
  };
  std::string name(static_cast<std::size_t>(get(nullptr, 0)), '\0');
  get(name.data(), name.size() + 1);
  return name;
}

}  // namespace

Object::~Object() {
  if (id_ < 0) return;
  const Quiet quiet;
  H5Idec_ref(id_);
}

std::string Object::where() const {
  const Quiet quiet;
  char file[4096] = "", name[1024] = "";
  H5Fget_name(id_, file, sizeof file);
  H5Iget_name(id_, name, sizeof name);
  return std::string(file) + (std::strcmp(name, "/") == 0 ? "" : std::string(":") + name);
}

bool Object::has_attribute(const std::string& name) const {
  const Quiet quiet;
  return checked(H5Aexists(id_, name.c_str()), "look for attribute " + name + " of", *this) > 0;
}
void Object::set(const std::string& name, double value) {
  set_attribute<double>(id_, name, {&value, 1}, {}, where());
}
void Object::set(const std::string& name, std::int64_t value) {
  set_attribute<std::int64_t>(id_, name, {&value, 1}, {}, where());
}
void Object::set(const std::string& name, const std::string& text) {
  set_attribute<std::string>(id_, name, {&text, 1}, {}, where());
}
void Object::set(const std::string& name, const std::vector<std::string>& texts) {
  set_attribute<std::string>(id_, name, texts, {texts.size()}, where());
}
double Object::number(const std::string& name) const {
  return first_of(get_attribute<double>(id_, name, where()), name, where());
}
std::int64_t Object::integer(const std::string& name) const {
  return first_of(get_attribute<std::int64_t>(id_, name, where()), name, where());
}
std::string Object::text(const std::string& name) const {
  return first_of(get_attribute<std::string>(id_, name, where()), name, where());
}
std::vector<std::string> Object::texts(const std::string& name) const {
  return get_attribute<std::string>(id_, name, where());
}

bool Group::has(const std::string& name) const {
  const Quiet quiet;
  for (auto end = name.find('/');; end = name.find('/', end + 1)) {
    const std::string path = name.substr(0, end);
    if (checked(H5Lexists(id(), path.c_str(), H5P_DEFAULT), "look for " + path + " in", *this) == 0)
      return false;
    if (end == name.npos) return true;
  }
}

bool Group::is_group(const std::string& name) const {
  const Quiet quiet;
  const Object member(checked(H5Oopen(id(), name.c_str(), H5P_DEFAULT), "open " + name + " in", *this));
  return H5Iget_type(member.id()) == H5I_GROUP;
}

std::vector<std::string> Group::names() const {
  const Quiet quiet;
  // One by one: H5Literate 1.10.8 gathers the members first and frees what it never set where one of a large
  // group cannot be read.
  H5G_info_t info{};
  checked(H5Gget_info(id(), &info), "list", *this);
  std::vector<std::string> out;
  for (hsize_t k = 0; k < info.nlinks; ++k) out.push_back(name_of_member(id(), order_of(id()), k, where()));
  return out;
}

Group Group::create_group(const std::string& name) {
  const Quiet quiet;
  const Object list(H5Pcreate(H5P_GROUP_CREATE));
  H5Pset_link_creation_order(list.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  return Group(checked(H5Gcreate2(id(), name.c_str(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
                       "create group " + name + " in", *this),
               storage_);
}

Group Group::open_group(const std::string& name) const {
  const Quiet quiet;
  return Group(checked(H5Gopen2(id(), name.c_str(), H5P_DEFAULT), "open group " + name + " in", *this),
               storage_);
}

Object Group::open_dataset(const std::string& name) const {
  const Quiet quiet;
  return own(H5Dopen2(id(), name.c_str(), H5P_DEFAULT), "open " + name + " in", *this);
}

void Group::remove(const std::string& name) {
  const Quiet quiet;
  checked(H5Ldelete(id(), name.c_str(), H5P_DEFAULT), "remove " + name + " from", *this);
}

void Group::copy(const Group& from, const std::string& name) {
  const Quiet quiet;
  if (from.is_group(name)) {
    const Group source = from.open_group(name);
    Group made = create_group(name);
    made.copy_attributes(source);
    for (const std::string& member : source.names()) made.copy(source, member);
    return;
  }
  const Object list(H5Dget_create_plist(from.open_dataset(name).id()));
  if (H5Pget_layout(list.id()) == H5D_CHUNKED)
    return from.copy_rows(name, create_like(from, name, from.shape(name).at(0)), 0);
  checked(H5Ocopy(from.id(), name.c_str(), id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
          "copy " + name + " to", *this);
}

void Group::copy_or_share(const Group& from, const std::vector<Group>& likes) {
  const Quiet quiet;
  copy_attributes(from);
  for (const std::string& name : from.names()) {
    if (from.is_group(name)) {
      std::vector<Group> within;
      for (const Group& like : likes)
        if (like.has(name) && like.is_group(name)) within.push_back(like.open_group(name));
      create_group(name).copy_or_share(from.open_group(name), within);
      continue;
    }
    const auto same = std::find_if(likes.begin(), likes.end(), [&](const Group& like) {
      return like.has(name) && !like.is_group(name) &&
             same_values(from.open_dataset(name), like.open_dataset(name));
    });
    if (same == likes.end()) copy(from, name);
    else
      checked(H5Lcreate_hard(same->id(), name.c_str(), id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
              "create " + name + " in", *this);
  }
}

void Group::copy_attributes(const Object& from) {
  const Quiet quiet;
  copy_all_attributes(from.id(), id(), from.where());
}

Group create_file(const std::string& name, Storage storage) {
  const Quiet quiet;
  const Object list(H5Pcreate(H5P_FILE_CREATE)), access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_link_creation_order(list.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_istore_k(list.id(), 8);  // small nodes: most arrays have few pieces
  // What version 1.8 and later read: compact headers, with checksums.
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V18);
  H5Pset_fapl_core(access.id(), std::size_t{1} << 20, 0);
  const Object file(checked(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, list.id(), access.id()), "create", name));
  return Group(checked(H5Gopen2(file.id(), "/", H5P_DEFAULT), "open", name), storage);
}

std::string_view bytes_of(const Group& root) {
  const Quiet quiet;
  const Object file(checked(H5Iget_file_id(root.id()), "write", root));
  checked(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "write", root);
  const auto size = checked(H5Fget_file_image(file.id(), nullptr, 0), "write", root);
  void** bytes = nullptr;
  checked(H5Fget_vfd_handle(file.id(), H5P_DEFAULT, reinterpret_cast<void**>(&bytes)), "write", root);
  return {static_cast<const char*>(*bytes), static_cast<std::size_t>(size)};
}

void save(Group& root, const std::string& path, Existing existing) {
  const std::string_view bytes = bytes_of(root);
  NewFile out(path, existing);
  out.write(bytes);
  out.commit();
}

Group open_file(const std::string& path) {
  const Quiet quiet;
  check_can_read(path, "the run");
  if (std::filesystem::file_size(path) == 0 && !path.ends_with(".toml"))
    throw file_error(path + " is empty", "it was copied in part, or the disk was full",
                     "copy it anew from where it was written");
  const htri_t is_hdf5 = H5Fis_hdf5(path.c_str());
  if (is_hdf5 == 0)
    throw file_error(path + " is not an HDF5 file", "runs are",
                     path.ends_with(".toml") ? "supple run " + path + " makes a run of this case" : "");
  const Object file(checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "read", path));
  return Group(checked(H5Gopen2(file.id(), "/", H5P_DEFAULT), "open", path));
}

}  // namespace supple::h5
