/// HDF5 files with one impossible thing in them, made with HDF5's own calls, so that the file is sound as
/// HDF5.
#pragma once
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace supple::testing {

/// Paths of all datasets of a file.
inline std::vector<std::string> datasets_of(const std::string& path) {
  std::vector<std::string> out;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const auto add = [](hid_t, const char* name, const H5O_info_t* info, void* list) -> herr_t {
    if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, add, &out);
  H5Fclose(file);
  return out;
}

/// What is done to a dataset; a change of numbers is of one element, which the seed chooses.
enum class Damage {
  removed,
  shorter,
  longer,
  emptied,
  flattened,
  nested,
  enormous,
  other_type,
  a_group,
  minus_one,
  large,
  largest,
  not_a_number,
  infinite,
  far,
  not_utf8,
  no_attributes
};
constexpr Damage all_damages[] = {
    Damage::removed,  Damage::shorter,      Damage::longer,       Damage::emptied,  Damage::flattened,
    Damage::nested,   Damage::enormous,     Damage::other_type,   Damage::a_group,  Damage::minus_one,
    Damage::large,    Damage::largest,      Damage::not_a_number, Damage::infinite, Damage::far,
    Damage::not_utf8, Damage::no_attributes};

/// One dataset in memory, as a file holds it.
class DamagedDataset {
 public:
  DamagedDataset(hid_t file, const std::string& name) : file_(file), name_(name) {
    const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT), space = H5Dget_space(set);
    type_ = H5Dget_type(set);
    shape_.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, shape_.data(), nullptr);
    values_.resize(count() * H5Tget_size(type_));
    if (!values_.empty()) H5Dread(set, type_, H5S_ALL, H5S_ALL, H5P_DEFAULT, values_.data());
    H5Sclose(space);
    H5Dclose(set);
  }
  ~DamagedDataset() { H5Tclose(type_); }

  /// False where this damage cannot be done to such values.
  bool apply(Damage damage, std::uint64_t seed) {
    switch (damage) {
      case Damage::removed: return H5Ldelete(file_, name_.c_str(), H5P_DEFAULT) >= 0;
      case Damage::a_group:
        H5Ldelete(file_, name_.c_str(), H5P_DEFAULT);
        H5Gclose(H5Gcreate2(file_, name_.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        return true;
      case Damage::shorter: return reshape(-1);
      case Damage::longer: return reshape(1);
      case Damage::emptied: return reshape(shape_.empty() ? 0 : -static_cast<std::int64_t>(shape_[0]));
      case Damage::flattened:
        if (shape_.size() < 2) return false;
        shape_ = {count()};
        return replace();
      case Damage::nested: shape_.push_back(1); return replace();
      case Damage::enormous:
        if (shape_.empty()) return false;
        shape_[0] = std::uint64_t{1} << 40;
        return replace();
      case Damage::other_type: return change_type();
      case Damage::not_utf8:
        if (H5Tget_class(type_) != H5T_STRING || values_.size() < 2) return false;
        values_[0] = '\xff';
        return replace();
      case Damage::no_attributes: return remove_attributes();
      default: return change_number(damage, seed);
    }
  }

 private:
  std::size_t count() const {
    std::size_t n = 1;
    for (const hsize_t length : shape_) n *= length;
    return n;
  }
  bool reshape(std::int64_t more) {
    if (shape_.empty() || more == 0 || (more < 0 && shape_[0] == 0)) return false;
    const std::size_t row = shape_[0] ? values_.size() / shape_[0] : 0;
    shape_[0] += static_cast<hsize_t>(more);
    std::size_t wanted = count() * H5Tget_size(type_);
    if (more > 0 && row == 0) values_.assign(wanted, 0);
    values_.resize(wanted);
    return replace();
  }
  bool change_type() {
    const bool was_text = H5Tget_class(type_) == H5T_STRING;
    const std::size_t values = count();
    H5Tclose(type_);
    type_ = was_text ? H5Tcopy(H5T_NATIVE_INT32) : H5Tcopy(H5T_C_S1);
    values_.assign(values * H5Tget_size(type_), 'x');
    return replace();
  }
  bool change_number(Damage damage, std::uint64_t seed) {
    const std::size_t width = H5Tget_size(type_);
    if (values_.empty()) return false;
    char* at = values_.data() + width * (seed % count());
    if (H5Tget_class(type_) == H5T_FLOAT) {
      const double value = damage == Damage::not_a_number ? std::nan("")
                           : damage == Damage::infinite   ? HUGE_VAL
                           : damage == Damage::far        ? 1e200
                           : damage == Damage::minus_one  ? -1
                                                          : 0;
      if (damage == Damage::large || damage == Damage::largest) return false;
      std::memcpy(at, &value, sizeof value);
      return replace();
    }
    if (H5Tget_class(type_) != H5T_INTEGER) return false;
    if (damage != Damage::minus_one && damage != Damage::large && damage != Damage::largest) return false;
    const std::int64_t value = damage == Damage::minus_one ? -1 : 1000;
    std::memcpy(at, &value, width);
    if (damage == Damage::largest) {
      std::memset(at, 0xff, width);
      if (width > 1) at[width - 1] = 0x7f;
    }
    return replace();
  }
  bool remove_attributes() {
    const hid_t set = H5Dopen2(file_, name_.c_str(), H5P_DEFAULT);
    bool any = false;
    while (H5Aget_num_attrs(set) > 0)
      any = H5Adelete_by_idx(set, ".", H5_INDEX_NAME, H5_ITER_INC, 0, H5P_DEFAULT) >= 0;
    H5Dclose(set);
    return any;
  }
  /// Writes shape and values anew, with the attributes unit and meaning that readers ask for.
  bool replace() {
    const hid_t old = H5Dopen2(file_, name_.c_str(), H5P_DEFAULT);
    const hid_t space = H5Screate_simple(static_cast<int>(shape_.size()), shape_.data(), nullptr);
    const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
    const std::string made = name_ + "~";
    if (count() > values_.size()) {
      const std::vector<hsize_t> piece(shape_.size(), 1);
      H5Pset_chunk(list, static_cast<int>(piece.size()), piece.data());
    }
    const hid_t set = H5Dcreate2(file_, made.c_str(), type_, space, H5P_DEFAULT, list, H5P_DEFAULT);
    EXPECT_GE(set, 0) << name_;
    if (!values_.empty() && count() <= values_.size())
      H5Dwrite(set, type_, H5S_ALL, H5S_ALL, H5P_DEFAULT, values_.data());
    for (const char* attribute : {"unit", "meaning"})
      if (H5Aexists(old, attribute) > 0) copy_attribute(old, set, attribute);
    H5Dclose(old);
    H5Dclose(set);
    H5Sclose(space);
    H5Pclose(list);
    H5Ldelete(file_, name_.c_str(), H5P_DEFAULT);
    H5Lmove(file_, made.c_str(), file_, name_.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    return true;
  }
  static void copy_attribute(hid_t from, hid_t to, const char* name) {
    const hid_t source = H5Aopen(from, name, H5P_DEFAULT), type = H5Aget_type(source),
                space = H5Aget_space(source);
    std::vector<char> value(H5Tget_size(type));
    H5Aread(source, type, value.data());
    const hid_t made = H5Acreate2(to, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(made, type, value.data());
    H5Aclose(source);
    H5Aclose(made);
    H5Tclose(type);
    H5Sclose(space);
  }
  hid_t file_, type_;
  std::string name_;
  std::vector<hsize_t> shape_;
  std::vector<char> values_;
};

/// Damages the dataset `name` of a file; false where this damage cannot be done to it.
inline bool damage_dataset(const std::string& path, const std::string& name, Damage damage,
                           std::uint64_t seed) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  bool done = false;
  {
    DamagedDataset set(file, name);
    done = set.apply(damage, seed);
  }
  H5Fclose(file);
  return done;
}

}  // namespace supple::testing
